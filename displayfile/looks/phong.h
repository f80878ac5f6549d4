#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clip/pipeline/clip_pipeline.h"
#include "displayfile/looks/lighting.h"
#include "displayfile/looks/style.h"

namespace displayfile {

// Phong shading when polygons are entered (displayfile/looks/phong.md). World coordinates.

/// Clips polygons with vertex normals, keeping the normals.
class PhongNormals {
 public:
  /// Returns normals of length 1, out of the visible side, interpolated where edges were cut. Valid
  /// until the next call, here or of the pipeline.
  ClippedPolygon clip(ClipPipeline& pipeline, std::span<const Point3> world,
                      std::span<const std::uint8_t> edge_visible, std::span<const Point3> normals);

 private:
  std::vector<Point3> normals_;
};

/// The fill with which a clipped polygon with normals is entered: if it is hollow or every normal
/// has the same intensity, the lit fill, and the normals are removed; otherwise `fill`.
FillStyle phong_fill(const FillStyle& fill, const Light& light, ClippedPolygon& clipped);

}  // namespace displayfile
