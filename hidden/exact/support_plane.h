#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "clip/point.h"

namespace displayfile {

/// The three vertices whose plane is the polygon's depth everywhere (the support plane of
/// the definition in interp/truth/truth.md): a triangle's own; otherwise the first vertex p, the
/// one farthest from p in the projection, and the one farthest from the line through both
/// in the projection, first of equals. Device coordinates.
struct SupportVertices {
  std::array<std::uint32_t, 3> index;  ///< the first is 0; all differ unless edge_on
  bool edge_on;  ///< the three are collinear in the projection: the polygon covers nothing
};
SupportVertices support_vertices(std::span<const Point3> vertices);

/// In world coordinates, before viewing, no direction is special: the first vertex, the one
/// farthest from it in space, and the one farthest from the line through both, first of equals.
/// `edge_on` then means that all vertices are collinear in space, and have no plane.
SupportVertices spread_vertices(std::span<const Point3> world);

/// Depth over the projection, z = z0 + dz_dx (x - x0) + dz_dy (y - y0): the slides'
/// plane equation with dz_dx = -A/C and dz_dy = -B/C, in doubles.
struct DepthPlane {
  double x0, y0, z0, dz_dx, dz_dy;
  double at(double x, double y) const { return z0 + dz_dx * (x - x0) + dz_dy * (y - y0); }
};

/// The plane through three points that are not in line in the projection.
DepthPlane depth_plane(const Point3& p, const Point3& q, const Point3& r);

}  // namespace displayfile
