#pragma once

#include "hidden/exact/common_line.h"
#include "hidden/exact/line_parameter.h"
#include "hidden/exact/orientation.h"
#include "hidden/exact/precision_policies.h"

namespace displayfile {

/// A line under examination: its ends, and the source of its depth.
struct DepthLine {
  Point3 a, b;
  const Plane* plane;  ///< null: its own ends' depth, and linear between them
  /// Null, or the line itself: then a and b are its ends rounded.
  const CommonLine* common = nullptr;
};

// Operations of a precision policy for the hidden-line methods, with the same members in both:
//
//   turn(a, b, c)                 1 if c is left of a to b in the projection, -1, 0
//   side(line, c)                 the side of the line that c is on: 1, -1, or 0 on it
//   nearer(line, at, plane)       the sign of the plane's depth less the line's, at one of its ends
//   passes_over(line, p, q)       the sign of the depth of the side from p to q less the line's
//   where
//                                 they cross; p is left of the line and q right of it, or one of
//                                 them on it, and the line's depth is its own ends'
//   crossing(line, p, q)          the parameters of the line, from 0 to 1, where the line through
//   at_point(line, p)             p and q crosses it, where a point that lies on it is, and where
//   meeting(line, plane)          the plane has the line's depth

/// Each sign is the true one, and each parameter the true one rounded once.
class ExactLines {
 public:
  static constexpr bool kIsExact = true;
  explicit ExactLines(const Definitions& all) : exact_(all) {}

  int turn(const Point2& a, const Point2& b, const Point2& c) const { return exact_.turn(a, b, c); }
  int side(const DepthLine& line, const Point3& c) const {
    if (line.common != nullptr) [[unlikely]]
      return line.common->side(c);
    return turn(Point2(line.a), Point2(line.b), Point2(c));
  }
  /// The plane faces the viewer.
  int nearer(const DepthLine& line, const Point3& at, const Plane& plane) const {
    if (line.common != nullptr) [[unlikely]] {
      return at == line.a ? line.common->nearer_at_start(plane) : line.common->nearer_at_end(plane);
    }
    return line.plane == nullptr ? -side(at, plane) : order(plane, *line.plane, at);
  }
  static int passes_over(const DepthLine& line, const Point3& p, const Point3& q) {
    return orientation(line.a, line.b, p, q);
  }
  double crossing(const DepthLine& line, const Point2& p, const Point2& q) const {
    if (line.common != nullptr) [[unlikely]]
      return line.common->crossing(p, q);
    return crossing_parameter(Point2(line.a), Point2(line.b), p, q);
  }
  double at_point(const DepthLine& line, const Point2& p) const {
    if (line.common != nullptr) [[unlikely]]
      return line.common->at_point(p);
    return point_parameter(Point2(line.a), Point2(line.b), p);
  }
  double meeting(const DepthLine& line, const Plane& plane) const {
    if (line.common != nullptr) [[unlikely]]
      return line.common->meeting(plane);
    if (line.plane == nullptr) return meeting_parameter(line.a, line.b, plane);
    return meeting_parameter(Point2(line.a), Point2(line.b), *line.plane, plane);
  }

 private:
  /// Neighbours in a mesh share points: then nothing else is evaluated.
  static int side(const Point3& v, const Plane& plane) {
    const auto [value, bound] = plane_value(v, plane);
    if (std::abs(value) > bound) [[likely]]
      return decided_sign(value);
    return plane.goes_through(v) ? 0 : exact_side_of_plane(v, plane);
  }
  static int order(const Plane& plane, const Plane& of_line, const Point3& at) {
    if (plane.goes_through(at) && of_line.goes_through(at)) return 0;
    return depth_order(plane, of_line, Point2(at));
  }

  Exact exact_;
};

/// The textbook's: doubles decide, and depths within ROUNDOFF are equal. Intersection lines have
/// their rounded ends.
class RoundoffLines {
 public:
  static constexpr bool kIsExact = false;
  RoundoffLines(const Definitions& all, double part) : roundoff_(Roundoff::relative(all, part)) {}

  int turn(const Point2& a, const Point2& b, const Point2& c) const {
    return roundoff_.turn(a, b, c);
  }
  int side(const DepthLine& line, const Point3& c) const {
    return turn(Point2(line.a), Point2(line.b), Point2(c));
  }
  int nearer(const DepthLine& line, const Point3& at, const Plane& plane) const {
    return roundoff_.signof(apart(line, at, plane));
  }
  int passes_over(const DepthLine& line, const Point3& p, const Point3& q) const {
    const double of_side = share(turned(line.a, line.b, p), turned(line.a, line.b, q));
    const double of_line = crossing(line, Point2(p), Point2(q));
    return roundoff_.signof(p.z + of_side * (q.z - p.z) -
                            (line.a.z + of_line * (line.b.z - line.a.z)));
  }
  double crossing(const DepthLine& line, const Point2& p, const Point2& q) const {
    return share(turned(p, q, line.a), turned(p, q, line.b));
  }
  double at_point(const DepthLine& line, const Point2& p) const {
    const int axis = line.a.x != line.b.x ? 0 : 1;
    return share(p[axis] - line.a[axis], p[axis] - line.b[axis]);
  }
  double meeting(const DepthLine& line, const Plane& plane) const {
    return share(apart(line, line.a, plane), apart(line, line.b, plane));
  }

 private:
  static double turned(const Point2& p, const Point2& q, const Point2& v) {
    return (q.x - p.x) * (v.y - p.y) - (q.y - p.y) * (v.x - p.x);
  }
  /// The zero of a value that is linear along the line; 0 if there is none.
  static double share(double at_a, double at_b) {
    const double t = at_a / (at_a - at_b);
    return t > 0.0 ? std::min(t, 1.0) : 0.0;
  }
  static double apart(const DepthLine& line, const Point3& at, const Plane& plane) {
    const double own = line.plane == nullptr ? at.z : Roundoff::depth(*line.plane, at);
    return Roundoff::depth(plane, at) - own;
  }

  Roundoff roundoff_;
};

}  // namespace displayfile
