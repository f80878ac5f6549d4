#include "programs/sheet/round_outlines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

namespace displayfile {

namespace {

constexpr double kSteepest = 15.0 * std::numbers::pi / 180.0, kStraightest = 1e-4;  // turns
constexpr std::size_t kFewestSides = 4;

double length_of_side(std::span<const Point2> points, std::size_t k) {
  return glm::distance(points[k], points[k + 1]);
}

/// Counterclockwise, in radians, at the end of side k.
double turn_after(std::span<const Point2> points, std::size_t k) {
  const Point2 a = points[k + 1] - points[k], b = points[k + 2] - points[k + 1];
  return std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
}

/// Equal up to the rounding of coordinates.
bool equal(double a, double b, double unit) {
  constexpr double kParts = 1e-3, kLength = 2e-4;  // mm
  return std::abs(a - b) <= kParts * std::abs(a) + kLength / unit;
}

/// The sides from `first` on that are alike, as facets are: where the last of them ends.
std::size_t end_of_facets(std::span<const Point2> points, std::size_t first) {
  const std::size_t sides = points.size() - 1;
  if (first + 1 >= sides) return first;
  const double length = length_of_side(points, first), turn = turn_after(points, first);
  if (std::abs(turn) > kSteepest + 1e-6 || std::abs(turn) < kStraightest) return first;
  std::size_t last = first;
  while (last + 1 < sides && equal(length, length_of_side(points, last + 1), 1.0) &&
         equal(turn, turn_after(points, last), length)) {
    ++last;
  }
  return last + 1;
}

std::optional<OutlineArc> circle_through(const Point2& a, const Point2& b, const Point2& c) {
  const Point2 u = b - a, v = c - a;
  const double twice = 2.0 * (u.x * v.y - u.y * v.x);
  if (twice == 0.0) return std::nullopt;
  const double uu = glm::dot(u, u), vv = glm::dot(v, v);
  const Point2 to_centre(Point2(v.y * uu - u.y * vv, u.x * vv - v.x * uu) / twice);
  return OutlineArc{a + to_centre, glm::length(to_centre)};
}

/// The circle that the vertices are on, by three that are far apart.
std::optional<OutlineArc> circle_of(std::span<const Point2> vertices) {
  const std::size_t n = vertices.size();
  const bool whole = vertices.front() == vertices.back();
  const auto circle = whole ? circle_through(vertices[0], vertices[n / 3], vertices[2 * n / 3])
                            : circle_through(vertices[0], vertices[n / 2], vertices[n - 1]);
  const auto is_near = [&](const Point2& p) {
    return std::abs(glm::distance(p, circle->centre) - circle->radius) <= kRoundTolerance;
  };
  if (!circle || !std::ranges::all_of(vertices, is_near)) return std::nullopt;
  return circle;
}

double degrees(const Point2& direction) {
  return std::atan2(direction.y, direction.x) * 180.0 / std::numbers::pi;
}

/// The arc of facets; nothing if their vertices are on no circle.
std::optional<OutlineArc> arc_of(std::span<const Point2> vertices) {
  auto arc = circle_of(vertices);
  if (!arc) return std::nullopt;
  arc->whole = vertices.front() == vertices.back();
  if (arc->whole) return arc;
  arc->from = degrees(vertices.front() - arc->centre);
  arc->to = degrees(vertices.back() - arc->centre);
  if (turn_after(vertices, 0) < 0.0) std::swap(arc->from, arc->to);
  return arc;
}

/// A closed outline, opened where no facets continue, unless they go all round.
std::vector<Point2> opened(const std::vector<Point2>& points) {
  std::vector<Point2> round = points;
  round.push_back(points.front());
  const std::size_t end = end_of_facets(round, 0);
  round.pop_back();
  const std::size_t start = end == 0 ? 1 : end % points.size();
  std::rotate(round.begin(), round.begin() + static_cast<std::ptrdiff_t>(start), round.end());
  round.push_back(round.front());
  return round;
}

}  // namespace

std::vector<OutlinePiece> round_pieces(const std::vector<Point2>& points, bool closed) {
  const std::vector<Point2> open = closed ? opened(points) : points;
  std::vector<OutlinePiece> pieces;
  std::vector<Point2> straight{open.front()};
  const auto end_straight = [&] {
    if (straight.size() > 1) pieces.push_back({straight, false});
    straight.clear();
  };
  for (std::size_t k = 0; k + 1 < open.size();) {
    const std::size_t end = std::max(end_of_facets(open, k), k + 1);
    const auto facets = std::span(open).subspan(k, end - k + 1);
    const auto arc = end >= k + kFewestSides ? arc_of(facets) : std::nullopt;
    if (!arc) {
      // Facets of another kind may begin with the last of these.
      for (const std::size_t last = std::max(end - 1, k + 1); k < last;) {
        straight.push_back(open[++k]);
      }
      continue;
    }
    end_straight();
    pieces.push_back({{facets.begin(), facets.end()}, false, arc});
    k = end;
    straight = {open[k]};
  }
  const bool has_arcs =
      std::ranges::any_of(pieces, [](const OutlinePiece& piece) { return piece.arc.has_value(); });
  if (!has_arcs) return {{points, closed}};
  end_straight();
  return pieces;
}

}  // namespace displayfile
