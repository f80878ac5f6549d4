#include "hidden/exact/exact_point.h"

#include <cassert>
#include <cmath>
#include <utility>

#include "clip/base/error.h"
#include "hidden/exact/double_double.h"
#include "hidden/exact/wide_ball.h"

namespace displayfile {

namespace {

/// The vector, with the rest added to its depth.
template <class Number>
VectorOf<Number> vector_of(const Point3& p, double rest = 0.0) {
  VectorOf<Number> v{Number(p.x), Number(p.y), Number(p.z)};
  if (rest != 0.0) v.z = v.z + Number(rest);
  return v;
}

template <class Number>
VectorOf<Number> normal_of(const Plane& plane) {
  if (plane.is_plain()) [[likely]] {
    return cross(difference_of<Number>(plane.q, plane.p), difference_of<Number>(plane.r, plane.p));
  }
  const auto p = vector_of<Number>(plane.p, plane.rest.x);
  return cross(vector_of<Number>(plane.q, plane.rest.y) - p,
               vector_of<Number>(plane.r, plane.rest.z) - p);
}

template <class Number>
Number& component(VectorOf<Number>& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

template <class Number>
PointOf<Number> point_of(const Point3& p) {
  return {vector_of<Number>(p), Number(1.0)};
}

/// p moved along the axis on to the plane: the plane's equation, solved for that coordinate.
template <class Number>
PointOf<Number> lifted_on_to(const Plane& own, const Point3& p, int axis) {
  assert(0 <= axis && axis < 3);
  PlaneOf<Number> plane(own);
  VectorOf<Number> from = vector_of<Number>(p) - plane.through;
  const Number c = component(plane.normal, axis);
  component(from, axis) = Number();
  PointOf<Number> point{vector_of<Number>(p) * c, c};
  component(point.xyz, axis) = component(plane.through, axis) * c - dot(plane.normal, from);
  return point;
}

/// The point of the line through a and b at which the plane's value, linear along it, is zero.
template <class Number>
PointOf<Number> met_by(const PointOf<Number>& a, const PointOf<Number>& b, const Plane& cut) {
  const PlaneOf<Number> plane(cut);
  const Number at_a = value_at(plane, a), at_b = value_at(plane, b);
  return {a.xyz * at_b - b.xyz * at_a, a.w * at_b - b.w * at_a};
}

/// Cramer's rule for the three equations normal . x = normal . through.
template <class Number>
PointOf<Number> common_point(const Plane& first, const Plane& second, const Plane& third) {
  const PlaneOf<Number> f(first), s(second), t(third);
  const auto st = cross(s.normal, t.normal), tf = cross(t.normal, f.normal),
             fs = cross(f.normal, s.normal);
  return {
      st * dot(f.normal, f.through) + tf * dot(s.normal, s.through) + fs * dot(t.normal, t.through),
      dot(f.normal, st)};
}

template <class Number>
PointOf<Number> from_definition(const Definitions& all, const DefinedPoint& v) {
  const auto lifted = [&](std::uint32_t point) {
    return lifted_on_to<Number>(all.planes[v.own], all.points[point], v.axis);
  };
  switch (v.kind) {
    case DefinedPoint::Kind::stored: break;
    case DefinedPoint::Kind::lifted: return lifted(v.a);
    case DefinedPoint::Kind::edge_cut:
      return met_by(point_of<Number>(all.points[v.a]), point_of<Number>(all.points[v.b]),
                    all.planes[v.cut]);
    case DefinedPoint::Kind::lifted_edge_cut:
      return met_by(lifted(v.a), lifted(v.b), all.planes[v.cut]);
    case DefinedPoint::Kind::plane_cut:
      return common_point<Number>(all.planes[v.own], all.planes[v.a], all.planes[v.cut]);
  }
  return point_of<Number>(v.near);
}

}  // namespace

template <class Number>
PlaneOf<Number>::PlaneOf(const Plane& plane)
    : normal(normal_of<Number>(plane)), through(vector_of<Number>(plane.p, plane.rest.x)) {}

template struct PlaneOf<ExactNumber>;

ExactPoint exact_point(const Point3& p) { return point_of<ExactNumber>(p); }

ExactPoint exact_point(const Definitions& all, const DefinedPoint& v) {
  auto point = exact_point_if_any(all, v);
  if (!point) throw Error("a point made by a cut does not exist: what defines it is parallel");
  return *std::move(point);
}

std::optional<ExactPoint> exact_point_if_any(const Definitions& all, const DefinedPoint& v) {
  ExactPoint point = from_definition<ExactNumber>(all, v);
  if (point.w.sign() == 0) return std::nullopt;
  return point;
}

/// Nothing for points too large to have doubles near them: their products may overflow.
std::optional<Point3> rounded_closely(const Definitions& all, const DefinedPoint& v) {
  if (!std::isfinite(v.radius) || !is_double_double_sound()) return std::nullopt;
  const PointOf<WideBall> p = from_definition<WideBall>(all, v);
  const auto x = (p.xyz.x / p.w).rounded(), y = (p.xyz.y / p.w).rounded(),
             z = (p.xyz.z / p.w).rounded();
  if (!x || !y || !z) return std::nullopt;
  return Point3(*x, *y, *z);
}

}  // namespace displayfile
