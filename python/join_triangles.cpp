#include "python/join_triangles.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace displayfile::python {

namespace {

/// What overlaps by less, in a picture from 0 to 1, is not seen.
constexpr double kTolerance = 1e-9;
/// Polygons of more sides stay triangles.
constexpr std::uint32_t kMostSides = 32;

using Corners = std::span<const Point3>;

/// Whether the normal of one of the sides of `a` shows that they do not overlap.
bool a_side_separates(Corners a, Corners b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point3& p = a[i];
    const Point3& q = a[(i + 1) % a.size()];
    const double nx = p.y - q.y, ny = q.x - p.x;
    const double tolerance = kTolerance * std::hypot(nx, ny);
    const auto along = [&](const Point3& r) { return (r.x - p.x) * nx + (r.y - p.y) * ny; };
    const auto [a_low, a_high] = std::ranges::minmax(a, {}, along);
    const auto [b_low, b_high] = std::ranges::minmax(b, {}, along);
    if (along(a_high) <= along(b_low) + tolerance || along(b_high) <= along(a_low) + tolerance) {
      return true;
    }
  }
  return false;
}

bool overlap(Corners a, Corners b) { return !a_side_separates(a, b) && !a_side_separates(b, a); }

/// The pieces that lie in each cell of a grid over the picture, in their order.
class Cells {
 public:
  explicit Cells(const DrawnPieces& pieces)
      : side_(static_cast<std::size_t>(
            std::clamp(std::sqrt(static_cast<double>(pieces.size())), 1.0, 1024.0))),
        cells_(side_ * side_) {
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      visit(corners_of(pieces, k), [&](std::vector<std::uint32_t>& cell) {
        cell.push_back(static_cast<std::uint32_t>(k));
        return false;
      });
    }
  }

  static Corners corners_of(const DrawnPieces& pieces, std::size_t k) {
    return Corners(pieces.points).subspan(pieces.first[k], pieces.first[k + 1] - pieces.first[k]);
  }

  /// Whether a piece after `from` and before `to` overlaps piece `from`, but for those that have
  /// its pick.
  bool covered(const DrawnPieces& pieces, std::uint32_t from, std::uint32_t to) {
    const Corners corners = corners_of(pieces, from);
    return visit(corners, [&](const std::vector<std::uint32_t>& cell) {
      for (auto k = std::ranges::upper_bound(cell, from); k != cell.end() && *k < to; ++k) {
        if (pieces.picks[*k] != pieces.picks[from] && overlap(corners, corners_of(pieces, *k))) {
          return true;
        }
      }
      return false;
    });
  }

 private:
  std::size_t cell_of(double value) const {
    const double cells = static_cast<double>(side_);
    return static_cast<std::size_t>(std::clamp(value * cells, 0.0, cells - 1.0));
  }

  /// Until `enter` returns true, which is then returned.
  template <class Enter>
  bool visit(Corners corners, Enter&& enter) {
    const auto [x_low, x_high] = std::ranges::minmax(corners, {}, &Point3::x);
    const auto [y_low, y_high] = std::ranges::minmax(corners, {}, &Point3::y);
    for (std::size_t y = cell_of(y_low.y); y <= cell_of(y_high.y); ++y) {
      for (std::size_t x = cell_of(x_low.x); x <= cell_of(x_high.x); ++x) {
        if (enter(cells_[y * side_ + x])) return true;
      }
    }
    return false;
  }

  std::size_t side_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

/// Whether the pieces are the polygon's triangles, and do not overlap each other.
bool are_its_triangles(Corners polygon, const DrawnPieces& pieces,
                       std::span<const std::uint32_t> own) {
  if (own.size() != polygon.size() - 2) return false;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const Corners triangle = Cells::corners_of(pieces, own[i]);
    const auto is_corner = [&](const Point3& p) { return std::ranges::count(polygon, p) > 0; };
    if (triangle.size() != 3 || !std::ranges::all_of(triangle, is_corner)) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (overlap(triangle, Cells::corners_of(pieces, own[j]))) return false;
    }
  }
  return true;
}

}  // namespace

void join_triangles(std::span<const std::uint32_t> sides, std::span<const Point3> points,
                    DrawnPieces& pieces) {
  const std::size_t count = pieces.size();
  std::vector<std::vector<std::uint32_t>> own(sides.size());
  for (std::size_t k = 0; k < count; ++k) {
    const auto item = static_cast<std::size_t>(pieces.picks[k]);
    if (item < sides.size()) own[item].push_back(static_cast<std::uint32_t>(k));
  }
  enum class Fate : std::uint8_t { as_it_is, left_out, whole };
  std::vector<Fate> fates(count, Fate::as_it_is);
  std::vector<Corners> polygons(sides.size());
  Cells cells(pieces);
  std::size_t begin = 0;
  for (std::size_t item = 0; item < sides.size(); begin += sides[item++]) {
    polygons[item] = points.subspan(begin, sides[item]);
    if (own[item].size() < 2 || sides[item] > kMostSides) continue;
    if (!are_its_triangles(polygons[item], pieces, own[item])) continue;
    const std::uint32_t last = own[item].back();
    const auto is_covered = [&](std::uint32_t k) { return cells.covered(pieces, k, last); };
    if (std::ranges::any_of(own[item], is_covered)) continue;
    for (const std::uint32_t k : own[item]) fates[k] = Fate::left_out;
    fates[last] = Fate::whole;
  }

  DrawnPieces joined;
  for (std::size_t k = 0; k < count; ++k) {
    if (fates[k] == Fate::left_out) continue;
    const Corners corners = fates[k] == Fate::whole
                                ? polygons[static_cast<std::size_t>(pieces.picks[k])]
                                : Cells::corners_of(pieces, k);
    joined.points.insert(joined.points.end(), corners.begin(), corners.end());
    if (fates[k] == Fate::whole) {
      joined.sides.resize(joined.points.size(), 1);
    } else {
      const auto sides_of = std::span(pieces.sides).subspan(pieces.first[k], corners.size());
      joined.sides.insert(joined.sides.end(), sides_of.begin(), sides_of.end());
    }
    joined.first.push_back(static_cast<std::uint32_t>(joined.points.size()));
    joined.kinds.push_back(pieces.kinds[k]);
    joined.fills.push_back(pieces.fills[k]);
    joined.lines.push_back(pieces.lines[k]);
    joined.picks.push_back(pieces.picks[k]);
    joined.segments.push_back(pieces.segments[k]);
  }
  pieces = std::move(joined);
}

}  // namespace displayfile::python
