#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clip/view/view_volume.h"

namespace displayfile {

/// A clipped polygon, in normalised device coordinates. Side i runs from vertex i - 1 (the last
/// one, for i = 0) to vertex i; it is drawn if edge_visible[i] is not 0. Sides made by clipping are
/// not drawn. No vertices: the polygon is outside. Valid until the pipeline's next call.
struct ClippedPolygon {
  std::span<const Point3> vertices;
  std::span<const std::uint8_t> edge_visible;
  std::span<const double> intensities = {};  ///< per vertex, if the polygon had some
  std::span<const Point3> normals = {};      ///< likewise
};

/// A transformed vertex that polygons share.
struct PipelineVertex {
  Point3 device;    ///< if it is inside of all planes
  Outcode outcode;  ///< the planes outside of which it lies
};

/// The clip pipeline: world coordinates in, normalised device coordinates out.
///
/// A polygon is cut by one stage a plane, in the textbook's order (CLIP-BACK, CLIP-FRONT,
/// CLIP-LEFT, CLIP-RIGHT, CLIP-BOTTOM, CLIP-TOP; algorithm 8.35 as revised in 9.2), each
/// feeding the next. A polygon wholly inside, or wholly outside of one plane, meets no stage.
/// Every edge that crosses a plane is cut by the same expression from its inside end to its
/// outside end, so two polygons that share it are cut at the same point, bit for bit.
/// Intensities of vertices, or normals, go through the stages with them; where an edge is cut, the
/// intensity, and each component of the normal, is that which runs linearly along the edge in the
/// picture. If a vertex is not in front of the centre of projection, the polygon has no such
/// picture and all get the mean. Method: Sutherland and Hodgman, "Reentrant polygon clipping", CACM
/// 17 (1974).
class ClipPipeline {
 public:
  explicit ClipPipeline(const ViewVolume& volume) : volume_(volume) {}
  /// Changes the view.
  void set_volume(const ViewVolume& volume) { volume_ = volume; }

  /// Clips a polygon of any number of sides, convex or not; edge_visible as in
  /// ClippedPolygon, empty for "all sides"; one intensity a vertex, or none.
  ClippedPolygon clip_polygon(std::span<const Point3> world,
                              std::span<const std::uint8_t> edge_visible = {},
                              std::span<const double> intensities = {});
  /// The same for a polygon with one normal per vertex.
  ClippedPolygon clip_with_normals(std::span<const Point3> world,
                                   std::span<const std::uint8_t> edge_visible,
                                   std::span<const Point3> normals);

  /// Clips the line from a to b (world) and returns its ends in device coordinates; false if it is
  /// outside. From b to a it gives the same two ends, bit for bit.
  bool clip_line(const Point3& a, const Point3& b, Point3& device_a, Point3& device_b);

  /// Transforms a vertex. If all vertices of a polygon are inside, it has their device coordinates.
  PipelineVertex view(const Point3& world) const {
    const HomogeneousPoint p = volume_.transform(world);
    const Outcode outcode = volume_.outcode(p);
    return {outcode == 0 ? volume_.to_device(p) : Point3(0.0), outcode};
  }

  const ViewVolume& volume() const { return volume_; }
  /// The planes outside of which a point of a polygon or line lay, of all that were clipped.
  Outcode met() const { return met_; }

 private:
  struct Vertex {
    HomogeneousPoint position;
    Outcode outcode;
    std::uint8_t edge_visible;  ///< of the side that ends here
  };
  template <class Value>
  struct ShadedVertex : Vertex {
    Value value;  ///< its intensity, or its normal
  };
  /// A stage's input and output.
  template <class V>
  struct Stages {
    std::vector<V> in, out;
  };

  template <class V>
  V cut(const V& inside, const V& outside, ClipPlane plane) const;
  template <class V>
  void clip_stage(ClipPlane plane, Stages<V>& stage) const;
  /// For polygons without values.
  struct NoValues {};
  /// Transforms the vertices and runs the stages that they need; the result is in stage.in. Values
  /// are a span, if the stages' vertices have them.
  template <class V, class Values>
  void run_stages(std::span<const Point3> world, std::span<const std::uint8_t> edge_visible,
                  const Values& values, Stages<V>& stage);
  template <class V>
  ClippedPolygon in_device_coordinates(std::span<const V> clipped);
  template <class Value>
  ClippedPolygon clip_shaded(std::span<const Point3> world,
                             std::span<const std::uint8_t> edge_visible,
                             std::span<const Value> values, Stages<ShadedVertex<Value>>& stage,
                             std::vector<Value>& of_clipped);

  ViewVolume volume_;
  Outcode met_ = 0;
  Stages<Vertex> stage_;
  Stages<ShadedVertex<double>> intensity_stage_;
  Stages<ShadedVertex<Point3>> normal_stage_;
  std::vector<Point3> vertices_;
  std::vector<std::uint8_t> visible_;
  std::vector<double> intensities_;
  std::vector<Point3> normals_;
};

}  // namespace displayfile
