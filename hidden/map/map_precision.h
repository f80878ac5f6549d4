#pragma once

#include "hidden/exact/precision_policies.h"

namespace displayfile {

// What a map asks of a precision policy, with the same members of both:
//
//   turn(a, b, c)               1 if c is left of a to b in the projection, -1, 0
//   order(one, other, at)       1 if plane one is nearer than the other at a point, -1, 0
//   order(all, one, other, at)  the same at a defined point
//   kExact                      whether places that are rounded alike are told apart

/// Each sign is the true one.
class ExactMap {
 public:
  static constexpr bool kExact = true;

  explicit ExactMap(const Definitions& all) : exact_(all) {}

  int turn(const Point2& a, const Point2& b, const Point2& c) const { return exact_.turn(a, b, c); }
  static int order(const Plane& one, const Plane& other, const Point3& at) {
    const int order = filtered_depth_order(one, other, {at.x, at.y, 0.0});
    if (order != 0) [[likely]]
      return order;
    if (one.goes_through(at) && other.goes_through(at)) return 0;  // neighbours in a mesh
    return exact_depth_order(one, other, Point2(at));
  }
  static int order(const Definitions& all, const Plane& one, const Plane& other,
                   const DefinedPoint& at) {
    return depth_order(all, one, other, at);
  }

 private:
  Exact exact_;
};

/// What is no farther apart than ROUNDOFF touches, in the projection and in depth, as the textbook
/// has it. Beyond that signs are true ones, so that what is said to cross has a crossing.
class RoundoffMap {
 public:
  static constexpr bool kExact = false;

  RoundoffMap(const Definitions& all, double part)
      : exact_(all), roundoff_(Roundoff::relative(all, part)) {}

  int turn(const Point2& a, const Point2& b, const Point2& c) const {
    return roundoff_.turn(a, b, c) == 0 ? 0 : exact_.turn(a, b, c);
  }
  int order(const Plane& one, const Plane& other, const Point3& at) const {
    return is_close(one, other, at) ? 0 : ExactMap::order(one, other, at);
  }
  int order(const Definitions& all, const Plane& one, const Plane& other,
            const DefinedPoint& at) const {
    return is_close(one, other, at.near) ? 0 : ExactMap::order(all, one, other, at);
  }

 private:
  bool is_close(const Plane& one, const Plane& other, const Point3& at) const {
    return roundoff_.signof(Roundoff::depth(one, at) - Roundoff::depth(other, at)) == 0;
  }

  ExactMap exact_;
  Roundoff roundoff_;
};

}  // namespace displayfile
