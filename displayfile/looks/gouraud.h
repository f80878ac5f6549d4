#pragma once

#include <span>
#include <vector>

#include "clip/pipeline/clip_pipeline.h"
#include "displayfile/looks/lighting.h"

namespace displayfile {

// Gouraud shading when polygons are entered (displayfile/looks/gouraud.md). World coordinates.

/// True if the normals differ: then the polygon is entered as triangles.
bool differ(std::span<const Point3> normals);

/// Orients the vertex normals passed by an application to the polygon's own normal `own`: zeros are
/// replaced by it, and if they point out of the dark face in total, all are reversed. Any length.
void orient(std::span<Point3> normals, const Point3& own);

/// Clips polygons with vertex normals and lights the visible side.
class GouraudLighting {
 public:
  /// Returns vertex intensities, interpolated where edges were cut. Valid until the pipeline's next
  /// call.
  ClippedPolygon clip(ClipPipeline& pipeline, std::span<const Point3> world,
                      std::span<const std::uint8_t> edge_visible, std::span<const Point3> normals,
                      const Light& light);

 private:
  std::vector<double> intensities_;
};

/// The fill with which a clipped polygon is entered: if it is hollow or all intensities are equal,
/// the lit fill, and the intensities are removed; otherwise `fill`.
FillStyle shaded_fill(const FillStyle& fill, ClippedPolygon& clipped);

}  // namespace displayfile
