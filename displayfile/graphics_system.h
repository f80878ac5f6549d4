#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "clip/cutting_planes.h"
#include "clip/transformation.h"
#include "clip/view.h"
#include "clip/window_fit.h"
#include "clip/work_budget.h"
#include "displayfile/display_file.h"
#include "displayfile/hidden_scope.h"
#include "displayfile/looks/attributes.h"
#include "displayfile/looks/background.h"
#include "displayfile/looks/shading.h"
#include "displayfile/looks/style.h"
#include "displayfile/picture_windows.h"
#include "displayfile/recorder.h"
#include "displayfile/retained_scene.h"
#include "displayfile/said_settings.h"
#include "displayfile/solids/cut_faces.h"
#include "displayfile/solids/open_solids.h"
#include "displayfile/solids/solid_operation.h"
#include "displayfile/surface_grid.h"
#include "displayfile/view_stage.h"
#include "hidden/exact/precision.h"
#include "hidden/hidden_lines.h"
#include "hidden/hidden_method.h"
#include "hidden/line_kinds.h"
#include "hidden/sort/hidden_surface_sort.h"
#include "hidden/triangulation.h"

namespace displayfile {

/// The application API: the textbook's user routines, under their names in drawing programs
/// with underscores for hyphens. One object that the caller owns; no globals.
///
/// Every routine throws Error for a call that cannot be carried out; the state is then what
/// it was before the call. Coordinates are world coordinates (before the modelling
/// transformation) unless said otherwise, angles degrees, colours in [0,1].
class GraphicsSystem {
 public:
  static constexpr std::size_t kLongestText = 65535;

  // View parameters (clip/view.h says what each means and refuses). They take effect when a
  // segment is opened; setting one while a segment is open is an error.
  void set_view_reference_point(const Point3& p);
  void set_view_plane_normal(const Point3& n);
  void set_view_distance(double d);
  void set_view_up(const Point3& up);
  void set_parallel(const Point3& direction);
  void set_perspective(const Point3& centre);
  void set_view_depth(double front, double back);
  void set_front_plane_clipping(bool on);
  void set_back_plane_clipping(bool on);
  void set_window(double x_min, double x_max, double y_min, double y_max);
  void set_viewport(double x_min, double x_max, double y_min, double y_max);
  /// What becomes of a window whose shape is not that of its viewport in the picture. As long as
  /// this was not said, a window is widened unless the application set it, or the viewport: then
  /// it is stretched. view() tells the window as it was set.
  void set_window_fit(WindowFit fit);
  /// The width over the height of the pictures that segments opened from now on will be drawn as
  /// [1]. It is a matter of the device and not recorded: whoever replays says it again. Errors: not
  /// a positive number up to kCoordinateLimit, a segment is open.
  void set_aspect_ratio(double aspect);

  // The modelling transformation (clip/transformation.h).
  void create_transformation_3();
  void translate_3(double tx, double ty, double tz);
  void scale_3(double sx, double sy, double sz);
  void rotate_x_3(double angle);
  void rotate_y_3(double angle);
  void rotate_z_3(double angle);
  /// What is in force is saved, on a stack. It stays in force, and what is called next acts before
  /// it: in a part's own coordinates. The stack does not know segments: a part's may be several,
  /// and what is not restored stays saved. Error: kMostSaved are saved.
  void save_transformation_3();
  /// The transformation is again what it was when it was saved last. Error: none is saved.
  void restore_transformation_3();
  static constexpr std::size_t kMostSaved = 1024;

  // Segments. Names are positive integers.
  /// CREATE-SEGMENT. Errors: a segment is open, the name is in use or not positive, the view
  /// parameters do not fit together (clip/view_volume.h).
  void open_segment(int name);
  /// Sorts the segment's hidden surfaces if hidden-line removal is on, by a method that sorts
  /// and with a scope that is not `all`. Error: no segment open.
  void close_segment();
  /// Calls enter(), which opens segments, enters primitives into them and closes them, while none
  /// is open. If it throws, nothing of that is left: no segment, and the current position, the
  /// ordinals, the attributes, the modelling transformation, the background and what is recorded
  /// are those of before. It is no place to set other things, which would stay.
  template <class Enter>
  void enter_segments(Enter&& enter) {
    const Entered before = entered();
    Recorder::Hold recorded(recorder_);
    try {
      enter();
      recorded.end();
    } catch (...) {
      take_back(before);
      throw;
    }
  }
  /// Errors: no such segment, segment still open.
  void delete_segment(int name);
  /// Error: segment still open.
  void delete_all_segments();
  /// Errors: no such segment, new name in use, segment still open.
  void rename_segment(int from, int to);
  /// Error: no such segment, as in the routines of the image transformation.
  void set_visibility(int name, bool on);
  /// The image transformation, in normalised device coordinates: scale about the image's centre,
  /// then rotate about it, then translate. Each routine sets its own part; the centre is the origin
  /// unless it is set.
  void set_image_translation(int name, double tx, double ty);
  void set_image_scale(int name, double sx, double sy);
  void set_image_rotation(int name, double angle);
  void set_image_centre(int name, double x, double y);  ///< Error: more than 1e9 in magnitude.

  // Primitives. Error: no segment open; a coordinate that is not finite or exceeds
  // kCoordinateLimit in world coordinates. The 2D routines keep the current position's z.
  void move_abs_3(double x, double y, double z);
  void line_abs_3(double x, double y, double z);
  void move_rel_3(double dx, double dy, double dz);
  void line_rel_3(double dx, double dy, double dz);
  void move_abs_2(double x, double y);
  void line_abs_2(double x, double y);
  void move_rel_2(double dx, double dy);
  void line_rel_2(double dx, double dy);
  /// A polygon of 3 or more sides, concave or self-crossing (filled even-odd). It starts, and
  /// leaves the current position, at its last vertex. In the _rel routines each vertex is
  /// given relative to the one before, the first to the current position. Error: fewer than
  /// 3 sides.
  void polygon_abs_3(std::span<const Point3> vertices);
  void polygon_abs_3(std::initializer_list<Point3> vertices) { polygon_abs_3(span(vertices)); }
  void polygon_rel_3(std::span<const Point3> steps);
  void polygon_rel_3(std::initializer_list<Point3> steps) { polygon_rel_3(span(steps)); }
  void polygon_abs_2(std::span<const Point2> vertices);
  void polygon_abs_2(std::initializer_list<Point2> vertices) { polygon_abs_2(span(vertices)); }
  void polygon_rel_2(std::span<const Point2> steps);
  void polygon_rel_2(std::initializer_list<Point2> steps) { polygon_rel_2(span(steps)); }

  /// Many polygons at once, as so many calls of polygon_abs_3 enter them, one after another, but
  /// several times as fast. `corners` are indices into `vertices`, polygon after polygon: sides[k]
  /// of polygon k, or 3 of each if `sides` is empty. Polygons may share vertices. `fills` are of
  /// one style for all or of one for each; if empty, the style in force. The style in force stays
  /// what it was. Errors, before any polygon is entered: those of polygon_abs_3 and
  /// set_fill_style, an index that is not of a vertex, counts that do not agree, normals that
  /// set_vertex_normals has set.
  void polygons_abs_3(std::span<const Point3> vertices, std::span<const std::uint32_t> corners,
                      std::span<const std::uint32_t> sides = {},
                      std::span<const FillStyle> fills = {});

  /// The same with more of each polygon: what is not empty is of one for each polygon, or for each
  /// vertex.
  struct ManyPolygons {
    std::span<const Point3> vertices;
    std::span<const std::uint32_t> corners, sides;  ///< as above, and the fills
    std::span<const FillStyle> fills;
    std::span<const std::int32_t> picks;  ///< one each; 0 or more
    std::span<const Point3> normals;      ///< one each vertex, as set_vertex_normals has them
  };
  /// Errors too: a pick identifier below 0, picks or normals that are not so many, those of
  /// set_vertex_normals. The pick identifier in force stays what it was.
  void polygons_abs_3(const ManyPolygons& polygons);

  /// A surface over a grid, as cells of two triangles each, with an invisible diagonal from the
  /// least corner to the greatest. Its curves are the triangles' other sides, in the line style;
  /// those of the other family are as invisible as diagonals, and hide what is behind all the same.
  /// The side that z grows toward is the light face. A cell with an unknown height (NaN) in one of
  /// its corners is left out. Each cell has a pick identifier, as a polygon has. The current
  /// position is then the grid's last point, with z 0 if its height is unknown. Errors, before any
  /// cell is entered: those of require_surface, those of coordinates, normals that
  /// set_vertex_normals has set.
  void surface_3(const SurfaceGrid& grid);

  /// What is entered from here to end_solid is one closed solid, made of its parts in their order
  /// (displayfile/solids/README.md). A part is a shape, closed polygons that one call enters, a
  /// solid within it, or else the polygons between two of these, together. Solids may stand
  /// one within another, OpenSolids::kDeepest deep. Until the outermost ends, nothing is in the
  /// display file. The modelling transformation and the styles are those in force at each polygon,
  /// the cutting planes those in force at the end. Errors: no segment open, too deep.
  void begin_solid(SolidOperation operation = SolidOperation::unite);
  /// Combines the parts; one part alone is the solid as it is. What is left is entered as polygons,
  /// in the styles and with the pick identifiers of those that they are parts of; if that is
  /// nothing, empty_solids counts it. Errors, after which the solid is still open: none is, it has
  /// no part, a part is not closed; and with several parts, one that passes through itself, a
  /// result that is no solid, no library that combines (ExactSolid); cut faces with more than
  /// kMostHatchingLines.
  void end_solid();
  /// The innermost solid is as if it had not begun. Error: none is open.
  void discard_solid();

  /// A text at the current position, which stays: UTF-8, on one line. It is drawn if the position
  /// is within the view volume and, where hidden surfaces are removed, nothing hides it
  /// (interp/truth/truth.md); an image transformation moves it, but does not scale or turn its
  /// letters. Errors: more than kLongestText bytes; not UTF-8, or what cannot be drawn
  /// (control characters; what Unicode says is no character).
  void text(std::string_view characters);

  // Attributes of the primitives that follow.
  void set_fill_style(const FillStyle& style);  ///< Error: a colour outside of [0,1].
  /// Errors: a colour outside of [0,1], width, dash or gap not positive.
  void set_line_style(const LineStyle& style);
  void set_text_style(const TextStyle& style);  ///< Error: a size not above 0, or above 1.
  /// Sets the light: a world direction toward it, of any length but zero; ambient in [0,1]. A
  /// polygon's fill colour is multiplied by ambient + (1 - ambient) max(0, cosine of the angle
  /// between the light and the side of it that is seen).
  void set_light(const Point3& toward, double ambient = 0.2);
  /// Gouraud shading (displayfile/looks/gouraud.md): where there is light, a polygon whose vertices
  /// have normals is lit at each of them, and the intensities are interpolated over its picture.
  /// Phong shading (displayfile/looks/phong.md): the normals are interpolated, and each pixel is
  /// lit; in vectors and by the OSMesa device as with Gouraud shading. One of more than three sides
  /// is entered as triangles whose diagonals are invisible. Any other polygon is shaded flat.
  void set_shading(Shading shading);
  /// Shadows (interp/raster/shadows.md): where there is light, the solid polygons that follow are
  /// drawn in the ambient light alone where a solid polygon hides the light from them, whether that
  /// one was entered with shadows on or off. What is clipped or removed as a back face hides no
  /// light. Pixels show them by every method, vectors by the map (displayfile/lit_parts.md);
  /// vectors of a sort and the OSMesa device draw fills as lit.
  void set_shadows(bool on);
  /// The normals of the vertices of the next polygon, in its order: directions of any length, in
  /// the coordinates of its vertices, as Newell's sums turn out of the light face. Zero stands for
  /// the polygon's own normal. No normals: takes back what was set. With flat shading they have no
  /// effect. Errors: one or two normals; a component that is not finite or exceeds
  /// kCoordinateLimit. A polygon of another number of sides is then an error.
  void set_vertex_normals(std::span<const Point3> normals);
  void set_vertex_normals(std::initializer_list<Point3> normals) {
    set_vertex_normals(span(normals));
  }
  /// Cutting plane n, 1 to 6: of the primitives that follow, in any view, what has
  /// a x + b y + c z + d < 0 is cut away, x y z being world coordinates after the modelling
  /// transformation (clip/cutting_planes.md). Sides that it makes are not drawn, and what it cuts
  /// open stays open but for set_cut_faces. Errors: those of CuttingPlanes::set.
  void set_cutting_plane(int n, double a, double b, double c, double d);
  void set_cutting_plane_off(int n);  ///< Error: n is not 1 to 6.
  /// What becomes of the faces where cutting planes cut closed solids that follow, if a call enters
  /// them whole: shapes, end_solid, polygons_abs_3, meshes [open]. Polygons that are entered one by
  /// one, and what is not closed, stay cut open. A cut face has the styles and, as a polygon, the
  /// pick identifier in force. Errors: a spacing that is not above 0, an angle that is not finite.
  void set_cut_faces(const CutFaces& faces);
  static constexpr double kMostHatchingLines = 100000.0;
  /// Which curves of the surfaces that follow are drawn [both].
  void set_surface_curves(SurfaceCurves curves);
  /// The side whose curves are drawn: where the other one is seen, they hide all the same [both].
  /// A curve between a cell seen from above and one seen from below is drawn if one of its
  /// sides is.
  void set_surface_sides(SurfaceSides sides);
  /// The line style of their lower side; none given: that of set_line_style, which is the upper
  /// side's, in force for the surface. Errors: those of set_line_style.
  void set_lower_line_style(const std::optional<LineStyle>& style);
  /// The pick identifier of the polygons and lines that follow, 0 or more; -1 gives each polygon
  /// its ordinal in the program again, and lines none. Ordinals count from 0 all that is entered,
  /// also what was deleted since, and after 2147483647 from 0 again.
  void set_pick_id(int id);

  /// What the pictures show where nothing is drawn, of all segments. Error: a colour outside of
  /// [0,1].
  void set_background(const Background& background);

  // Hidden surfaces.
  /// Also turns back-face removal on or off, as in the textbook. Off, pictures are in order of
  /// entry. Where neither this nor set_hidden_method was called, segments are entered as they are,
  /// and pictures are those of `automatic`, unless all points have one depth.
  void set_hidden_line_removal(bool on);
  void set_back_face_removal(bool on);
  /// Ray casting in object space, world_ray_cast, reads what was drawn in world coordinates: where
  /// no scene is retained, it is retained in the system from now on. Errors: a method that is not
  /// built yet; that one, if there are segments that were not retained.
  void set_hidden_method(HiddenMethod method);
  /// A scope that is not set is `segment` for segments as they are closed. A segment closed while
  /// it is `all` is sorted by itself when it is drawn, if it is `segment` then.
  void set_hidden_scope(HiddenScope scope);
  /// The precision of the method that finds hidden surfaces. Error: a ROUNDOFF outside of [0,1).
  void set_precision(const Precision& precision);
  /// Whether lines are drawn dashed where they are hidden, by the methods that find lines
  /// (hidden/lines/README.md): as a segment is closed, or when all are looked at together.
  void set_hidden_lines(HiddenLines lines);
  void set_z_buffer(bool on);
  /// Within which distance polygons touch, of segments that are opened from now on
  /// (hidden/touching_planes.md): what touches another's plane lies in it. Error: a length that is
  /// not above 0 and at most kCoordinateLimit.
  void set_touching(const Touching& touching);
  /// Does what set_touching does, and from now on set_touching has no effect, but that its errors
  /// are reported: for what decides in place of the application. It is not recorded.
  void replace_touching(const Touching& touching);

  /// Which sides of polygons are lines (displayfile/line_kinds.md), of the segments that are closed
  /// from now on, whatever the method: what is selected, of what has a line style. Unless that is
  /// `all` alone, where no scene is retained, it is retained in the system from now on. Errors: no
  /// kind, a crease outside of 0 to 180 degrees; there are segments that were not retained.
  void set_lines(const LineSelection& selection);
  /// Does what set_lines does, and from now on set_lines has no effect, but that its errors are
  /// told: for who selects lines in place of the application. It is not recorded.
  void replace_lines(const LineSelection& selection);

  // What the application and the interpreter may ask.
  const DisplayFile& display_file() const { return display_file_; }
  const View& view() const { return view_; }
  const SaidSettings& said() const { return said_; }
  /// By any view-parameter routine.
  bool view_was_set() const;
  double aspect_ratio() const { return windows_.aspect(); }
  /// The worst of the windows that were stretched although the application did not say that they
  /// should be.
  const std::optional<StretchedWindow>& stretched_window() const { return windows_.stretched(); }
  const ModellingTransformation& modelling_transformation() const { return modelling_; }
  /// Where a point of the model is, in the modelling transformation and the view in force: in
  /// normalised device coordinates, before a segment's image transformation, as set_image_centre
  /// takes it and the pixel_at of a picture (interp/device/picture.h). What is outside of the view
  /// volume is told too; nothing if it is not before the eye, or too far out to be told. Errors:
  /// those of a coordinate, and of a view that open_segment refuses.
  std::optional<Point3> to_device(const Point3& p) const;
  const Attributes& attributes() const { return attributes_; }
  const Background& background() const { return background_; }
  std::optional<int> open_segment_name() const { return open_; }
  bool hidden_line_removal() const { return hidden_; }
  bool back_face_removal() const { return attributes_.back_face_removal; }
  Shading shading() const { return attributes_.shading; }
  const CuttingPlanes& cutting_planes() const { return cutting_planes_; }
  SurfaceCurves surface_curves() const { return surface_curves_; }
  SurfaceSides surface_sides() const { return surface_sides_; }
  const std::optional<LineStyle>& lower_line_style() const { return lower_line_; }
  const CutFaces& cut_faces() const { return cut_faces_; }
  /// How many solids are open, one within another.
  std::size_t solids_open() const { return solids_.depth(); }
  /// Calls of end_solid that left nothing of the outermost solid.
  std::int64_t empty_solids() const { return empty_solids_; }
  /// Some segment may have hatching, whose directions are those of the view in which it was
  /// entered.
  bool has_hatching() const { return has_hatching_; }
  /// Whether the call that enters a closed solid makes more of it than its polygons alone.
  bool takes_whole_solids() const {
    return !solids_.empty() || (cut_faces_.kind != CutFaces::Kind::open && cutting_planes_.any());
  }
  /// Calls enter(), which enters the polygons of a closed solid: if takes_whole_solids(), as a
  /// solid of one part. If enter() throws, or end_solid(), the solid is discarded.
  template <class Enter>
  void as_solid(Enter&& enter) {
    if (!takes_whole_solids()) return enter();
    const std::size_t depth = solids_open();
    begin_solid();
    try {
      enter();
      end_solid();
    } catch (...) {
      if (solids_open() > depth) discard_solid();
      throw;
    }
  }
  bool shadows() const { return attributes_.shadows; }
  HiddenMethod hidden_method() const { return method_; }
  std::optional<HiddenScope> hidden_scope() const { return scope_; }  ///< if it was set
  const Precision& precision() const { return sort_options_.precision; }
  HiddenLines hidden_lines() const { return sort_options_.hidden_lines; }
  bool z_buffer() const { return z_buffer_; }
  const Touching& touching() const { return touching_; }
  const LineSelection& lines() const { return lines_; }
  std::size_t transformations_saved() const { return modelling_.saved(); }
  /// Calls of the polygon routines, and cells of surfaces.
  std::int64_t polygons_entered() const { return ordinal_; }
  std::int64_t polygons_triangulated() const { return triangulated_; }  ///< for not being flat

  /// Sets something for the case that the application does not say it: calls set() unless it was
  /// said before, and what set() sets counts as not said.
  template <class Set>
  void by_default(Setting setting, Set&& set) {
    if (said_.contains(setting)) return;
    const SaidSettings said = said_;
    set();
    said_ = said;
  }
  /// Calls enter(), which opens and closes segments. Where touching is automatic the reach of what
  /// they hold is this one, in the coordinates of the input: that of numbers which are less exact
  /// than doubles.
  template <class Enter>
  void with_automatic_reach(double reach, Enter&& enter) {
    if (touching_.kind != Touching::Kind::automatic) return enter();
    put_touching_in_force({Touching::Kind::length, reach});
    try {
      enter();
    } catch (...) {
      touching_ = {Touching::Kind::automatic};
      throw;
    }
    put_touching_in_force({Touching::Kind::automatic});
  }
  /// Calls enter(), which may set fill styles for what it enters; the one in force before is in
  /// force afterwards, also if enter() throws, and counts as said if it did.
  template <class Enter>
  void keep_fill_style(Enter&& enter) {
    const FillStyle in_force = attributes_.fill;
    const SaidSettings said = said_;
    const auto restore = [&] {
      if (attributes_.fill != in_force) set_fill_style(in_force);
      said_ = said;
    };
    try {
      enter();
    } catch (...) {
      restore();
      throw;
    }
    restore();
  }

  /// Calls change(), which may call any routines. If it throws, all is as before, and nothing of it
  /// is recorded. What the application retains in a scene of its own stays there.
  template <class Change>
  auto all_or_nothing(Change&& change) {
    GraphicsSystem before(*this);
    Recorder::Hold recorded(recorder_);
    try {
      if constexpr (std::is_void_v<decltype(change())>) {
        change();
        recorded.end();
      } else {
        auto result = change();
        recorded.end();
        return result;
      }
    } catch (...) {
      *this = std::move(before);
      throw;
    }
  }

  /// Sets the threads of close_segment's sort, whose result is the same for any number of them.
  void set_threads(int threads) { sort_options_.threads = threads; }
  /// Is told, if not empty, of lines that close_segment looks at by a method that finds lines. What
  /// it throws comes out of close_segment; the segment is then open still, with all that is in it.
  void set_progress(WorkProgress progress) { sort_options_.progress = std::move(progress); }

  /// What close_segment may use at most, and a way to stop it: it then throws LimitReached, and the
  /// segment is open still, with all that is in it. The budget must live on; null takes it back.
  /// For all that a thread does: BudgetInForce (clip/work_budget.h).
  void set_budget(WorkBudget* budget) { budget_ = budget; }

  /// Records every routine that succeeds from now on; null stops. The recorder must live on.
  void set_recorder(Recorder* recorder) { recorder_ = recorder; }
  /// A remark in what is recorded, on a line of its own; it does nothing else.
  void comment(std::string_view text) {
    if (recorder_ != nullptr) recorder_->comment(text);
  }

  /// Keeps what is drawn in world coordinates too, from now on; null stops. The scene must live
  /// on. Errors: there are segments already; to stop where set_lines needs what is retained.
  void retain(RetainedScene* scene);
  /// The same in a scene of the system's own, retained(), which all_or_nothing puts back too.
  /// Error: there are segments already that were not retained.
  void retain();
  /// The same, but what is drawn is kept there alone: the display file has its segments, with
  /// nothing in them. For who draws views of the scene (displayfile/scene_viewer.h), which writes a
  /// display file for who asks.
  void retain_alone(RetainedScene& scene);
  /// What is drawn is in the retained scene alone.
  bool retains_alone() const { return retains_alone_; }
  /// What is retained, by retain, set_hidden_method or set_lines; null if nothing is.
  const RetainedScene* retained() const { return own_retained_ ? &*own_retained_ : retained_; }

 private:
  struct Pen {
    Point3 object{0.0};  ///< the current position as the application gave it
    Point3 world{0.0};   ///< the same after the modelling transformation of that time
  };

  /// What entering primitives changes beside the segments, and what may be set meanwhile.
  struct Entered {
    std::size_t segments;
    Pen pen;
    std::int64_t ordinal, triangulated, empty_solids;
    std::int32_t pick;
    bool has_hatching;
    SaidSettings said;
    ModellingTransformation modelling;
    Attributes attributes;
    Background background;
    std::vector<Point3> vertex_normals;
    CuttingPlanes cutting_planes;
    CutFaces cut_faces;
    SurfaceCurves surface_curves;
    SurfaceSides surface_sides;
    std::optional<LineStyle> lower_line;
  };
  Entered entered() const;
  void take_back(const Entered& before);

  template <class T>
  static std::span<const T> span(std::initializer_list<T> list) {
    return {list.begin(), list.size()};
  }
  void record(std::string_view routine, std::initializer_list<Recorder::Argument> arguments) {
    if (recorder_ != nullptr) recorder_->write(routine, arguments);
  }
  void record_touching(const Touching& touching);
  void put_touching_in_force(const Touching& touching);
  void record_said(Setting setting, std::string_view routine,
                   std::initializer_list<Recorder::Argument> arguments) {
    said_.insert(setting);
    record(routine, arguments);
  }
  static LineStyle require_line_style(const LineStyle& style);
  void record_line_style(std::string_view routine, const LineStyle& style);
  void require_open() const;
  void require_view_may_change() const;
  int next_pick() const;
  Point3 to_world(const Point3& object) const;
  void move_to(const Point3& object);
  void line_to(const Point3& object);
  void polygon(std::span<const Point3> object);
  void enter(const WorldPolygon& polygon);
  void enter_cut(const WorldPolygon& polygon);
  void enter_solid(const SolidFaces& whole, double spacing);
  void enter_face(const SolidFaces& solid, std::size_t i, bool is_to_be_cut);
  struct Hatching {
    double spacing;
    bool is_there;  ///< its face is, in the view
  };
  void enter_hatching(const SolidFaces& solid, std::size_t face, const Hatching& hatching);
  void enter_world_line(const Point3& from, const Point3& to, bool is_there = true);
  double hatching_spacing(const SolidFaces& solid) const;
  bool hatches_cut_faces() const;
  void require_no_solid(std::string_view what) const;
  void enter_whole(const WorldPolygon& polygon);
  std::span<const Point3> shared_world(std::span<const Point3> vertices);
  void make_room_for_shared(const RetainedScene::SharedVertices& shared, std::size_t polygons,
                            std::size_t corners, std::size_t fills);
  void enter_shared(const RetainedScene::SharedVertices& vertices,
                    std::span<const std::uint32_t> corners, Segment& segment);
  void enter_with_normals(std::span<const Point3> vertices, std::span<const Point3> normals,
                          std::span<const std::uint32_t> corners);
  /// What is entered goes into the retained scene alone, at least until the segment is closed.
  bool is_viewed_later() const { return retains_alone_ || views_at_close_; }
  RetainedScene* retaining() { return own_retained_ ? &*own_retained_ : retained_; }
  void retain_for(std::string_view what);
  std::optional<Segment> with_lines_selected(int name);
  void close(Segment& segment);
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
  std::span<const Point3> world_normals(const Point3& own);
  std::vector<Point3> world_points_of(const SurfaceGrid& grid) const;
  void enter_cells(const SurfaceGrid& grid, std::span<const Point3> world, Segment& segment);
  void enter_cells_in_order(const SurfaceGrid& grid, std::span<const Point3> world,
                            Segment& segment);
  struct SurfaceCell {
    int i, j;
    std::int64_t ordinal;
  };
  void enter_cell(const SurfaceGrid& grid, std::span<const Point3> world, const SurfaceCell& cell,
                  Segment& segment);

  View view_;
  PictureWindows windows_;
  SaidSettings said_;
  ModellingTransformation modelling_;
  DisplayFile display_file_;
  std::optional<int> open_;
  std::optional<ViewStage> view_stage_;  // of the open segment
  Pen pen_;
  Attributes attributes_;
  Background background_;
  std::vector<Point3> vertex_normals_;  // of the next polygon, as the application gave them
  CuttingPlanes cutting_planes_;
  CutFaces cut_faces_;
  OpenSolids solids_;
  struct BeforeSolid {
    Pen pen;
    std::int64_t ordinal, triangulated;
  };
  std::vector<BeforeSolid> before_solids_;  // of each that is open
  std::int64_t empty_solids_ = 0;
  bool has_hatching_ = false;  // since all segments were deleted
  Touching touching_ = kUnlessSet;
  bool touching_replaced_ = false;
  SurfaceCurves surface_curves_ = SurfaceCurves::both;
  SurfaceSides surface_sides_ = SurfaceSides::both;
  std::optional<LineStyle> lower_line_;
  std::int32_t pick_ = -1;
  std::int64_t ordinal_ = 0, triangulated_ = 0;
  bool hidden_ = false, z_buffer_ = false;
  HiddenMethod method_ = HiddenMethod::automatic;
  std::optional<HiddenScope> scope_;
  SortOptions sort_options_;
  LineSelection lines_;
  bool lines_replaced_ = false;
  WorkBudget* budget_ = nullptr;
  Recorder* recorder_ = nullptr;
  RetainedScene* retained_ = nullptr;          // the application's
  std::optional<RetainedScene> own_retained_;  // in its place, for world_ray_cast and set_lines
  bool retains_alone_ = false;
  bool views_at_close_ = false;            // lines were selected when the segment was opened
  RetainedPolygons::Place retained_in_{};  // the arrays that segments have polygons in

  Triangulation triangulation_;
  std::vector<Point3> object_points_, world_points_;  // of the polygon being entered
  std::vector<Point3> world_normals_;                 // of its vertices
  std::vector<Point3> shared_world_;                  // vertices that polygons share
};

}  // namespace displayfile
