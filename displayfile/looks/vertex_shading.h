#pragma once

#include <cassert>
#include <span>
#include <vector>

#include "clip/point.h"
#include "displayfile/looks/lighting.h"

namespace displayfile {

/// Vertex data of a smoothly shaded polygon: intensities with Gouraud shading
/// (displayfile/looks/gouraud.md), normals with Phong shading (displayfile/looks/phong.md). Both
/// are linear over its picture, which was cut from one triangle; the fill colour is multiplied by
/// the intensity, or that of the normal. Empty if the polygon is flat shaded. It does not own its
/// arrays.
struct VertexShading {
  std::span<const double> intensities = {};
  /// World coordinates, out of the visible side. Of length 1 where no edge was cut.
  std::span<const Point3> normals = {};
  const Light* light = nullptr;  ///< the light for the normals

  bool empty() const { return intensities.empty() && normals.empty(); }
};

/// Calls a visitor of instructions (displayfile/entered/instructions.h) with the data before a
/// polygon, if it accepts it: intensities(span<const double>), or normals(span<const Point3>, const
/// Light&).
template <class Visitor>
void visit_shading(Visitor& visit, const VertexShading& shading) {
  if constexpr (requires { visit.intensities(shading.intensities); }) {
    if (!shading.intensities.empty()) visit.intensities(shading.intensities);
  }
  if constexpr (requires { visit.normals(shading.normals, *shading.light); }) {
    if (!shading.normals.empty()) visit.normals(shading.normals, *shading.light);
  }
}

/// Vertex intensities for callers that do not interpolate normals: the given ones, or those of the
/// normals, in a buffer that is overwritten. Empty if the polygon is flat shaded.
inline std::span<const double> vertex_intensities(const VertexShading& shading,
                                                  std::vector<double>& of_normals) {
  if (shading.normals.empty()) return shading.intensities;
  assert(shading.light != nullptr);
  of_normals.clear();
  for (const Point3& n : shading.normals) of_normals.push_back(intensity(*shading.light, n, false));
  return of_normals;
}

}  // namespace displayfile
