#include "displayfile/looks/phong.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>

#include "clip/geometry/back_face.h"
#include "clip/geometry/unit.h"
#include "displayfile/looks/gouraud.h"

namespace displayfile {

/// The visible side is known when the polygon is clipped. Reversing normals commutes with
/// interpolating them at cuts: a cut normal is a sum of reversed ones.
ClippedPolygon PhongNormals::clip(ClipPipeline& pipeline, std::span<const Point3> world,
                                  std::span<const std::uint8_t> edge_visible,
                                  std::span<const Point3> normals) {
  assert(world.size() == normals.size());
  normals_.clear();
  for (const Point3& n : normals) normals_.push_back(n == Point3(0.0) ? n : unit(n));
  ClippedPolygon clipped = pipeline.clip_with_normals(world, edge_visible, normals_);
  if (newell_c(clipped.vertices) >= 0.0) return clipped;
  normals_.clear();
  for (const Point3& n : clipped.normals) normals_.push_back(-n);
  clipped.normals = normals_;
  return clipped;
}

/// If no vertex faces the light, no interpolated normal does.
FillStyle phong_fill(const FillStyle& fill, const Light& light, ClippedPolygon& clipped) {
  const bool all_dark = std::ranges::all_of(
      clipped.normals, [&](const Point3& n) { return glm::dot(n, light.toward) <= 0.0; });
  const bool even = all_dark || light.ambient == 1.0 || !differ(clipped.normals);
  if (fill.kind == FillStyle::Kind::solid && !even) return fill;
  assert(clipped.normals.size() == clipped.vertices.size());
  const Point3 anywhere = clipped.normals.front();
  clipped.normals = {};
  return lit(fill, light, anywhere, false);
}

}  // namespace displayfile
