#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clip/view_volume.h"

namespace displayfile {

/// What the pipeline lets through of a polygon, in normalised device coordinates.
/// Side i runs from vertex i - 1 (the last one, for i = 0) to vertex i; it is drawn if
/// edge_visible[i] is not 0. A side that the clipping made is not drawn. No vertices: the
/// polygon is outside. Valid until the pipeline's next call.
struct ClippedPolygon {
  std::span<const Point3> vertices;
  std::span<const std::uint8_t> edge_visible;
};

/// The clip pipeline: world coordinates in, normalised device coordinates out.
///
/// A polygon is cut by one stage a plane, in the textbook's order (CLIP-BACK, CLIP-FRONT,
/// CLIP-LEFT, CLIP-RIGHT, CLIP-BOTTOM, CLIP-TOP; algorithm 8.35 as revised in 9.2), each
/// feeding the next. A polygon wholly inside, or wholly outside of one plane, meets no stage.
/// Every edge that crosses a plane is cut by the same expression from its inside end to its
/// outside end, so two polygons that share it are cut at the same point, bit for bit.
/// Method: Sutherland and Hodgman, "Reentrant polygon clipping", CACM 17 (1974).
class ClipPipeline {
 public:
  explicit ClipPipeline(const ViewVolume& volume) : volume_(volume) {}

  /// Clips a polygon of any number of sides, convex or not; edge_visible as in
  /// ClippedPolygon, empty for "all sides".
  ClippedPolygon clip_polygon(std::span<const Point3> world,
                              std::span<const std::uint8_t> edge_visible = {});

  /// Clips the line from a to b (world) in place of its device coordinates; false if
  /// nothing of it is inside.
  bool clip_line(const Point3& a, const Point3& b, Point3& device_a, Point3& device_b) const;

  const ViewVolume& volume() const { return volume_; }

 private:
  struct Vertex {
    HomogeneousPoint position;
    Outcode outcode;
    std::uint8_t edge_visible;  ///< of the side that ends here
  };

  Vertex cut(const Vertex& inside, const Vertex& outside, ClipPlane plane) const;
  void clip_stage(ClipPlane plane);

  ViewVolume volume_;
  std::vector<Vertex> stage_in_, stage_out_;
  std::vector<Point3> vertices_;
  std::vector<std::uint8_t> visible_;
};

}  // namespace displayfile
