#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

#include "clip/base/work_budget.h"
#include "clip/surfaces.h"
#include "clip/view.h"
#include "displayfile/looks/style.h"

namespace displayfile {

class DisplayFile;
class ModellingTransformation;
class Recorder;
class RetainedScene;

// What the user routines take and return.

/// Points in a row: a vector, an array, a span or a list in braces. It refers to them.
template <class Point>
class PointList : public std::span<const Point> {
 public:
  PointList() = default;
  PointList(std::initializer_list<Point> list)
      : std::span<const Point>(list.begin(), list.size()) {}
  template <class Points>
  requires std::is_convertible_v<const Points&, std::span<const Point>> PointList(
      const Points& points)
      : std::span<const Point>(points) {}
};

/// Polygons that may share vertices. Fields other than the first two may be empty.
struct ManyPolygons {
  std::span<const Point3> vertices = {};
  std::span<const std::uint32_t> corners = {};  ///< indices into vertices, polygon after polygon
  std::span<const std::uint32_t> sides = {};    ///< of each polygon; empty: 3 of each
  std::span<const FillStyle> fills = {};        ///< one for all, or one each; empty: that in force
  std::span<const std::int32_t> picks = {};     ///< one each; 0 or more
  std::span<const Point3> normals = {};         ///< one each vertex, as in set_vertex_normals
};

/// A surface z = F(x, y) over a grid: points (x, y, z) with x at `x_points` even steps from x_min
/// to x_max, y likewise. In world coordinates, before the modelling transformation.
struct SurfaceGrid {
  double x_min, x_max;
  int x_points;
  double y_min, y_max;
  int y_points;
  std::span<const double> heights;  ///< z, x fastest; NaN where there is no surface

  std::size_t cells() const {
    return static_cast<std::size_t>(x_points - 1) * static_cast<std::size_t>(y_points - 1);
  }
  /// True if the heights of the four corners of cell (i, j) are known.
  bool has_cell(int i, int j) const {
    assert(0 <= i && i + 1 < x_points && 0 <= j && j + 1 < y_points);
    const auto width = static_cast<std::size_t>(x_points);
    const std::size_t at = static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i);
    const auto is_known = [&](std::size_t k) { return heights[k] == heights[k]; };  // not NaN
    return is_known(at) && is_known(at + 1) && is_known(at + width) && is_known(at + width + 1);
  }
  /// The ends of the range are met exactly.
  double x(int i) const { return at(x_min, x_max, x_points, i); }
  double y(int j) const { return at(y_min, y_max, y_points, j); }

 private:
  static double at(double low, double high, int points, int k) {
    const double part = static_cast<double>(k) / (points - 1);
    return k == points - 1 ? high : low + (high - low) * part;
  }
};

/// Throws Error unless there are 2 points or more each way, ranges are finite and rise, there is a
/// height for each point, and none of them is infinite.
void require_surface(const SurfaceGrid& grid);

/// Which curves of a surface are drawn as lines: those of x run along x, with y the same.
enum class SurfaceCurves { x, y, both };

/// The sides of a surface whose curves are drawn: the upper one is that which z grows toward.
enum class SurfaceSides { upper, lower, both };

/// Reads `x`, `y` or `both`; throws Error for anything else.
SurfaceCurves surface_curves(std::string_view text);
std::string_view name_of(SurfaceCurves curves);

/// Reads `upper`, `lower` or `both`; throws Error for anything else.
SurfaceSides surface_sides(std::string_view text);
std::string_view name_of(SurfaceSides sides);

/// How surfaces over grids are drawn.
struct SurfaceLooks {
  SurfaceCurves curves = SurfaceCurves::both;
  SurfaceSides sides = SurfaceSides::both;
  std::optional<LineStyle> lower_line = std::nullopt;  ///< none: as on the upper side
};

/// Combinations of solids: of the first one with the second, of the result with the third, and so
/// on.
enum class SolidOperation {
  unite,       ///< all that is in any of them
  intersect,   ///< all that is in each of them
  difference,  ///< all that is in the first, but in none of the others
};

/// Reads `union`, `intersection` or `difference`; throws Error for anything else.
SolidOperation solid_operation(std::string_view text);
std::string_view name_of(SolidOperation operation);

/// The faces where cutting planes cut solids that are entered whole
/// (displayfile/solids/cut_solid.md).
struct CutFaces {
  enum class Kind {
    open,     ///< there are none: the inside is seen
    closed,   ///< polygons, in the styles in force
    hatched,  ///< the same, and lines on them
  };
  Kind kind = Kind::open;
  /// Between hatching lines, in world units; none: a twenty-fourth of the longest side of the box
  /// around the solid.
  std::optional<double> spacing{};
  /// The angle of hatching lines, in degrees, counterclockwise from where the plane is level, seen
  /// from the side that is cut away.
  double angle = 45.0;
};

/// The word for a spacing that is not given.
inline constexpr std::string_view kUsualSpacing = "usual";

/// Reads `open`, `closed` or `hatched`; throws Error for anything else.
CutFaces::Kind cut_faces_kind(std::string_view text);
std::string_view name_of(CutFaces::Kind kind);

/// How hidden surfaces are found, as an application has set it.
struct HiddenSurfaces {
  bool removal = false;   ///< set-hidden-line-removal
  bool z_buffer = false;  ///< set-z-buffer
  HiddenMethod method = HiddenMethod::automatic;
  std::optional<HiddenScope> scope = std::nullopt;  ///< none: `segment` as segments are closed
  Precision precision = {};
  HiddenLines hidden_lines = HiddenLines::none;
  LineSelection lines = {};
  Touching touching = kUnlessSet;
};

/// The settings to be made of how hidden surfaces are found; those without a value stay as they
/// are. Each is a routine of drawing programs, and recorded as such.
struct HiddenSurfaceSettings {
  /// Also turns back-face removal on or off, as in the textbook. Off, pictures are in order of
  /// entry. Where neither this nor `method` was ever set, segments are entered as they are, and
  /// pictures are those of `automatic`, unless all points have one depth.
  std::optional<bool> removal = std::nullopt;
  /// The z-buffer draws, whatever the method.
  std::optional<bool> z_buffer = std::nullopt;
  /// Ray casting in object space, world_ray_cast, reads what was drawn in world coordinates: where
  /// no scene is retained, it is retained in the system from now on. Errors: an unknown method;
  /// world_ray_cast, if there are segments that were not retained.
  std::optional<HiddenMethod> method = std::nullopt;
  /// A segment closed while it is `all` is sorted by itself when it is drawn, if it is `segment`
  /// then.
  std::optional<HiddenScope> scope = std::nullopt;
  /// Error: a ROUNDOFF outside of [0,1).
  std::optional<Precision> precision = std::nullopt;
  /// Lines are drawn dashed where they are hidden, or not at all, by the methods that find lines
  /// (hidden/lines/README.md): as a segment is closed, or when all are looked at together.
  std::optional<HiddenLines> hidden_lines = std::nullopt;
  /// The sides of polygons that are lines (displayfile/segments/line_kinds.md), of the segments
  /// that are closed from now on, whatever the method: those selected, of those with a line style.
  /// Unless that is `all` alone, where no scene is retained, it is retained in the system from now
  /// on. Errors: no kind, a crease outside of 0 to 180 degrees; there are segments that were not
  /// retained.
  std::optional<LineSelection> lines = std::nullopt;
  /// Within which distance polygons touch, of segments that are opened from now on
  /// (hidden/touching/touching_planes.md): a polygon that touches another's plane lies in it.
  /// Error: a length that is not above 0 and at most kCoordinateLimit.
  std::optional<Touching> touching = std::nullopt;
};

/// A window that is mapped to a viewport of another shape, width over height, in the picture.
struct StretchedWindow {
  int segment;  ///< that was opened with it
  double window, viewport;
};

/// Counts of a system.
struct SystemCounts {
  std::int64_t polygons = 0;      ///< calls of the polygon routines, and cells of surfaces
  std::int64_t triangulated = 0;  ///< polygons cut into triangles, since they are not flat
  std::size_t solids_open = 0;    ///< one within another
  std::int64_t empty_solids = 0;  ///< calls of end_solid that left nothing of the outermost solid
  std::size_t transformations_saved = 0;
  /// Some segment may have hatching, whose directions are those of the view in which it was
  /// entered.
  bool has_hatching = false;
};

/// Settings that have a default, which holds until the application sets them; a mesh brings
/// defaults of its own (displayfile/mesh/mesh.h).
enum class Setting {
  camera,  ///< reference point, normal, distance and up of the view plane, and the projection
  view_depth,
  front_plane_clipping,
  back_plane_clipping,
  window,
  viewport,
  window_fit,
  fill_style,
  line_style,
  light,
  hidden_line_removal,
  hidden_method,
  back_face_removal,
  lines,
};

/// Those settings that an application has set explicitly.
class ExplicitSettings {
 public:
  bool contains(Setting setting) const { return (bits_ & bit(setting)) != 0; }
  void insert(Setting setting) { bits_ |= bit(setting); }
  /// True if some of the view's is set: of camera to viewport.
  bool contains_view() const { return (bits_ & (bit(Setting::window_fit) - 1u)) != 0; }

 private:
  static constexpr unsigned bit(Setting setting) { return 1u << static_cast<unsigned>(setting); }
  unsigned bits_ = 0;
};

/// The application API: the textbook's user routines, under their names in drawing programs
/// with underscores for hyphens. One object that the caller owns; no globals. A copy has all
/// segments and settings; after a move the source may only be assigned to or destroyed.
///
/// Every routine throws Error for a call that cannot be carried out; the state is then what
/// it was before the call. Coordinates are world coordinates (before the modelling
/// transformation) unless another space is named, angles degrees, colours in [0,1].
class GraphicsSystem {
 public:
  static constexpr std::size_t kLongestText = 65535;  ///< bytes
  static constexpr std::size_t kMostSaved = 1024;
  static constexpr double kMostHatchingLines = 100000.0;

  GraphicsSystem();
  GraphicsSystem(const GraphicsSystem& other);
  GraphicsSystem(GraphicsSystem&& other) noexcept;
  GraphicsSystem& operator=(const GraphicsSystem& other);
  GraphicsSystem& operator=(GraphicsSystem&& other) noexcept;
  ~GraphicsSystem();

  // ---- Views ------------------------------------------------------------------------------------

  // View parameters (clip/view.h has their meanings and errors). They take effect when a
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
  /// Sets all of these but the viewport to those of a view, such as look_at's (clip/view.h), each
  /// as by its own routine. Errors, before any is set: those of the routines.
  void set_view(const View& view);
  /// How a window is mapped to a viewport of another shape in the picture. Until this is set, a
  /// window is widened unless the application has set it, or the viewport: then it is stretched.
  /// view() has the window as it was set.
  void set_window_fit(WindowFit fit);
  /// The width over the height of the pictures that segments opened from now on will be drawn as
  /// [1]. It belongs to the device and is not recorded: a caller that replays sets it again.
  /// Errors: not a positive number up to kCoordinateLimit, a segment is open.
  void set_aspect_ratio(double aspect);

  const View& view() const;
  double aspect_ratio() const;
  /// The worst of the windows that were stretched although the application did not set that they
  /// should be.
  const std::optional<StretchedWindow>& stretched_window() const;
  /// Where a point of the model is, in the modelling transformation and the view in force: in
  /// normalised device coordinates, before a segment's image transformation, as set_image_centre
  /// takes it and the pixel_at of a picture (interp/device/picture.h). Points outside of the view
  /// volume have a place too; none if it is not before the eye, or beyond kCoordinateLimit. Errors:
  /// those of a coordinate, and of a view that open_segment refuses.
  std::optional<Point3> to_device(const Point3& p) const;

  // The modelling transformation (clip/transformation.h).
  void create_transformation_3();
  void translate_3(double tx, double ty, double tz);
  void scale_3(double sx, double sy, double sz);
  void rotate_x_3(double angle);
  void rotate_y_3(double angle);
  void rotate_z_3(double angle);
  /// Saves the transformation in force on a stack. It stays in force, and what is called next acts
  /// before it: in a part's own coordinates. The stack does not know segments: a part's may be
  /// several, and what is not restored stays saved. Error: kMostSaved are saved.
  void save_transformation_3();
  /// The transformation is again what it was when it was saved last. Error: none is saved.
  void restore_transformation_3();
  const ModellingTransformation& modelling_transformation() const;

  // ---- Segments ---------------------------------------------------------------------------------

  /// CREATE-SEGMENT. Names are positive integers. Errors: a segment is open, the name is in use or
  /// not positive, the view parameters do not fit together (clip/view_volume.h).
  void open_segment(int name);
  /// Sorts the segment's hidden surfaces if hidden-line removal is on, by a method that sorts
  /// and with a scope that is not `all`; it may use what the budget in force allows (BudgetInForce,
  /// clip/base/work_budget.h). Errors: no segment open; LimitReached, after which it is still open,
  /// with all that is in it.
  void close_segment();
  /// The open segment's name.
  std::optional<int> open_segment_name() const;
  /// Calls enter(), which opens segments, enters primitives into them and closes them, while none
  /// is open. If it throws, nothing of that is left: no segment, and the current position, the
  /// ordinals, the attributes, the modelling transformation, the background and what is recorded
  /// are those of before. It is no place to set other things, which would stay.
  void enter_segments(const std::function<void()>& enter);
  /// Calls change(), which may call any routines. If it throws, all is as before, and nothing of it
  /// is recorded. What the application retains in a scene of its own stays there.
  void all_or_nothing(const std::function<void()>& change);
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
  /// The segments, to be drawn (interp/draw/draw.h), dumped (displayfile/files.h) or handed to a
  /// device of the application's own (interp/device/output_device.h).
  const DisplayFile& display_file() const;

  // ---- Primitives -------------------------------------------------------------------------------

  // Error: no segment open; a coordinate that is not finite or exceeds kCoordinateLimit in world
  // coordinates. The 2D routines keep the current position's z.
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
  void polygon_abs_3(PointList<Point3> vertices);
  void polygon_rel_3(PointList<Point3> steps);
  void polygon_abs_2(PointList<Point2> vertices);
  void polygon_rel_2(PointList<Point2> steps);
  /// Many polygons at once, as polygon_abs_3 enters them one after another, but several times as
  /// fast. The fill style and the pick identifier in force stay what they were. Errors, before any
  /// polygon is entered: those of polygon_abs_3, set_fill_style and set_vertex_normals, an index
  /// that is not of a vertex, counts that do not agree, a pick identifier below 0, normals that
  /// set_vertex_normals has set.
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

  /// All that is entered from here to end_solid is one closed solid, made of its parts in their
  /// order (displayfile/solids/README.md). A part is a shape, closed polygons that one call enters,
  /// a solid within it, or else the polygons between two of these, together. Solids may stand one
  /// within another, 32 deep. Until the outermost ends, nothing is in the display file. The
  /// modelling transformation and the styles are those in force at each polygon, the cutting planes
  /// those in force at the end. Errors: no segment open, too deep.
  void begin_solid(SolidOperation operation = SolidOperation::unite);
  /// Combines the parts; one part alone is the solid as it is. The result is entered as polygons,
  /// in the styles and with the pick identifiers of those that they are parts of; if that is
  /// nothing, counts().empty_solids grows. Errors, after which the solid is still open: none is, it
  /// has no part, a part is not closed; and with several parts, one that passes through itself, a
  /// result that is no solid, no library that combines (ExactSolid); cut faces with more than
  /// kMostHatchingLines.
  void end_solid();
  /// The innermost solid is as if it had not begun. Error: none is open.
  void discard_solid();

  /// A text at the current position, which stays: UTF-8, on one line. It is drawn if the position
  /// is within the view volume and, where hidden surfaces are removed, nothing hides it
  /// (interp/truth/truth.md); an image transformation moves it, but does not scale or turn its
  /// letters. Errors: more than kLongestText bytes; not UTF-8, or what cannot be drawn
  /// (control characters; noncharacters of Unicode).
  void text(std::string_view characters);

  // ---- Looks: attributes of the primitives that follow ------------------------------------------

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
  /// light. Pixels show them by every method, vectors by the map
  /// (displayfile/segments/lit_parts.md); vectors of a sort and the OSMesa device draw fills as
  /// lit.
  void set_shadows(bool on);
  /// The normals of the vertices of the next polygon, in its order: directions of any length, in
  /// the coordinates of its vertices, as Newell's sums turn out of the light face. Zero stands for
  /// the polygon's own normal. No normals: takes back what was set. With flat shading they have no
  /// effect. Errors: one or two normals; a component that is not finite or exceeds
  /// kCoordinateLimit. A polygon of another number of sides is then an error.
  void set_vertex_normals(PointList<Point3> normals);
  /// Cutting plane n, 1 to 6: of the primitives that follow, in any view, all that has
  /// a x + b y + c z + d < 0 is cut away, x y z being world coordinates after the modelling
  /// transformation (clip/cutting_planes.md). Sides that it makes are not drawn, and what it cuts
  /// open stays open but for set_cut_faces. Errors: those of CuttingPlanes::set.
  void set_cutting_plane(int n, double a, double b, double c, double d);
  void set_cutting_plane_off(int n);  ///< Error: n is not 1 to 6.
  /// The faces where cutting planes cut closed solids that follow, if a call enters them whole:
  /// shapes, end_solid, polygons_abs_3, meshes [open]. Polygons that are entered one by one, and
  /// what is not closed, stay cut open. A cut face has the styles and, as a polygon, the pick
  /// identifier in force. Errors: a spacing that is not above 0, an angle that is not finite.
  void set_cut_faces(const CutFaces& faces);
  /// Which curves of the surfaces that follow are drawn [both].
  void set_surface_curves(SurfaceCurves curves);
  /// The side whose curves are drawn: where the other one is seen, they hide all the same [both].
  /// A curve between a cell seen from above and one seen from below is drawn if one of its
  /// sides is.
  void set_surface_sides(SurfaceSides sides);
  /// The line style of their lower side; none given: that of set_line_style, which is the upper
  /// side's, in force for the surface. Errors: those of set_line_style.
  void set_lower_line_style(const std::optional<LineStyle>& style);
  void set_back_face_removal(bool on);
  /// The pick identifier of the polygons and lines that follow, 0 or more; -1 gives each polygon
  /// its ordinal in the program again, and lines none. Ordinals count from 0 all that is entered,
  /// also what was deleted since, and after 2147483647 from 0 again.
  void set_pick_id(int id);
  /// Where nothing is drawn, pictures show this, of all segments. Error: a colour outside of [0,1].
  void set_background(const Background& background);

  const Attributes& attributes() const;
  const CutFaces& cut_faces() const;
  const SurfaceLooks& surface_looks() const;
  const Background& background() const;

  // ---- How hidden surfaces are found ------------------------------------------------------------

  /// Errors: those of each setting, before any is made.
  void set_hidden_surfaces(const HiddenSurfaceSettings& settings);
  const HiddenSurfaces& hidden_surfaces() const;

  // ---- Work, records, retained scenes -----------------------------------------------------------

  /// Sets the threads of close_segment's sort, whose result is the same for any number of them.
  void set_threads(int threads);
  /// Called, if not empty, with the lines that close_segment has looked at, by a method that finds
  /// lines. An exception of it comes out of close_segment; the segment is then still open, with all
  /// that is in it.
  void set_progress(WorkProgress progress);

  /// Records every routine that succeeds from now on; null stops. The recorder must live on.
  void set_recorder(Recorder* recorder);

  /// Keeps what is drawn in world coordinates too, from now on, in a scene of the system's own,
  /// which all_or_nothing puts back too; without effect if one is retained. Renderers draw it in
  /// other views (interp/draw/renderer.h). Error: there are segments already that were not
  /// retained.
  void retain();
  /// The same in a scene of the caller's (displayfile/segments/retained_scene.h), which must live
  /// on; null stops. Errors: there are segments already; to stop where a selection of lines needs
  /// it.
  void retain(RetainedScene* scene);
  /// The scene that is retained, by retain or for a setting that needs it; null if none is.
  const RetainedScene* retained() const;

  const ExplicitSettings& explicit_settings() const;
  SystemCounts counts() const;

 private:
  friend class SystemInside;
  struct State;
  std::unique_ptr<State> state_;
};

// ---- Views of scenes ----------------------------------------------------------------------------

/// The view with a window that shows all points, in world coordinates, with a twentieth of the
/// picture left free at each side where they are widest, and with front and back planes around
/// them. `aspect` is the width of its viewport in the picture over the height. All else stays as it
/// is. Errors: no points, some that are not before the eye, those of ViewVolume
/// (clip/view_volume.h).
View fit(const View& view, std::span<const Point3> points, double aspect = 1.0);
/// The same for a box from corner to corner.
View fit(const View& view, const Point3& low, const Point3& high, double aspect = 1.0);
/// The same for the visible segments of a system that retains its scene, in the shape of its
/// pictures: for views that a renderer draws of it. Error: nothing is retained.
View fit(const View& view, const GraphicsSystem& system);

// ---- Shapes and axes ----------------------------------------------------------------------------

// Primitive shapes, made of polygons_abs_3 (displayfile/shapes/README.md): in the coordinates of
// the application, before the modelling transformation. Their polygons are closed, counterclockwise
// from outside, share their vertices to the last bit, and have a pick identifier each, as polygons
// do. What is round stands on facets, 3 to 1000 of them around, and has normals for smooth shading;
// it is inscribed: its vertices are on the true surface. Errors, before any polygon is entered: an
// empty range, a length that is not above 0, facets out of range, and those of polygons_abs_3.

/// From corner to corner.
void box_3(GraphicsSystem& system, const Point3& low, const Point3& high);
/// A right-angled wedge: the box's half below the plane from its upper edge at low.x to its lower
/// edge at high.x.
void wedge_3(GraphicsSystem& system, const Point3& low, const Point3& high);
/// An upright prism over a regular polygon, whose corners are at `radius` from the middle of its
/// base, the first in the direction of x; `height` is along z.
void prism_3(GraphicsSystem& system, const Point3& base, double radius, double height, int sides);
void cylinder_3(GraphicsSystem& system, const Point3& base, double radius, double height,
                int facets);
/// A cone, or with a radius at its top above 0 a truncated one.
void cone_3(GraphicsSystem& system, const Point3& base, double radius, double height, int facets,
            double top_radius = 0.0);
/// So many facets around, half as many (rounded up) from pole to pole; its axis is along z.
void sphere_3(GraphicsSystem& system, const Point3& centre, double radius, int facets);
/// A ring about a line along z through its centre; the tube has half as many facets around it
/// (rounded up, but 3). Error: the tube's radius is not below the ring's.
void torus_3(GraphicsSystem& system, const Point3& centre, double radius, double tube_radius,
             int facets);
/// A profile in the x-y plane, extruded along z (extruded, in displayfile/shapes/swept.h).
void extrude_3(GraphicsSystem& system, double z_min, double z_max, std::span<const Point2> profile);
/// A profile of points (x, z) in the x-z plane, turned about the z axis (turned, in
/// displayfile/shapes/swept.h).
void turn_3(GraphicsSystem& system, int facets, std::span<const Point2> profile);

/// Draws the axes of a box of the model into the open segment: of each axis the line from its low
/// end to its high one, ticks and numbers at about five multiples of 1, 2 or 5 times a power of
/// ten, and its name. Of the edges of the box that are parallel to an axis and on its outline in
/// the view in force, it stands on the lowest, or, where they are steep, on the one to the left:
/// ticks, numbers and names are outside of the box as it is seen there, where nothing in the box
/// hides them. A name is beside the middle of its axis, or where that is not in the picture beside
/// another place of it or beyond its end. A number stands farther out where another axis' number is
/// in the way, or is left out. An axis whose ends are equal is left out, and one of which no edge
/// is on the outline, as it is seen end on or nearly so.
///
/// It is made of move_abs_3, line_abs_3, set_text_style and text, and recorded so: lines are in the
/// line style in force, texts of the size in force. It leaves the text style as it was and the
/// current position at `low`. Another view that is drawn of a retained scene has the same axes.
///
/// low and high are in the coordinates of the primitives. Errors, before anything is drawn: no
/// segment open; an end that is above its other, all equal; a name that is no text; a place that
/// is out of range or not before the eye.
void axes_3(GraphicsSystem& system, const Point3& low, const Point3& high,
            const std::array<std::string_view, 3>& names = {"x", "y", "z"});

}  // namespace displayfile
