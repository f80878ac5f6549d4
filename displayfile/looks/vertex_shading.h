#pragma once

#include <span>
#include <vector>

#include "clip/point.h"
#include "displayfile/looks/lighting.h"

namespace displayfile {

/// What the vertices of a polygon have that is shaded smoothly, one each: intensities with Gouraud
/// shading (displayfile/looks/gouraud.md), normals with Phong shading (displayfile/looks/phong.md).
/// Both run linearly over its picture, which was cut from one triangle; the fill colour is
/// multiplied by the intensity, or by that of the normal. Empty if the polygon is flat. What it
/// points to must live on.
struct VertexShading {
  std::span<const double> intensities = {};
  /// World coordinates; out of the side that is seen. Of length 1 where no edge was cut.
  std::span<const Point3> normals = {};
  const Light* light = nullptr;  ///< that normals are seen in

  bool empty() const { return intensities.empty() && normals.empty(); }
};

/// Tells a visitor of instructions (displayfile/entered/instructions.h) what stands before a
/// polygon, if it takes it: intensities(span<const double>), or normals(span<const Point3>, const
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

/// The intensities of the vertices, for who does not interpolate normals: those that there are, or
/// those of the normals, in an array whose content is lost. None if the polygon is flat.
std::span<const double> vertex_intensities(const VertexShading& shading,
                                           std::vector<double>& of_normals);

}  // namespace displayfile
