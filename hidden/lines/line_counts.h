#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "hidden/convex_turning.h"
#include "hidden/lines/contour_edges.h"
#include "hidden/lines/line_against_polygon.h"
#include "hidden/lines/line_precision.h"
#include "hidden/lines/line_scene.h"

namespace displayfile {

/// Quantitative invisibility at a point of a line, or a change of it: how many polygons that are
/// counted are strictly nearer there and cover the points immediately left of the line, and how
/// many those right of it.
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
  /// As they are of the line that runs the other way.
  SideCounts reversed() const { return {right, left}; }
  bool operator==(const SideCounts&) const = default;
};

/// A change of the counts at a parameter of a line, the true one rounded once.
struct CountChange {
  double at;
  SideCounts by;
};

/// What polygons that are counted, and their sides, do to the counts of one line, whose depth is
/// its own ends' (hidden/lines/appel.md).
template <class Policy>
class LineCounts {
 public:
  LineCounts(const LineScene& scene, const ContourEdges& contours, const Policy& policy)
      : scene_(scene), contours_(contours), policy_(policy) {}

  void look_at(const Point3& a, const Point3& b) { line_ = {a, b, nullptr}; }

  /// The change where the line passes behind a side from p to q that has so many more polygons on
  /// its left than on its right: true if it does, between its ends.
  bool passes_behind(Point3 p, Point3 q, std::int32_t more_on_left, CountChange& change) const {
    const Point2 a(line_.a), b(line_.b);
    int at_p = policy_.turn(a, b, Point2(p)), at_q = policy_.turn(a, b, Point2(q));
    const bool on_left = (at_p > 0) != (at_q > 0), on_right = (at_p < 0) != (at_q < 0);
    if (!on_left && !on_right) return false;
    if (at_p < at_q) {  // seen along the line the side is to run from left to right
      std::swap(p, q);
      std::swap(at_p, at_q);
      more_on_left = -more_on_left;
    }
    const Point2 from(p), to(q);
    if (policy_.turn(from, to, a) >= 0 || policy_.turn(from, to, b) <= 0) return false;
    if (policy_.passes_over(line_, p, q) <= 0) return false;
    change.at = at_p == 0   ? policy_.at_point(line_, from)
                : at_q == 0 ? policy_.at_point(line_, to)
                            : policy_.crossing(line_, from, to);
    change.by = {on_left ? more_on_left : 0, on_right ? more_on_left : 0};
    return true;
  }

  /// What a polygon is of the counts immediately after the line's start, by comparison: 0 or 1.
  SideCounts after_start(std::uint32_t polygon) const {
    const Point2 a(line_.a);
    const SideCounts covered = coverage(
        polygon, [&](const Point2& p, const Point2& q) { return policy_.turn(p, q, a) >= 0; });
    return covered == SideCounts{} || !is_nearer(polygon, line_.a, line_.b) ? SideCounts{}
                                                                            : covered;
  }
  /// The same immediately before its end.
  SideCounts before_end(std::uint32_t polygon) const {
    const Point2 b(line_.b);
    const SideCounts covered = coverage(
        polygon, [&](const Point2& p, const Point2& q) { return policy_.turn(p, q, b) > 0; });
    return covered == SideCounts{} || !is_nearer(polygon, line_.b, line_.a) ? SideCounts{}
                                                                            : covered;
  }

  /// The same as after_start of a polygon that has a corner where the line starts.
  SideCounts after_corner(std::uint32_t polygon, std::uint32_t corner) const {
    const SideCounts covered = in_corner(polygon, corner);
    if (covered == SideCounts{}) return covered;
    const bool nearer = contours_.is_even(polygon)
                            ? policy_.nearer(line_, line_.b, scene_.plane(polygon)) > 0
                            : is_nearer(polygon, line_.a, line_.b);
    return nearer ? covered : SideCounts{};
  }

  /// Whether the polygon's plane is nearer at one end of the line and farther at the other.
  bool passes_through_plane(std::uint32_t polygon) const {
    const Plane plane = scene_.plane(polygon);
    const int at_a = policy_.nearer(line_, line_.a, plane);
    return at_a != 0 && policy_.nearer(line_, line_.b, plane) == -at_a;
  }

  /// Adds what is wrong in the changes where the line passes behind the polygon's sides, and in the
  /// count at its start, by comparison of `depths`, the line with a depth that may be another.
  /// Returns what is wrong in the count at the line's end.
  SideCounts correct(std::uint32_t polygon, LineAgainstPolygon<Policy>& depths,
                     std::vector<CountChange>& changes) const {
    const SideCounts start = after_start(polygon);
    SideCounts end = before_end(polygon) - start;
    if (start != SideCounts{}) changes.push_back({0.0, SideCounts{} - start});
    const std::uint32_t sides = scene_.sides(polygon);
    std::uint32_t k = sides - 1;
    for (std::uint32_t next = 0; next < sides; k = next++) {
      CountChange change{};
      if (!passes_behind(scene_.corner(polygon, k), scene_.corner(polygon, next),
                         contours_.way(polygon), change)) {
        continue;
      }
      end -= change.by;
      changes.push_back({change.at, SideCounts{} - change.by});
    }
    AsChanges covered{changes};
    depths.hide(polygon, covered);
    return end;
  }

 private:
  /// Takes covered parts as changes of the counts.
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

  /// Whether the polygon covers, left and right, the place that a line through it reaches after it
  /// crossed those sides for which crossed_before(p, q) is true; p is left of q as seen along it.
  template <class CrossedBefore>
  SideCounts coverage(std::uint32_t polygon, const CrossedBefore& crossed_before) const {
    const Point2 a(line_.a), b(line_.b);
    const std::uint32_t sides = scene_.sides(polygon);
    SideCounts covered;
    Point2 p(scene_.corner(polygon, sides - 1));
    int at_p = policy_.turn(a, b, p);
    for (std::uint32_t k = 0; k < sides; ++k) {
      const Point2 q(scene_.corner(polygon, k));
      const int at_q = policy_.turn(a, b, q);
      const bool on_left = (at_p > 0) != (at_q > 0), on_right = (at_p < 0) != (at_q < 0);
      if ((on_left || on_right) && (at_p > at_q ? crossed_before(p, q) : crossed_before(q, p))) {
        covered.left ^= on_left ? 1 : 0;
        covered.right ^= on_right ? 1 : 0;
      }
      p = q;
      at_p = at_q;
    }
    return covered;
  }

  /// Whether the polygon's plane is nearer where the line leaves one of its ends for the other.
  bool is_nearer(std::uint32_t polygon, const Point3& from, const Point3& toward) const {
    const Plane plane = scene_.plane(polygon);
    const int nearer = policy_.nearer(line_, from, plane);
    return nearer != 0 ? nearer > 0 : policy_.nearer(line_, toward, plane) > 0;
  }

  /// Whether the polygon's corner, at the line's start, has the line's left and right in it.
  SideCounts in_corner(std::uint32_t polygon, std::uint32_t corner) const {
    const std::uint32_t sides = scene_.sides(polygon);
    std::uint32_t before = corner == 0 ? sides - 1 : corner - 1;
    std::uint32_t after = corner + 1 < sides ? corner + 1 : 0;
    if (contours_.way(polygon) < 0) std::swap(before, after);
    const Point2 at(line_.a), along(line_.b);
    // The corner's inside is passed through counterclockwise from p to q.
    const Point2 p(scene_.corner(polygon, after)), q(scene_.corner(polygon, before));
    const int from_p = policy_.turn(at, p, along), from_q = policy_.turn(at, q, along);
    if (from_p == 0 && direction_by_x(at, p) == direction_by_x(at, along)) return {1, 0};
    if (from_q == 0 && direction_by_x(at, q) == direction_by_x(at, along)) return {0, 1};
    const int opening = policy_.turn(at, p, q);
    const bool inside = opening < 0 ? from_p > 0 || from_q < 0 : from_p > 0 && from_q < 0;
    return inside ? SideCounts{1, 1} : SideCounts{};
  }

  const LineScene& scene_;
  const ContourEdges& contours_;
  const Policy& policy_;
  DepthLine line_{};
};

}  // namespace displayfile
