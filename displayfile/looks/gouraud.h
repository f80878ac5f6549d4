#pragma once

#include <span>
#include <vector>

#include "clip/clip_pipeline.h"
#include "displayfile/looks/lighting.h"

namespace displayfile {

// Gouraud shading on the way into the display file (displayfile/looks/gouraud.md). World
// coordinates.

/// True if the normals are not all the same: then the polygon is entered as triangles.
bool differ(std::span<const Point3> normals);

/// Makes what an application gave as normals of a polygon's vertices agree with the polygon, whose
/// own normal is given: a zero stands for that one, and if they point out of the dark face, taken
/// together, all are turned round. Any length.
void orient(std::span<Point3> normals, const Point3& own);

/// Clips polygons whose vertices have normals, and lights the side that is seen.
class GouraudLighting {
 public:
  /// The intensities are those of the vertices, interpolated where edges were cut. Valid until the
  /// pipeline's next call.
  ClippedPolygon clip(ClipPipeline& pipeline, std::span<const Point3> world,
                      std::span<const std::uint8_t> edge_visible, std::span<const Point3> normals,
                      const Light& light);

 private:
  std::vector<double> intensities_;
};

/// The fill that a clipped polygon is entered with: lit, if it is hollow or has one intensity at
/// all vertices, and the vertices' intensities are then removed; otherwise as it is.
FillStyle shaded_fill(const FillStyle& fill, ClippedPolygon& clipped);

}  // namespace displayfile
