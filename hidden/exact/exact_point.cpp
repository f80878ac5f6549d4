#include "hidden/exact/exact_point.h"

#include <utility>

#include "clip/error.h"

namespace displayfile {

namespace {

ExactVector exact_vector(const Point3& p) {
  return {ExactNumber(p.x), ExactNumber(p.y), ExactNumber(p.z)};
}

/// With the rest of its depth.
ExactVector exact_vector(const Point3& p, double rest) {
  ExactVector exact = exact_vector(p);
  if (rest != 0.0) exact.z = exact.z + ExactNumber(rest);
  return exact;
}

ExactVector exact_normal(const Plane& plane) {
  if (plane.is_plain()) [[likely]] {
    return cross(exact_difference(plane.q, plane.p), exact_difference(plane.r, plane.p));
  }
  const ExactVector p = exact_vector(plane.p, plane.rest.x);
  return cross(exact_vector(plane.q, plane.rest.y) - p, exact_vector(plane.r, plane.rest.z) - p);
}

ExactNumber& component(ExactVector& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// p moved along the axis on to the plane: the plane's equation, solved for that coordinate.
ExactPoint exactly_lifted(const Point3& p, const Plane& own, int axis) {
  ExactPlane plane(own);
  ExactVector from = exact_vector(p) - plane.through;
  const ExactNumber c = component(plane.normal, axis);
  component(from, axis) = ExactNumber();
  ExactPoint point{exact_vector(p) * c, c};
  component(point.xyz, axis) = component(plane.through, axis) * c - dot(plane.normal, from);
  return point;
}

/// The point of the line through a and b at which the plane's value, linear along it, is zero.
ExactPoint met_by(const ExactPoint& a, const ExactPoint& b, const Plane& cut) {
  const ExactPlane plane(cut);
  const ExactNumber at_a = value_at(plane, a), at_b = value_at(plane, b);
  return {a.xyz * at_b - b.xyz * at_a, a.w * at_b - b.w * at_a};
}

/// Cramer's rule for the three equations normal . x = normal . through.
ExactPoint exact_meeting(const Plane& first, const Plane& second, const Plane& third) {
  const ExactPlane f(first), s(second), t(third);
  const ExactVector st = cross(s.normal, t.normal), tf = cross(t.normal, f.normal),
                    fs = cross(f.normal, s.normal);
  return {
      st * dot(f.normal, f.through) + tf * dot(s.normal, s.through) + fs * dot(t.normal, t.through),
      dot(f.normal, st)};
}

ExactPoint from_definition(const Definitions& all, const DefinedPoint& v) {
  switch (v.kind) {
    case DefinedPoint::Kind::stored: break;
    case DefinedPoint::Kind::lifted:
      return exactly_lifted(all.points[v.a], all.planes[v.own], v.axis);
    case DefinedPoint::Kind::edge_cut:
      return met_by(exact_point(all.points[v.a]), exact_point(all.points[v.b]), all.planes[v.cut]);
    case DefinedPoint::Kind::lifted_edge_cut:
      return met_by(exactly_lifted(all.points[v.a], all.planes[v.own], v.axis),
                    exactly_lifted(all.points[v.b], all.planes[v.own], v.axis), all.planes[v.cut]);
    case DefinedPoint::Kind::plane_cut:
      return exact_meeting(all.planes[v.own], all.planes[v.a], all.planes[v.cut]);
  }
  return exact_point(v.near);
}

}  // namespace

ExactPlane::ExactPlane(const Plane& plane)
    : normal(exact_normal(plane)), through(exact_vector(plane.p, plane.rest.x)) {}

ExactPoint exact_point(const Point3& p) { return {exact_vector(p), ExactNumber(1.0)}; }

ExactPoint exact_point(const Definitions& all, const DefinedPoint& v) {
  auto point = exact_point_if_any(all, v);
  if (!point) throw Error("a point made by a cut does not exist: what defines it is parallel");
  return *std::move(point);
}

std::optional<ExactPoint> exact_point_if_any(const Definitions& all, const DefinedPoint& v) {
  ExactPoint point = from_definition(all, v);
  if (point.w.sign() == 0) return std::nullopt;
  return point;
}

ExactNumber value_at(const ExactPlane& plane, const ExactPoint& v) {
  return dot(plane.normal, v.xyz - plane.through * v.w);
}

}  // namespace displayfile
