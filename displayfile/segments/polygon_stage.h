#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x3.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "clip/pipeline/clip_pipeline.h"
#include "displayfile/looks/gouraud.h"
#include "displayfile/looks/phong.h"
#include "displayfile/looks/style.h"
#include "displayfile/looks/vertex_shading.h"
#include "displayfile/looks/world_polygon.h"
#include "displayfile/segments/segment.h"

namespace displayfile {

/// A polygon after viewing. Valid until the stage's next call, and as long as its attributes.
struct StagedPolygon {
  ClippedPolygon polygon;  ///< no vertices: not drawn
  const FillStyle* fill = nullptr;
  const LineStyle* line = nullptr;  ///< of its sides
  const Light* light = nullptr;     ///< null: none

  VertexShading shading() const { return {polygon.intensities, polygon.normals, light}; }
};

/// Transforms polygons from world coordinates to a view, when they are entered and for a retained
/// scene in a new view: clips them, checks for back faces (the end of algorithm 9.2), lights them,
/// and enters them into a segment's instructions.
class PolygonStage {
 public:
  explicit PolygonStage(const ViewVolume& volume) : pipeline_(volume) {}
  /// Changes the view.
  void set_volume(const ViewVolume& volume) { pipeline_.set_volume(volume); }

  StagedPolygon view_polygon(const WorldPolygon& polygon, const Attributes& attributes);

  /// Must be called when the segment or the attributes differ from the last call: styles are
  /// entered only then, except fills where there is light.
  void attributes_changed() { fill_entered_ = line_entered_ = false; }

  /// True if a part of the polygon was entered: it is neither outside nor a removed back face.
  bool enter_polygon(const WorldPolygon& polygon, const Attributes& attributes, Segment& segment);
  /// Transforms vertices that several polygons share, once each, for enter_shared; they are
  /// numbered from `first`.
  void view_vertices(std::span<const Point3> world, std::uint32_t first = 0);
  /// Sets the vertices as entered, before the modelling transformation of that matrix; null: in
  /// world coordinates. Both must outlive the use of the vertices.
  void note_entered(std::span<const Point3> vertices, const glm::dmat4x3* modelling,
                    Segment& segment);
  /// A triangle of shared vertices.
  struct SharedTriangle {
    std::array<std::uint32_t, 3> corners;      ///< vertex numbers
    std::array<std::uint8_t, 3> edge_visible;  ///< 0 or 1, of the side that ends at the vertex
    std::int32_t pick;
  };
  /// Fast path for a triangle that needs no clipping, smooth shading or shadows; `world` are all
  /// vertices. True if it was entered, false if it is outside or a removed back face, nothing if it
  /// needs enter_shared.
  std::optional<bool> enter_triangle(std::span<const Point3> world, const SharedTriangle& triangle,
                                     const Attributes& attributes, Segment& segment);
  /// Enters a polygon given by numbers of the vertices viewed last. True if a part of it was
  /// entered.
  bool enter_shared(std::span<const std::uint32_t> corners, const WorldPolygon& polygon,
                    const Attributes& attributes, Segment& segment);
  /// The line style must not be none. False if the line is outside.
  bool enter_line(const Point3& from, const Point3& to, const LineStyle& style, Segment& segment);

  /// A text at a point, in the attributes' line style and text style. False if the point is
  /// outside.
  bool enter_text(const Point3& anchor, std::string_view characters, const Attributes& attributes,
                  Segment& segment);

  /// Annotation in world coordinates. False if it is not in the view.
  bool enter_annotation(const KeptAnnotation& annotation, Segment& segment);

  ClipPipeline& pipeline() { return pipeline_; }
  /// The planes outside of which some entered point was; annotation counts as outside.
  Outcode met() const { return met_ | pipeline_.met(); }

 private:
  struct Outcodes {
    Outcode any, all;  ///< of corners: or, and
  };
  Outcodes outcodes(std::span<const std::uint32_t> corners) const;
  const PipelineVertex& viewed(std::uint32_t corner) const {
    return shared_[corner - first_shared_];
  }
  ClippedPolygon clip_smooth(const WorldPolygon& polygon, const Attributes& attributes);
  StagedPolygon view_clipped(ClippedPolygon clipped, const WorldPolygon& polygon,
                             const Attributes& attributes);
  bool enter(const StagedPolygon& viewed, const Attributes& attributes, std::int32_t pick,
             Segment& segment);
  void keep_shared(std::span<const std::uint32_t> corners, bool is_seen, Segment& segment) const;
  void enter_styles(const FillStyle& fill, const LineStyle& line, const Attributes& attributes,
                    Segment& segment);
  const LineStyle& line_of(const Attributes& attributes, ClippedPolygon& clipped);
  FillStyle lit_fill(const WorldPolygon& polygon, const Attributes& attributes,
                     ClippedPolygon& clipped) const;

  ClipPipeline pipeline_;
  Outcode met_ = 0;  // of shared vertices, texts and annotation
  GouraudLighting gouraud_;
  PhongNormals phong_;
  FillStyle lit_;
  // The segment has these styles of the attributes; where there is light, each polygon has its own
  // fill.
  bool fill_entered_ = false, line_entered_ = false;
  std::vector<PipelineVertex> shared_;
  std::uint32_t first_shared_ = 0;
  std::span<const Point3> entered_shared_;  // the same vertices as entered, if set
  const glm::dmat4x3* modelling_of_shared_ = nullptr;
  std::vector<Point3> device_;           // of a polygon
  std::vector<std::uint8_t> all_edges_;  // ones
  std::vector<std::uint8_t> no_edges_;   // zeros
};

}  // namespace displayfile
