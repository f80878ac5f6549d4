#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "hidden/lines/ends_at_plane.h"
#include "hidden/lines/hidden_parts.h"
#include "hidden/lines/line_precision.h"
#include "hidden/lines/line_table.h"

namespace displayfile {

/// Compares one line with one polygon that may hide it: Roberts's cases, a hidden end, a hidden
/// middle, both, or none, separately for the left and the right of the line
/// (hidden/lines/roberts.md). Reuses its memory, so that nothing is allocated per polygon.
template <class Policy>
class LineAgainstPolygon {
 public:
  LineAgainstPolygon(const LineTable& scene, const Policy& policy)
      : scene_(scene), policy_(policy) {}

  void look_at(const LineTable::Line& line) {
    named_ = line;
    own_ = line.own;
    other_ = LineTable::kNone;
    if (line.by_plane) own_plane_ = scene_.plane(own_);
    line_ = {scene_.point(line.a), scene_.point(line.b), line.by_plane ? &own_plane_ : nullptr};
    near_ = {line_.a, line_.b, scene_.off_lines()};
    farthest_ = scene_.extent(line).z_min;
    if (const IntersectionLine* intersection = scene_.intersection(line)) look_at(*intersection);
  }

  const DepthLine& line() const { return line_; }
  /// True if a polygon's corner counts as on the line.
  bool is_near(const Point3& p) const { return near_.has(p); }
  /// True if the polygon's plane is nearer along the whole line, except possibly at one end.
  bool is_behind(std::uint32_t polygon) const {
    const Plane plane = scene_.plane(polygon);
    const auto [at_a, at_b] = nearer_at_ends(polygon, plane, {});
    return at_a >= 0 && at_b >= 0 && at_a + at_b > 0;
  }

  /// Adds the parts of the line that the polygon, which hides, covers, to HiddenParts or an
  /// equivalent; true if it covers both sides of a part. A polygon that is farther as a whole
  /// covers nothing, even if an end of the line is within reach of its plane.
  template <class Parts>
  bool hide(std::uint32_t polygon, Parts& parts) {
    assert(scene_.hides(polygon));
    if (polygon == own_ || polygon == other_) return false;
    if (scene_.extent(polygon).z_max <= farthest_ || !reaches_over(polygon)) return false;
    steps_.step();
    if constexpr (Policy::kIsExact) {
      if (is_beyond_ends(polygon)) return false;
    }
    const Plane plane = scene_.plane(polygon);
    const auto [nearer_at_a, nearer_at_b] =
        nearer_at_ends(polygon, plane, {a_is_corner_, b_is_corner_});
    if (nearer_at_a <= 0 && nearer_at_b <= 0) return false;
    find_crossings(polygon);
    PartOfLine part{0.0, 1.0};
    if (nearer_at_a < 0) part.from = meeting(plane);
    if (nearer_at_b < 0) part.to = meeting(plane);
    if (left_ == right_) {
      return add_covered(left_, part, [&](const PartOfLine& covered) { parts.add_both(covered); });
    }
    add_covered(left_, part, [&](const PartOfLine& covered) { parts.add_left(covered); });
    add_covered(right_, part, [&](const PartOfLine& covered) { parts.add_right(covered); });
    return false;
  }

 private:
  /// For an intersection line: neither of its polygons hides it.
  void look_at(const IntersectionLine& line) {
    own_ = line.item_a;
    other_ = line.item_b;
    const std::array planes{scene_.plane(own_), scene_.plane(other_)};
    common_.emplace(scene_.points(), planes, line.from, line.to);
    line_.common = &*common_;
    near_ = {};
  }

  /// Finds on which sides of the line the polygon's vertices are; false if it covers nothing along
  /// it because all are on one side, except for at most one on the line.
  bool reaches_over(std::uint32_t polygon) {
    const std::uint32_t sides = scene_.sides(polygon);
    side_.resize(sides);
    is_near_.assign(sides, 0);
    std::uint32_t left = 0, right = 0;
    a_is_corner_ = b_is_corner_ = false;
    for (std::uint32_t k = 0; k < sides; ++k) {
      const Point3& corner = scene_.corner(polygon, k);
      int side = policy_.side(line_, corner);
      if (side != 0 && near_.has(corner)) {
        is_near_[k] = 1;
        side = 0;
      }
      side_[k] = static_cast<std::int8_t>(side);
      if (side == 0) note_end(polygon, k);
      left += side > 0;
      right += side < 0;
    }
    return left + right + 1 < sides || (left > 0 && right > 0);
  }

  /// True only if the polygon covers nothing between the line's ends: all of it is before the start
  /// or all after the end, except for a corner there. Most polygons around an end in a mesh are so.
  bool is_beyond_ends(std::uint32_t polygon) const {
    constexpr double kSurely = 0x1p-20, kRounding = 0x1p-48;  // far more than is rounded
    constexpr double kLeast = 1e-290;                         // of a square
    if (line_.common != nullptr) return false;
    const Point2 a(line_.a), b(line_.b), way = b - a;
    const double length = glm::dot(way, way);
    if (!(length > kLeast)) return false;
    bool before = true, after = true;
    for (std::uint32_t k = 0; k < side_.size(); ++k) {
      const Point2 c(scene_.corner(polygon, k)), from_a = c - a;
      const double x = way.x * from_a.x, y = way.y * from_a.y;
      const double off = kSurely * length + kRounding * (std::abs(x) + std::abs(y));
      before = before && (x + y < -off || c == a);
      after = after && (x + y > length + off || c == b);
      if (!before && !after) return false;
    }
    return true;
  }

  /// The sign of the plane's depth less the line's, at the line's start and at its end.
  std::array<int, 2> nearer_at_ends(std::uint32_t polygon, const Plane& plane,
                                    const EndsAtCorners& corners) const {
    if (corners.start && corners.end) return {0, 0};
    const EndsAtPlane at = ends_at_plane(scene_, named_, polygon, plane, corners);
    const auto nearer = [&](bool is_corner, const std::optional<int>& as_entered, const Point3& v) {
      if (is_corner) return 0;
      return as_entered ? *as_entered : policy_.nearer(line_, v, plane);
    };
    return {nearer(corners.start, at.start, line_.a), nearer(corners.end, at.end, line_.b)};
  }

  /// The parameter where the line, whose ends are on different sides of the plane, meets it. Close
  /// to a plane rounding may have put both on one side: then the closer end.
  double meeting(const Plane& plane) const {
    const int at_a = policy_.nearer(line_, line_.a, plane);
    const int at_b = policy_.nearer(line_, line_.b, plane);
    if (at_a * at_b < 0) return policy_.meeting(line_, plane);
    const auto off = [&](const Point3& v) { return std::abs(plane_value(v, plane).value); };
    return off(line_.a) <= off(line_.b) ? 0.0 : 1.0;
  }

  /// Notes shared points, at which neighbours in a mesh have the same depth.
  void note_end(std::uint32_t polygon, std::uint32_t k) {
    if (line_.plane != nullptr || line_.common != nullptr) return;
    if (scene_.is_uneven_at(polygon, k)) return;
    a_is_corner_ |= scene_.corner(polygon, k) == line_.a;
    b_is_corner_ |= scene_.corner(polygon, k) == line_.b;
  }

  /// The crossings of the polygon's boundary with the lines infinitely close on the left and on the
  /// right, sorted. The polygon covers them between the first and second, third and fourth, and so
  /// on (even-odd). A side crosses the left one if exactly one of its ends is left of the line.
  void find_crossings(std::uint32_t polygon) {
    left_.clear();
    right_.clear();
    const std::uint32_t sides = scene_.sides(polygon);
    std::uint32_t k = sides - 1;
    for (std::uint32_t next = 0; next < sides; k = next++) {
      const bool on_left = (side_[k] > 0) != (side_[next] > 0);
      const bool on_right = (side_[k] < 0) != (side_[next] < 0);
      if (!on_left && !on_right) continue;
      const Point2 p(scene_.corner(polygon, k)), q(scene_.corner(polygon, next));
      const double t = side_[k] == 0      ? place(k, p)
                       : side_[next] == 0 ? place(next, q)
                                          : policy_.crossing(line_, p, q);
      if (on_left) left_.push_back(t);
      if (on_right) right_.push_back(t);
    }
    assert(left_.size() % 2 == 0 && right_.size() % 2 == 0);  // the boundary is closed
    if (left_.size() > 1) std::ranges::sort(left_);
    if (right_.size() > 1) std::ranges::sort(right_);
  }

  /// The parameter of a corner on the line.
  double place(std::uint32_t corner, const Point2& p) const {
    return is_near_[corner] != 0 ? near_.place(p) : policy_.at_point(line_, p);
  }

  template <class Add>
  static bool add_covered(const std::vector<double>& crossings, const PartOfLine& nearer,
                          const Add& add) {
    bool any = false;
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const PartOfLine part{std::max(crossings[k], nearer.from),
                            std::min(crossings[k + 1], nearer.to)};
      if (part.from >= part.to) continue;
      add(part);
      any = true;
    }
    return any;
  }

  const LineTable& scene_;
  const Policy& policy_;
  LineTable::Line named_{};
  DepthLine line_{};  // the same
  Plane own_plane_;
  std::optional<CommonLine> common_;
  std::uint32_t own_ = LineTable::kNone, other_ = LineTable::kNone;
  bool a_is_corner_ = false, b_is_corner_ = false;  // of the polygon, and in its plane
  NearLine near_;
  float farthest_ = 0.0f;
  std::vector<std::uint8_t> is_near_;  // corners that are not quite on the line
  std::vector<std::int8_t> side_;      // of the line, each vertex of the polygon
  std::vector<double> left_, right_;
  WorkSteps steps_;
};

}  // namespace displayfile
