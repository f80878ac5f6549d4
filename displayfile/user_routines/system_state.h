#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/mat4x3.hpp>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "clip/geometry/back_face.h"
#include "clip/geometry/crease_angle.h"
#include "clip/pipeline/cutting_planes.h"
#include "clip/view/transformation.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/looks/colour_pieces.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/polygon_stage.h"
#include "displayfile/segments/retained_scene.h"
#include "displayfile/solids/open_solids.h"
#include "displayfile/user_routines/plane_uses.h"
#include "displayfile/views/picture_windows.h"
#include "hidden/sort/hidden_surface_sort.h"
#include "hidden/triangles/triangulation.h"

namespace displayfile {

class SurfaceNormals;

/// The state of a GraphicsSystem, and the steps that its routines share.
struct GraphicsSystem::State {
  struct Pen {
    Point3 object{0.0};  ///< the current position as passed by the application
    Point3 world{0.0};   ///< the same after the modelling transformation then in force
  };

  /// All state that entering primitives changes besides the segments, and settings made meanwhile.
  struct Entered {
    std::size_t segments, segments_opened;
    Pen pen;
    std::int64_t ordinal, triangulated, empty_solids;
    std::int32_t pick;
    bool has_hatching;
    ExplicitSettings explicit_settings;
    ModellingTransformation modelling;
    Looks looks;
    std::vector<Point3> vertex_normals;
    std::vector<Colour> vertex_colours;
    CuttingPlanes cutting_planes;
    PlaneUses plane_uses;
  };
  struct AnnotationEntry;
  Entered entered() const;
  void take_back(const Entered& before);

  void record(std::string_view routine, std::initializer_list<Recorder::Argument> arguments) {
    if (recorder_ != nullptr) recorder_->write(routine, arguments);
  }
  void require(const HiddenSurfaceOptions& options);
  void record_touching(const Touching& touching);
  void record_setting(Setting setting, std::string_view routine,
                      std::initializer_list<Recorder::Argument> arguments) {
    explicit_.insert(setting);
    record(routine, arguments);
  }
  static LineStyle require_line_style(const LineStyle& style);
  void record_line_style(std::string_view routine, const LineStyle& style);
  void change_line_kind_style(StyledLines lines, const LineKindStyle& style);
  void replace_width(LineStyle& line) const;
  bool has_replaced_style(StyledLines lines) const {
    return (styles_replaced_ >> static_cast<unsigned>(lines) & 1u) != 0;
  }
  void discard_solid();
  void require_open() const;
  void require_view_may_change() const;
  int next_pick() const;
  Point3 to_world(const Point3& object) const;
  void move_to(const Point3& object);
  void line_to(const Point3& object);
  void polygon(std::span<const Point3> object);
  /// A polygon whose vertices in world coordinates are world_points_.
  struct OnePolygon {
    std::span<const Point3> entered;  ///< its vertices as the application entered them
    Point3 normal;                    ///< as in WorldPolygon
    std::span<const Point3> vertex_normals;
    std::int32_t pick;
    bool is_flat;
  };
  void enter_one(const OnePolygon& polygon);
  void enter_in_colours(const OnePolygon& polygon);
  void enter_colour_pieces(const OnePolygon& polygon);
  void require_no_values_of_vertices(std::string_view before) const;
  void enter(const WorldPolygon& polygon);
  void enter_cut(const WorldPolygon& polygon);
  /// True if a cutting plane cuts away a part of a primitive with these vertices, which is noted.
  template <class Points>
  bool are_cut(const Points& world) {
    set_reach_of_planes();
    CuttingPlanes::Sides sides;
    for (const Point3& p : world) sides.include(cutting_planes_.sides(p));
    plane_uses_.met(cutting_planes_.on(), sides.outside, sides.outside & ~sides.inside);
    return sides.outside != 0;
  }
  void note_planes_met(const SolidFaces& solid);
  void set_reach_of_planes();
  /// Calls enter(), which enters the polygons of a closed solid of this volume, below 0 if their
  /// light faces are inward: faces in a cutting plane whose solid is cut away are omitted.
  void as_faces_of_solid(double volume, const std::function<void()>& enter);
  /// True if such a polygon lies in a cutting plane that cuts away the solid behind it.
  template <class Points>
  bool is_face_of_cut_away(const Points& world) {
    if (volume_of_faces_ == 0.0 || !cutting_planes_.any()) return false;
    set_reach_of_planes();
    for (int n = 1; n <= CuttingPlanes::kMost; ++n) {
      if (!cutting_planes_.is_on(n)) continue;
      bool is_in_plane = true;
      for (const Point3& p : world) {
        is_in_plane = is_in_plane && cutting_planes_.distance(n, p) == 0.0;
      }
      if (!is_in_plane) continue;
      const double light = glm::dot(newell_normal(world), cutting_planes_.unit_plane(n).normal);
      if (!(volume_of_faces_ > 0.0 ? light > 0.0 : light < 0.0)) continue;
      const unsigned bit = 1u << (n - 1);
      plane_uses_.met(bit, bit, bit);
      return true;
    }
    return false;
  }
  void enter_solid(const SolidFaces& whole, double spacing);
  void enter_face(const SolidFaces& solid, std::size_t i, bool is_to_be_cut);
  struct Hatching {
    double spacing;
    bool is_there;  ///< its face is in the view
  };
  LineStyle hatching_style() const;
  void enter_hatching(const SolidFaces& solid, std::size_t face, const Hatching& hatching);
  void enter_world_line(const Point3& from, const Point3& to, bool is_there = true);
  double hatching_spacing(const SolidFaces& solid) const;
  bool hatches_cut_faces() const;
  bool takes_whole_solids() const;
  void require_no_solid(std::string_view what) const;
  void enter_whole(const WorldPolygon& polygon);
  std::span<const Point3> shared_world(std::span<const Point3> vertices);
  void make_room_for_shared(const RetainedScene::SharedVertices& shared, std::size_t polygons,
                            std::size_t corners, std::size_t fills);
  void enter_shared(const RetainedScene::SharedVertices& vertices,
                    std::span<const std::uint32_t> corners, Segment& segment);
  /// True if primitives go into the retained scene only, at least until the segment is closed.
  bool is_viewed_later() const { return retains_alone_ || views_at_close_ || views_on_demand_; }
  const RetainedScene* retained() const { return own_retained_ ? &*own_retained_ : retained_; }
  RetainedScene* retaining() { return own_retained_ ? &*own_retained_ : retained_; }
  void retain_for(std::string_view what);
  std::optional<Segment> with_lines_selected(int name);
  void close(Segment& segment);
  void sort(Segment& whole) const;
  void keep_entered_once(Segment& closing);
  void follow_retained();
  void attributes_changed() {
    if (view_stage_) view_stage_->attributes_changed();
  }
  /// The matrix of the modelling transformation; null if that is the identity.
  const glm::dmat4x3* modelling_matrix() const {
    return modelling_.is_identity() ? nullptr : &modelling_.affine();
  }
  void enter_triangles(std::span<const Point3> entered, const Point3& normal,
                       std::span<const Point3> vertex_normals, int pick);
  /// For a polygon, one per corner of its triangles.
  struct Corners {
    std::span<const Point3> world, entered, normals;  ///< normals may be empty
  };
  void enter_triangles(std::span<const Triangulation::Triangle> triangles, const Corners& all,
                       const Point3& normal, int pick);
  std::span<const Point3> world_normals(const Point3& own);
  std::vector<Point3> world_points_of(const SurfaceGrid& grid) const;
  void enter_cells(const SurfaceGrid& grid, std::span<const Point3> world, Segment& segment);
  void enter_cells_in_order(const SurfaceGrid& grid, std::span<const Point3> world,
                            Segment& segment);
  struct SurfaceCell {
    int i, j;
    std::int64_t ordinal;
    const SurfaceNormals* normals;  ///< null: shaded flat
  };
  void enter_cell(const SurfaceGrid& grid, std::span<const Point3> world, const SurfaceCell& cell,
                  Segment& segment);

  View view_;
  PictureWindows windows_;
  ExplicitSettings explicit_;
  ModellingTransformation modelling_;
  std::vector<Point3> places_;  // where segments are moved to, in the order of their opening
  std::size_t segments_opened_ = 0;
  DisplayFile display_file_;
  std::optional<int> open_;
  std::optional<PolygonStage> view_stage_;  // of the open segment
  Pen pen_;
  Looks looks_;
  std::vector<Point3> vertex_normals_;  // of the next polygon, as passed
  std::vector<Colour> vertex_colours_;  // likewise
  CuttingPlanes cutting_planes_;
  PlaneUses plane_uses_;
  double volume_of_faces_ = 0.0;  // in as_faces_of_solid
  OpenSolids solids_;
  struct BeforeSolid {
    Pen pen;
    std::int64_t ordinal, triangulated;
  };
  std::vector<BeforeSolid> before_solids_;  // of each that is open
  std::int64_t empty_solids_ = 0;
  bool has_hatching_ = false;   // since all segments were deleted
  bool is_all_in_view_ = true;  // as far as known without a check
  bool touching_replaced_ = false;
  std::int32_t pick_ = -1;
  std::int64_t ordinal_ = 0, triangulated_ = 0;
  HiddenSurfaces surfaces_;  // with threads and progress of close_segment
  bool lines_replaced_ = false;
  unsigned styles_replaced_ = 0;          // a bit for each StyledLines
  std::optional<double> width_replaced_;  // of line styles
  Recorder* recorder_ = nullptr;
  Recorder* last_recorder_ = nullptr;          // only to detect another one
  AnnotationStyle recorded_annotation_;        // the style that a replay of its recording has
  RetainedScene* retained_ = nullptr;          // the application's
  std::optional<RetainedScene> own_retained_;  // the system's, for world_ray_cast and set_lines
  bool retains_alone_ = false;
  bool views_on_demand_ = false;           // by SystemInside::view_again
  bool views_at_close_ = false;            // lines were selected at open_segment
  RetainedPolygons::Place retained_in_{};  // the arrays that segments have polygons in

  Triangulation triangulation_;
  Triangulation::SeenAlong bent_polygons_seen_ = Triangulation::SeenAlong::nearest_axis;
  std::vector<Point3> object_points_, world_points_;  // of the polygon being entered
  std::vector<Point3> world_normals_;                 // of its vertices
  ColourPieces colour_pieces_;                        // of one of its triangles
  std::vector<Point3> shared_world_;                  // vertices that polygons share
};

}  // namespace displayfile
