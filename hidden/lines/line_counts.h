#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "clip/geometry/corners.h"
#include "hidden/lines/contour_edges.h"
#include "hidden/lines/ends_at_plane.h"
#include "hidden/lines/far_planes.h"
#include "hidden/lines/line_against_polygon.h"
#include "hidden/lines/line_precision.h"
#include "hidden/lines/line_table.h"
#include "hidden/triangles/convex_turning.h"

namespace displayfile {

/// Quantitative invisibility at a point of a line, or a change of it: the number of counted
/// polygons that are strictly nearer there and cover the points immediately left of the line, and
/// immediately right of it.
struct SideCounts {
  std::int32_t left = 0, right = 0;

  SideCounts& operator+=(const SideCounts& o) {
    left += o.left;
    right += o.right;
    return *this;
  }
  SideCounts& operator-=(const SideCounts& o) {
    left -= o.left;
    right -= o.right;
    return *this;
  }
  friend SideCounts operator+(SideCounts a, const SideCounts& b) { return a += b; }
  friend SideCounts operator-(SideCounts a, const SideCounts& b) { return a -= b; }
  /// The counts of the reversed line.
  SideCounts reversed() const { return {right, left}; }
  bool operator==(const SideCounts&) const = default;
};

/// A change of the counts at a parameter of a line, rounded once.
struct CountChange {
  double at;
  SideCounts by;
};

/// The effect of counted polygons and their sides on the counts of one line, which has the depth of
/// its own ends (hidden/lines/appel.md).
template <class Policy>
class LineCounts {
 public:
  LineCounts(const LineTable& scene, const ContourEdges& contours, const FarPlanes& far_planes,
             const Policy& policy)
      : scene_(scene), contours_(contours), far_planes_(far_planes), policy_(policy) {}

  void look_at(const Point3& a, const Point3& b) {
    line_ = {a, b, nullptr};
    near_ = {a, b, scene_.off_lines()};
  }

  /// The change where the line passes behind a side from p to q with this many more polygons on its
  /// left than on its right: true if it does, between its ends.
  bool passes_behind(const Point3& p, const Point3& q, std::int32_t more_on_left,
                     CountChange& change) const {
    Crossing at{};
    return find_crossing(p, turn(p), q, turn(q), at) && !is_before_start(at) && is_before_end(at) &&
           passes_behind(at, more_on_left, change);
  }

  /// True if the point is not on the line but counts as on it in comparisons with polygons
  /// (hidden/lines/near_line.h).
  bool is_taken_for_on_line(const Point3& p) const { return near_.has(p) && turn(p) != 0; }

  bool has_corner_taken_for_on_line(std::uint32_t polygon) const {
    for (std::uint32_t k = 0; k < scene_.sides(polygon); ++k) {
      if (is_taken_for_on_line(scene_.corner(polygon, k))) return true;
    }
    return false;
  }

  /// True if the line is a side of the polygon, which is then not counted along it.
  bool is_side_of(std::uint32_t polygon) const {
    const std::uint32_t sides = scene_.sides(polygon);
    const Point3* p = &scene_.corner(polygon, sides - 1);
    for (std::uint32_t k = 0; k < sides; ++k) {
      const Point3& q = scene_.corner(polygon, k);
      if ((*p == line_.a && q == line_.b) || (*p == line_.b && q == line_.a)) return true;
      p = &q;
    }
    return false;
  }

  /// A polygon's contribution to the counts immediately after the line's start, by comparison: 0 or
  /// 1.
  SideCounts after_start(std::uint32_t polygon) const {
    SideCounts covered;
    if (is_side_of(polygon)) return covered;
    for_each_crossing(polygon, [&](const Crossing& at) {
      if (is_before_start(at)) cross(at, covered);
    });
    if (covered == SideCounts{}) return covered;
    const Plane plane = scene_.plane(polygon);
    const int nearer = policy_.nearer(line_, line_.a, plane);
    const bool is_nearer = nearer != 0 ? nearer > 0 : policy_.nearer(line_, line_.b, plane) > 0;
    return is_nearer ? covered : SideCounts{};
  }

  /// The same as after_start, for a polygon with a corner at the line's start.
  SideCounts after_corner(std::uint32_t polygon, std::uint32_t corner) const {
    const SideCounts covered = in_corner(polygon, corner);
    if (covered == SideCounts{} || is_side_of(polygon)) return {};
    const Plane plane = scene_.plane(polygon);
    const int at_a = contours_.is_even(polygon) ? 0 : policy_.nearer(line_, line_.a, plane);
    const int nearer = at_a != 0 ? at_a : policy_.nearer(line_, line_.b, plane);
    return nearer > 0 ? covered : SideCounts{};
  }

  /// True if the polygon may cover anything immediately beside the line: not if all its corners are
  /// on one side of it, or all but one, which is on it.
  bool reaches_over(std::uint32_t polygon) const {
    const Point2 a(line_.a), b(line_.b);
    const std::uint32_t sides = scene_.sides(polygon);
    std::uint32_t left = 0, right = 0;
    for (std::uint32_t k = 0; k < sides; ++k) {
      const int turn = policy_.turn(a, b, Point2(scene_.corner(polygon, k)));
      left += turn > 0;
      right += turn < 0;
      if (left > 0 && right > 0) return true;
    }
    return left + right + 1 < sides;
  }

  /// True if the count of an even polygon may be wrong for this line: its plane passes between the
  /// line's ends, or rounding has put an end on the wrong side of it. At a corner they have the
  /// same depth.
  bool is_doubtful(const LineTable::Line& line, std::uint32_t polygon,
                   const EndsAtCorners& corners) const {
    const bool may_touch = scene_.touching() > 0.0;
    const bool is_at_corner = corners.start || corners.end;
    const bool is_side = corners.start && corners.end;
    const bool shares = line.own != LineTable::kNone && scene_.share_plane(line.own, polygon);
    if ((is_side && !shares) || (is_at_corner && !may_touch)) return false;
    if (is_at_corner && !shares && far_planes_.is_far(polygon, corners.start ? line_.b : line_.a)) {
      return false;
    }
    const Plane plane = scene_.plane(polygon);
    if (may_touch) {
      const EndsAtPlane at = ends_at_plane(scene_, line, polygon, plane, corners);
      if (at.start && *at.start != policy_.nearer(line_, line_.a, plane)) return true;
      if (at.end && *at.end != policy_.nearer(line_, line_.b, plane)) return true;
    }
    if (is_at_corner) return false;
    const int at_a = policy_.nearer(line_, line_.a, plane);
    return at_a != 0 && policy_.nearer(line_, line_.b, plane) == -at_a;
  }

  /// Adds corrections to the changes where the line passes behind the polygon's sides, and to the
  /// count at its start, by comparison of `depths`, the line with a possibly different depth.
  /// Returns the correction of the count at the line's end.
  SideCounts correct(std::uint32_t polygon, LineAgainstPolygon<Policy>& depths,
                     std::vector<CountChange>& changes) const {
    SideCounts start, end, passed;
    bool crosses = false;  // between the line's ends
    for_each_crossing(polygon, [&](const Crossing& at) {
      const bool before_start = is_before_start(at), before_end = is_before_end(at);
      if (before_start) cross(at, start);
      if (before_end) cross(at, end);
      if (before_start || !before_end) return;
      crosses = true;
      CountChange change{};
      if (passes_behind(at, contours_.way(polygon), change)) {
        passed += change.by;
        changes.push_back({change.at, SideCounts{} - change.by});
      }
    });
    // In a mesh most polygons that meet the extended line do not meet the line.
    if (!crosses && start == SideCounts{} && end == SideCounts{}) return {};
    const Plane plane = scene_.plane(polygon);
    const int at_a = policy_.nearer(line_, line_.a, plane);
    const int at_b = policy_.nearer(line_, line_.b, plane);
    if ((at_a != 0 ? at_a : at_b) <= 0) start = {};
    if ((at_b != 0 ? at_b : at_a) <= 0) end = {};
    if (start != SideCounts{}) changes.push_back({0.0, SideCounts{} - start});
    compare(polygon, depths, changes);
    return end - start - passed;
  }

  /// Adds the changes due to an uncounted polygon, by comparison of `depths`.
  static void compare(std::uint32_t polygon, LineAgainstPolygon<Policy>& depths,
                      std::vector<CountChange>& changes) {
    AsChanges covered{changes};
    depths.hide(polygon, covered);
  }

 private:
  /// Converts covered parts to changes of the counts.
  struct AsChanges {
    std::vector<CountChange>& changes;

    void add(const PartOfLine& part, const SideCounts& by) {
      changes.push_back({part.from, by});
      changes.push_back({part.to, SideCounts{} - by});
    }
    void add_both(const PartOfLine& part) { add(part, {1, 1}); }
    void add_left(const PartOfLine& part) { add(part, {1, 0}); }
    void add_right(const PartOfLine& part) { add(part, {0, 1}); }
  };

  /// A side of a polygon that crosses the line infinitely close on the left, on the right, or both:
  /// oriented from left to right of the line.
  struct Crossing {
    Point2 p, q;
    const Point3 *from, *to;
    int at_p, at_q;  // the sides of the line on which p and q are
    bool on_left, on_right;
    bool turned;  // the side itself runs from right to left
  };

  int turn(const Point3& p) const {
    return policy_.turn(Point2(line_.a), Point2(line_.b), Point2(p));
  }

  static bool find_crossing(const Point3& p, int at_p, const Point3& q, int at_q, Crossing& at) {
    at.on_left = (at_p > 0) != (at_q > 0);
    at.on_right = (at_p < 0) != (at_q < 0);
    if (!at.on_left && !at.on_right) return false;
    at.turned = at_p < at_q;
    at.from = at.turned ? &q : &p;
    at.to = at.turned ? &p : &q;
    at.at_p = at.turned ? at_q : at_p;
    at.at_q = at.turned ? at_p : at_q;
    at.p = Point2(*at.from);
    at.q = Point2(*at.to);
    return true;
  }

  template <class Visit>
  void for_each_crossing(std::uint32_t polygon, const Visit& visit) const {
    const std::uint32_t sides = scene_.sides(polygon);
    std::uint32_t k = sides - 1;
    int at_k = turn(scene_.corner(polygon, k));
    for (std::uint32_t next = 0; next < sides; k = next++) {
      const int at_next = turn(scene_.corner(polygon, next));
      Crossing at{};
      if (find_crossing(scene_.corner(polygon, k), at_k, scene_.corner(polygon, next), at_next,
                        at)) {
        visit(at);
      }
      at_k = at_next;
    }
  }

  /// True if the crossing is at or before the line's start; and if it is before its end. Points of
  /// the line are first on the right of the crossing side, then on its left.
  bool is_before_start(const Crossing& at) const {
    return policy_.turn(at.p, at.q, Point2(line_.a)) >= 0;
  }
  bool is_before_end(const Crossing& at) const {
    return policy_.turn(at.p, at.q, Point2(line_.b)) > 0;
  }

  static void cross(const Crossing& at, SideCounts& covered) {  // even-odd
    covered.left ^= at.on_left ? 1 : 0;
    covered.right ^= at.on_right ? 1 : 0;
  }

  bool passes_behind(const Crossing& at, std::int32_t more_on_left, CountChange& change) const {
    if (policy_.passes_over(line_, *at.from, *at.to) <= 0) return false;
    change.at = at.at_p == 0   ? policy_.at_point(line_, at.p)
                : at.at_q == 0 ? policy_.at_point(line_, at.q)
                               : policy_.crossing(line_, at.p, at.q);
    const std::int32_t more = at.turned ? -more_on_left : more_on_left;
    change.by = {at.on_left ? more : 0, at.on_right ? more : 0};
    return true;
  }

  /// Tests if the polygon's corner at the line's start contains the points immediately left and
  /// right of the line.
  SideCounts in_corner(std::uint32_t polygon, std::uint32_t corner) const {
    const std::uint32_t sides = scene_.sides(polygon);
    std::uint32_t before = previous_corner(corner, sides);
    std::uint32_t after = next_corner(corner, sides);
    if (contours_.way(polygon) < 0) std::swap(before, after);
    const Point2 at(line_.a), along(line_.b);
    // The corner's inside runs counterclockwise from p to q.
    const Point2 p(scene_.corner(polygon, after)), q(scene_.corner(polygon, before));
    const int from_p = policy_.turn(at, p, along), from_q = policy_.turn(at, q, along);
    if (from_p == 0 && direction_by_x(at, p) == direction_by_x(at, along)) return {1, 0};
    if (from_q == 0 && direction_by_x(at, q) == direction_by_x(at, along)) return {0, 1};
    const int opening = policy_.turn(at, p, q);
    const bool inside = opening < 0 ? from_p > 0 || from_q < 0 : from_p > 0 && from_q < 0;
    return inside ? SideCounts{1, 1} : SideCounts{};
  }

  const LineTable& scene_;
  const ContourEdges& contours_;
  const FarPlanes& far_planes_;
  const Policy& policy_;
  NearLine near_;
  DepthLine line_{};
};

}  // namespace displayfile
