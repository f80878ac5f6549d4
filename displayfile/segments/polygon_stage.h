#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x3.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "clip/clip_pipeline.h"
#include "displayfile/looks/gouraud.h"
#include "displayfile/looks/phong.h"
#include "displayfile/looks/style.h"
#include "displayfile/looks/vertex_shading.h"
#include "displayfile/looks/world_polygon.h"
#include "displayfile/segments/segment.h"

namespace displayfile {

/// What is drawn of a polygon in a view. Valid until the stage's next call, and as long as the
/// attributes that it was viewed with.
struct StagedPolygon {
  ClippedPolygon polygon;  ///< no vertices: nothing is drawn
  const FillStyle* fill = nullptr;
  const LineStyle* line = nullptr;  ///< of its sides
  const Light* light = nullptr;     ///< null: there is none

  VertexShading shading() const { return {polygon.intensities, polygon.normals, light}; }
};

/// The one way from world coordinates to a view, for polygons as they are entered and for a
/// retained scene in a new view: through the clip pipeline, checked for a back face (the end of
/// algorithm 9.2) and lit; and from there into the instructions of a segment.
class PolygonStage {
 public:
  explicit PolygonStage(const ViewVolume& volume) : pipeline_(volume) {}
  /// From here on in another view.
  void set_volume(const ViewVolume& volume) { pipeline_.set_volume(volume); }

  StagedPolygon view_polygon(const WorldPolygon& polygon, const Attributes& attributes);

  /// To be called when another segment is entered into or the attributes are others than in the
  /// last call: a style is entered only then, but for fills where there is light.
  void attributes_changed() { fill_entered_ = line_entered_ = false; }

  /// True if something of the polygon was entered: it is neither outside nor a back face that is
  /// removed.
  bool enter_polygon(const WorldPolygon& polygon, const Attributes& attributes, Segment& segment);
  /// Views vertices that several polygons share, once each, for enter_shared; they are numbered
  /// from `first` on.
  void view_vertices(std::span<const Point3> world, std::uint32_t first = 0);
  /// The same vertices as they were entered, before the modelling transformation of that matrix;
  /// null: in world coordinates. Both must stay as long as the vertices are entered.
  void note_entered(std::span<const Point3> vertices, const glm::dmat4x3* modelling,
                    Segment& segment);
  /// A triangle of such vertices.
  struct SharedTriangle {
    std::array<std::uint32_t, 3> corners;      ///< their numbers
    std::array<std::uint8_t, 3> edge_visible;  ///< 0 or 1, of the side that ends at the vertex
    std::int32_t pick;
  };
  /// Enters it in little time if it needs no clipping and has neither smooth shading nor shadows;
  /// `world` are all vertices. True if it was entered, false if nothing of it is inside or it is a
  /// back face that is removed, nothing if it needs more: enter_shared.
  std::optional<bool> enter_triangle(std::span<const Point3> world, const SharedTriangle& triangle,
                                     const Attributes& attributes, Segment& segment);
  /// A polygon whose vertices are those of these numbers among the ones viewed last. True if
  /// something of it was entered.
  bool enter_shared(std::span<const std::uint32_t> corners, const WorldPolygon& polygon,
                    const Attributes& attributes, Segment& segment);
  /// The line style is not none. False if nothing of the line is inside.
  bool enter_line(const Point3& from, const Point3& to, const LineStyle& style, Segment& segment);

  /// A text at a point, in the attributes' line style and text style. False if the point is
  /// outside.
  bool enter_text(const Point3& anchor, std::string_view characters, const Attributes& attributes,
                  Segment& segment);

  ClipPipeline& pipeline() { return pipeline_; }

 private:
  struct Outcodes {
    Outcode any, all;  ///< of corners: the bits of one, and those of each
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
  GouraudLighting gouraud_;
  PhongNormals phong_;
  FillStyle lit_;
  // The segment has these styles of the attributes; where there is light, each polygon's own fill.
  bool fill_entered_ = false, line_entered_ = false;
  std::vector<PipelineVertex> shared_;
  std::uint32_t first_shared_ = 0;
  std::span<const Point3> entered_shared_;  // the same vertices, if they were noted
  const glm::dmat4x3* modelling_of_shared_ = nullptr;
  std::vector<Point3> device_;           // of a polygon
  std::vector<std::uint8_t> all_edges_;  // ones
  std::vector<std::uint8_t> no_edges_;   // zeros
};

}  // namespace displayfile
