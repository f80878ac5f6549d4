#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "tests/polygon_sides.h"
#include "tests/predicate_truth.h"
#include "tests/sort_scenes.h"

// The judge of the object-space sorts. Depths are rationals, straight from the definition of
// truth; it shares no code with the sorts. Which polygon covers a sample point is a matter of
// doubles, because no sample is near a side.

namespace displayfile::test {

inline QPoint rational(const Point3& p) { return {Q(p.x), Q(p.y), Q(p.z)}; }

/// The plane that the definition gives a polygon, if it covers anything.
inline std::optional<QPlane> plane_by_definition(std::span<const Point3> v) {
  if (v.size() < 3) return std::nullopt;
  const auto for_q = [&](std::size_t i) {
    const double x = v[i].x - v[0].x, y = v[i].y - v[0].y;
    return x * x + y * y;
  };
  std::size_t q = 1, r = 2;
  const auto for_r = [&](std::size_t i) {
    return std::abs((v[q].x - v[0].x) * (v[i].y - v[0].y) - (v[q].y - v[0].y) * (v[i].x - v[0].x));
  };
  if (v.size() > 3) {
    q = r = 0;
    for (std::size_t i = 1; i < v.size(); ++i) {
      if (for_q(i) > for_q(q)) q = i;
    }
    for (std::size_t i = 1; i < v.size(); ++i) {
      if (for_r(i) > for_r(r)) r = i;
    }
  }
  if (for_r(r) == 0.0) return std::nullopt;
  const QPlane plane(rational(v[0]), rational(v[q]), rational(v[r]));
  if (plane.c == 0) return std::nullopt;
  return plane;
}

/// Twice the signed area of the projection.
inline Q twice_area(std::span<const QPoint> loop) {
  Q sum = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const QPoint &a = loop[k], &b = loop[(k + 1) % loop.size()];
    sum += a.x * b.y - b.x * a.y;
  }
  return sum;
}
inline Q twice_area(std::span<const Point3> loop) {
  std::vector<QPoint> points;
  for (const Point3& p : loop) points.push_back(rational(p));
  return twice_area(points);
}

/// A point of the projection.
using Sample = Point2;
inline Sample any_sample(Source& s) {
  const double x = s.unit(), y = s.unit();
  return {1.1 * x - 0.05, 1.1 * y - 0.05};
}

/// A piece with its points, as it is drawn.
struct DrawnPiece {
  std::uint32_t item;
  bool whole;
  Loop points;
  std::vector<std::uint8_t> visible;
};
inline std::vector<DrawnPiece> drawn_pieces(const ItemList& list, const SortedPieces& sorted) {
  std::vector<DrawnPiece> drawn;
  for (const SortedPiece& piece : sorted.pieces) {
    const bool whole = piece.first == SortedPiece::kWhole;
    const auto points = whole ? list.points_of(piece.item)
                              : std::span(sorted.points).subspan(piece.first, piece.sides);
    const auto visible = whole ? list.visible_of(piece.item)
                               : std::span(sorted.visible).subspan(piece.first, piece.sides);
    drawn.push_back(
        {piece.item, whole, {points.begin(), points.end()}, {visible.begin(), visible.end()}});
  }
  return drawn;
}

/// Each judgement returns a description of the error, or nothing.
class SortJudge {
 public:
  SortJudge(const ItemList& list, const SortedPieces& sorted)
      : list_(list), drawn_(drawn_pieces(list, sorted)), planes_(list.items.size()) {
    for (std::size_t i = 0; i < list.items.size(); ++i) {
      if (list.items[i].kind != ItemList::Kind::line) {
        planes_[i] = plane_by_definition(list.points_of(i));
      }
    }
  }

  const std::vector<DrawnPiece>& drawn() const { return drawn_; }

  /// Every item is there, once if whole, and its pieces are of its kind.
  std::string items() const {
    std::vector<int> whole(list_.items.size()), cut(list_.items.size());
    for (const DrawnPiece& piece : drawn_) {
      if (piece.item >= list_.items.size()) return "a piece of no item";
      ++(piece.whole ? whole : cut)[piece.item];
      const auto kind = list_.items[piece.item].kind;
      if (!piece.whole && kind == ItemList::Kind::line && piece.points.size() != 2) {
        return of(piece.item, "a piece of a line that is no line");
      }
      if (!piece.whole && planes_[piece.item] && piece.points.size() < 3) {
        return of(piece.item, "a piece of a polygon that is none");
      }
    }
    for (std::uint32_t i = 0; i < whole.size(); ++i) {
      if (whole[i] + cut[i] == 0) return of(i, "lost");
      if (whole[i] > 1 || (whole[i] == 1 && cut[i] > 0)) return of(i, "drawn twice");
    }
    return "";
  }

  /// Judges the order at a sample point, and that one piece of each item that covers it does.
  std::string order_at(const Sample& at, double nearest_side = 1e-9) const {
    if (is_near_a_side(at, nearest_side)) return "";
    struct Covering {
      std::uint32_t item;
      Q z;
    };
    std::vector<Covering> truth;
    for (std::uint32_t i = 0; i < list_.items.size(); ++i) {
      if (planes_[i] && covers(list_.points_of(i), at)) {
        truth.push_back({i, planes_[i]->z(Q(at.x), Q(at.y))});
      }
    }
    std::ranges::stable_sort(truth, [](const Covering& a, const Covering& b) { return a.z < b.z; });
    std::vector<std::uint32_t> found;
    for (const DrawnPiece& piece : drawn_) {
      if (planes_[piece.item] && covers(piece.points, at)) found.push_back(piece.item);
    }
    // Hollow ones hide nothing, and their insides are not drawn: their order among the others
    // matters only at their outlines.
    const auto keep_solid = [&](std::vector<std::uint32_t> all) {
      std::erase_if(all, [&](std::uint32_t i) { return !is_solid(i); });
      return all;
    };
    std::vector<std::uint32_t> expected;
    for (const Covering& c : truth) expected.push_back(c.item);
    auto found_set = found, expected_set = expected;
    std::ranges::sort(found_set);
    std::ranges::sort(expected_set);
    if (found_set == expected_set && keep_solid(found) == keep_solid(expected)) return "";
    std::ostringstream out;
    out << std::hexfloat << "at (" << at.x << ", " << at.y << ") drawn are";
    for (const std::uint32_t i : found) out << " " << i;
    out << ", expected";
    for (const std::uint32_t i : expected) out << " " << i;
    return out.str();
  }

  /// A line is drawn after polygons that are not nearer than it and before those that are; likewise
  /// the drawn sides of polygons, except for equal depths. `t` is the parameter of the point judged
  /// on each.
  std::string lines_at(double t) const {
    for (std::size_t k = 0; k < drawn_.size(); ++k) {
      const DrawnPiece& piece = drawn_[k];
      for (std::size_t i = 0; i < piece.points.size(); ++i) {
        if (piece.visible[i] == 0) continue;
        const Point3& b = piece.points[i];
        const Point3& a = piece.points[(i + piece.points.size() - 1) % piece.points.size()];
        const std::string wrong = line_at(k, a, b, t);
        if (!wrong.empty()) return wrong;
      }
    }
    return "";
  }

  /// The sides that are drawn are those of the items: no more, no less.
  std::string outlines(double tolerance = 1e-9) const {
    std::vector<double> length(list_.items.size());
    const auto drawn_length = [](std::span<const Point3> p, std::span<const std::uint8_t> visible) {
      double sum = 0.0;
      for (std::size_t i = 0; i < p.size(); ++i) {
        const Point3& from = p[(i + p.size() - 1) % p.size()];
        if (visible[i] != 0) sum += std::hypot(p[i].x - from.x, p[i].y - from.y);
      }
      return sum;
    };
    for (std::size_t i = 0; i < length.size(); ++i) {
      length[i] -= drawn_length(list_.points_of(i), list_.visible_of(i));
    }
    for (const DrawnPiece& piece : drawn_) {
      length[piece.item] += drawn_length(piece.points, piece.visible);
    }
    for (std::uint32_t i = 0; i < length.size(); ++i) {
      if (std::abs(length[i]) > tolerance) {
        return of(i, "drawn sides differ by " + std::to_string(length[i]));
      }
    }
    return "";
  }

  /// Pieces' signed areas sum to their polygon's; with tolerance 0, exactly.
  std::string areas(double tolerance) const {
    std::vector<Q> area(list_.items.size());
    for (const DrawnPiece& piece : drawn_) {
      if (planes_[piece.item]) area[piece.item] += twice_area(piece.points);
    }
    for (std::uint32_t i = 0; i < area.size(); ++i) {
      if (!planes_[i]) continue;
      const Q off = area[i] - twice_area(list_.points_of(i));
      if (abs(off) > Q(tolerance)) return of(i, "area differs by " + std::to_string(off.get_d()));
    }
    return "";
  }

 private:
  static std::string of(std::uint32_t item, const std::string& what) {
    return "item " + std::to_string(item) + ": " + what;
  }
  bool is_solid(std::uint32_t item) const {
    return list_.items[item].kind == ItemList::Kind::solid;
  }

  bool is_near_a_side(const Sample& at, double near) const {
    return std::ranges::any_of(drawn_, [&](const DrawnPiece& piece) {
      return test::is_near_a_side(piece.points, at, near);
    });
  }

  /// The drawn side from a to b of piece k.
  std::string line_at(std::size_t k, const Point3& a, const Point3& b, double t) const {
    constexpr double kNear = 1e-6, kBeside = 1e-7, kOn = 1e-12;
    const DrawnPiece& piece = drawn_[k];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length < 1e-3) return "";
    const Point3 at = a + t * (b - a);
    const Point2 across = {kBeside * (a.y - b.y) / length, kBeside * (b.x - a.x) / length};
    const Sample here = {at.x, at.y}, left = here + across, right = here - across;
    const bool own_line = !planes_[piece.item];
    const Q depth = depth_of(piece.item, at);
    for (std::size_t m = 0; m < drawn_.size(); ++m) {
      const DrawnPiece& other = drawn_[m];
      if (other.item == piece.item || !is_solid(other.item) || !planes_[other.item]) continue;
      bool unclear = false;
      for (std::size_t i = 0; i < other.points.size() && !unclear; ++i) {
        const Point3 &c = other.points[i], &d = other.points[(i + 1) % other.points.size()];
        if (distance_to_side(here, c, d) > kNear) continue;
        // A side along the line is not a coincidence: polygons beside it must be drawn in the right
        // order.
        const bool along = own_line && distance_to_side(here, c, d) < kOn &&
                           distance_to_side({a.x, a.y}, c, d) < kOn &&
                           distance_to_side({b.x, b.y}, c, d) < kOn;
        unclear = !along;
      }
      if (unclear) continue;
      const bool covers_left = covers(other.points, left),
                 covers_right = covers(other.points, right);
      if (!covers_left && !covers_right) continue;
      const Q other_depth = planes_[other.item]->z(Q(at.x), Q(at.y));
      // The point is rounded, and so is a line's depth there: equal depths up to rounding are truly
      // equal only if they are so along the whole line.
      if (abs(other_depth - depth) < Q(1e-12)) {
        if (!own_line || !is_on_plane(piece.item, *planes_[other.item])) continue;
        if (m > k) return at_line(k, m, t);
        continue;
      }
      if ((other_depth > depth) != (m > k)) return at_line(k, m, t);
    }
    return "";
  }
  std::string at_line(std::size_t k, std::size_t m, double t) const {
    std::ostringstream out;
    out << "piece " << k << " of item " << drawn_[k].item << " is out of order with piece " << m
        << " of item " << drawn_[m].item << " at " << t << " of a side";
    return out.str();
  }

  Q depth_of(std::uint32_t item, const Point3& at) const {
    if (planes_[item]) return planes_[item]->z(Q(at.x), Q(at.y));
    return Q(at.z);
  }
  /// True if a line's own two points are on the plane.
  bool is_on_plane(std::uint32_t item, const QPlane& plane) const {
    for (const Point3& p : list_.points_of(item)) {
      if (plane.at(rational(p)) != 0) return false;
    }
    return true;
  }

  const ItemList& list_;
  std::vector<DrawnPiece> drawn_;
  std::vector<std::optional<QPlane>> planes_;
};

}  // namespace displayfile::test
