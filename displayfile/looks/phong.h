#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clip/clip_pipeline.h"
#include "displayfile/looks/lighting.h"
#include "displayfile/looks/style.h"

namespace displayfile {

// Phong shading on the way into the display file (displayfile/looks/phong.md). World coordinates.

/// Clips polygons whose vertices have normals, which go with them.
class PhongNormals {
 public:
  /// The normals are those of the vertices, of length 1, out of the side that is seen, and
  /// interpolated where edges were cut. Valid until the next call, and the pipeline's.
  ClippedPolygon clip(ClipPipeline& pipeline, std::span<const Point3> world,
                      std::span<const std::uint8_t> edge_visible, std::span<const Point3> normals);

 private:
  std::vector<Point3> normals_;
};

/// The fill that a clipped polygon with normals is entered with: lit, if it is hollow, or if every
/// normal over it has one intensity, and the vertices' normals are then removed; otherwise as it
/// is.
FillStyle phong_fill(const FillStyle& fill, const Light& light, ClippedPolygon& clipped);

}  // namespace displayfile
