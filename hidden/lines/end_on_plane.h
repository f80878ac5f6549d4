#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "clip/point.h"
#include "hidden/ends_as_entered.h"
#include "hidden/exact/plane.h"

namespace displayfile {

/// The result of testing whether a point is on a plane, up to rounding.
enum class OnPlane : std::uint8_t { no, yes, unknown };

/// The position of a line's end v relative to a plane, which is not edge-on: decided in doubles, in
/// display-file coordinates. As entered v is on the plane, but viewing has moved it and each of the
/// plane's three points by up to `off` per coordinate. So v may be off the plane by its own error
/// plus the errors of the three points times their weights there, which are large far away from
/// them. Unknown where these are too large or `off` is infinite.
inline OnPlane on_plane(const Point3& v, const Plane& plane, double off) {
  constexpr double kLargestShares = 0x1p20;
  const Point3 &p = plane.p, &q = plane.q, &r = plane.r, &normal = plane.normal;
  const auto area = [](const Point3& a, const Point3& b, const Point3& c) {
    return std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  };
  const double shares = (area(v, q, r) + area(p, v, r) + area(p, q, v)) / std::abs(normal.z);
  if (!(shares <= kLargestShares) || off == std::numeric_limits<double>::infinity()) {
    return OnPlane::unknown;
  }
  const bool is_on = std::abs(glm::dot(normal, v - p)) <= off * (1.0 + shares) * plane.reach;
  return is_on ? OnPlane::yes : OnPlane::no;
}

/// True if a side's end is on its polygon's plane up to the rounding of viewing, so that it keeps
/// its own depth there; also if the plane is nearly edge-on and far in depth from an end within
/// reach of it, where the plane's depth would be arbitrary.
inline bool has_own_depth(const Point3& v, const Plane& plane, double touching, double rounding) {
  constexpr double kNearlyEdgeOn = 1024.0, kFarInDepth = 1e-9;
  if (!(rounding > 0.0)) return false;
  if (plane.is_plain() && on_plane(v, plane, rounding) == OnPlane::yes) return true;
  if (!(touching > 0.0) || touching == std::numeric_limits<double>::infinity()) return false;
  const Plane with_rest(plane.p + Point3(0, 0, plane.rest.x), plane.q + Point3(0, 0, plane.rest.y),
                        plane.r + Point3(0, 0, plane.rest.z));
  const Point3 normal = glm::abs(with_rest.normal);
  const double off = std::abs(glm::dot(with_rest.normal, v - with_rest.p));
  const bool is_steep = std::max(normal.x, normal.y) > kNearlyEdgeOn * normal.z;
  if (!is_steep || off <= kFarInDepth * normal.z) return false;
  return on_plane(v, Plane(plane.p, plane.q, plane.r), touching) == OnPlane::yes;
}

/// The maximum distance in depth from a polygon's plane of a line within reach of it, where the
/// polygon covers the line: each coordinate of both may be off by `touching`, and more on a steep
/// plane. Increased by an eighth, for rounding.
inline double reach_in_depth(double touching, const Plane& plane) {
  const Point3& n = plane.normal;
  return 2.25 * touching * (1.0 + (std::abs(n.x) + std::abs(n.y)) / std::abs(n.z));
}

/// The sign of a plane's depth minus that of a line's end, by the end as entered; nothing if the
/// display file's coordinates decide. `rounded` is used if the entered points are unavailable.
inline std::optional<int> sign_as_entered(EndsAsEntered::Place place, OnPlane rounded) {
  using Place = EndsAsEntered::Place;
  switch (place) {
    case Place::unknown: break;
    case Place::on_plane: return 0;
    case Place::before: return -1;
    case Place::behind: return 1;
    case Place::off_plane: return std::nullopt;
  }
  return rounded == OnPlane::yes ? std::optional(0) : std::nullopt;
}

}  // namespace displayfile
