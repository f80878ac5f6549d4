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

// Arguments and results of the user routines.

/// A view of points in a vector, an array, a span or a list in braces. It does not own them.
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
  std::span<const std::uint32_t> sides = {};    ///< number per polygon; empty: 3 each
  std::span<const FillStyle> fills = {};        ///< one, or one per polygon; empty: that in force
  std::span<const std::int32_t> picks = {};     ///< one per polygon; 0 or more
  std::span<const Point3> normals = {};         ///< one per vertex, as in set_vertex_normals
  std::span<const Colour> vertex_colours = {};  ///< one per vertex, as in set_vertex_colours
};

/// A surface z = F(x, y) over a grid: points (x, y, z) with x at `x_points` even steps from x_min
/// to x_max, y likewise. In world coordinates, before the modelling transformation.
struct SurfaceGrid {
  double x_min, x_max;
  int x_points;
  double y_min, y_max;
  int y_points;
  std::span<const double> heights;  ///< z, x varies fastest; NaN where there is no surface

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
  /// The first and last values are exactly the ends of the range.
  double x(int i) const { return at(x_min, x_max, x_points, i); }
  double y(int j) const { return at(y_min, y_max, y_points, j); }

 private:
  static double at(double low, double high, int points, int k) {
    const double part = static_cast<double>(k) / (points - 1);
    return k == points - 1 ? high : low + (high - low) * part;
  }
};

/// Throws Error unless there are at least 2 points in each direction, both ranges are finite and
/// increasing, there is one height per point, and no height is infinite.
void require_surface(const SurfaceGrid& grid);

/// Which curves of a surface are drawn as lines: `x` curves run along x at constant y.
enum class SurfaceCurves { x, y, both };

/// The sides of a surface on which curves are drawn. The upper side faces +z.
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
  std::optional<LineStyle> lower_line = std::nullopt;  ///< none: the upper side's style
};

/// How solids are combined: the first with the second, the result with the third, and so on.
enum class SolidOperation {
  unite,       ///< points in any of them
  intersect,   ///< points in all of them
  difference,  ///< points in the first but in none of the others
};

/// Reads `union`, `intersection` or `difference`; throws Error for anything else.
SolidOperation solid_operation(std::string_view text);
std::string_view name_of(SolidOperation operation);

/// The faces made where cutting planes cut solids that one call enters
/// (displayfile/solids/cut_solid.md).
struct CutFaces {
  enum class Kind {
    open,     ///< no faces: the inside is visible
    closed,   ///< polygons, in the styles in force
    hatched,  ///< polygons with hatching lines on them
  };
  Kind kind = Kind::open;
  /// Distance between hatching lines, in world units. None: 1/24 of the longest side of the solid's
  /// bounding box.
  std::optional<double> spacing{};
  /// Angle of the hatching lines in degrees, counterclockwise from the plane's horizontal
  /// direction, seen from the side that is cut away.
  double angle = 45.0;
};

/// The word that stands for the default spacing.
inline constexpr std::string_view kUsualSpacing = "usual";

/// Reads `open`, `closed` or `hatched`; throws Error for anything else.
CutFaces::Kind cut_faces_kind(std::string_view text);
std::string_view name_of(CutFaces::Kind kind);

/// Attributes of the primitives that follow, and the background of pictures.
struct Looks {
  Attributes attributes = {};
  AnnotationStyle annotation = {};
  SurfaceLooks surfaces = {};
  CutFaces cut_faces = {};
  double crease_degrees = 180.0;  ///< of smooth shading (set_crease_angle)
  Background background = {};
};

/// How the application's hidden surfaces are found.
struct HiddenSurfaces : SurfacePlan {
  bool removal = false;   ///< set-hidden-line-removal
  bool z_buffer = false;  ///< set-z-buffer
  LineSelection lines = {};
  Touching touching = kUnlessSet;
};

/// A window mapped to a viewport with another aspect ratio (width over height) in the picture.
struct StretchedWindow {
  int segment;  ///< the segment opened with it
  double window, viewport;
};

/// Counts of a system.
struct SystemCounts {
  std::int64_t polygons = 0;      ///< calls of polygon routines, and surface cells
  std::int64_t triangulated = 0;  ///< polygons cut into triangles because they are not planar
  std::size_t solids_open = 0;    ///< depth of nesting
  std::int64_t empty_solids = 0;  ///< outermost solids whose result was empty
  std::size_t transformations_saved = 0;
  /// True if a segment may have hatching, whose directions are fixed by the view in which it was
  /// entered.
  bool has_hatching = false;
  /// The window stretched most, of those stretched by default (set_window_fit).
  std::optional<StretchedWindow> stretched_window = std::nullopt;
};

/// Settings with a default that holds until the application sets them; a mesh brings its own
/// defaults (displayfile/mesh/mesh.h).
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
  crease_angle,
};

/// Settings the application has set explicitly.
class ExplicitSettings {
 public:
  bool contains(Setting setting) const { return (bits_ & bit(setting)) != 0; }
  void insert(Setting setting) { bits_ |= bit(setting); }
  /// True if any view setting, `camera` to `viewport`, is set.
  bool contains_view() const { return (bits_ & (bit(Setting::window_fit) - 1u)) != 0; }
  bool operator==(const ExplicitSettings&) const = default;

 private:
  static constexpr unsigned bit(Setting setting) { return 1u << static_cast<unsigned>(setting); }
  unsigned bits_ = 0;
};

/// The application API: the textbook's user routines, under their names in drawing programs with
/// underscores for hyphens. The caller owns the object; there are no globals. A copy has all
/// segments and settings; a moved-from object may only be assigned to or destroyed.
///
/// Every routine throws Error for an invalid call and then leaves the state unchanged. Coordinates
/// are world coordinates (before the modelling transformation) unless another space is named,
/// angles are in degrees, colours in [0,1].
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

  // View parameters (meanings and errors: clip/view.h). They take effect when a segment is opened;
  // setting one while a segment is open is an error.
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
  /// Sets all view parameters except the viewport from a view, such as the result of look_at
  /// (clip/view.h). Throws the routines' Errors before it sets any.
  void set_view(const View& view);
  /// How a window is mapped to a viewport with another aspect ratio in the picture. Until this is
  /// set, the window is stretched if the application has set it or the viewport, and otherwise
  /// widened. view() returns the window as it was set.
  void set_window_fit(WindowFit fit);
  /// Width over height of the pictures in which segments opened from now on will be drawn [1]. It
  /// belongs to the device and is not recorded: a caller that replays sets it again. Errors: not a
  /// positive number up to kCoordinateLimit; a segment is open.
  void set_aspect_ratio(double aspect);

  const View& view() const;
  double aspect_ratio() const;
  /// Maps a point by the modelling transformation and the view in force to normalised device
  /// coordinates, before a segment's image transformation: the coordinates that set_image_centre
  /// and pixel_at (interp/device/picture.h) take. Points outside of the view volume are mapped too.
  /// Returns none if the point is not in front of the eye or is beyond kCoordinateLimit. Errors:
  /// those of a coordinate, and of a view that open_segment refuses.
  std::optional<Point3> to_device(const Point3& p) const;

  // The modelling transformation (clip/view/transformation.h).
  void create_transformation_3();
  void translate_3(double tx, double ty, double tz);
  void scale_3(double sx, double sy, double sz);
  void rotate_x_3(double angle);
  void rotate_y_3(double angle);
  void rotate_z_3(double angle);
  /// Pushes the transformation in force on a stack. It stays in force, and later routines act
  /// before it, in a part's own coordinates. The stack is independent of segments: a part may span
  /// several, and entries that are not restored remain. Error: kMostSaved are saved.
  void save_transformation_3();
  /// Pops the transformation saved last. Error: none is saved.
  void restore_transformation_3();
  const ModellingTransformation& modelling_transformation() const;

  // ---- Segments ---------------------------------------------------------------------------------

  /// CREATE-SEGMENT. Names are positive integers. Errors: a segment is open, the name is in use or
  /// not positive, the view parameters do not fit together (clip/view/view_volume.h).
  void open_segment(int name);
  /// Closes the segment. If hidden-line removal is on, with a method that sorts and a scope other
  /// than `all`, sorts its hidden surfaces within the budget in force (BudgetInForce,
  /// clip/base/work_budget.h). Errors: no segment open; LimitReached, after which the segment is
  /// still open with its contents.
  void close_segment();
  /// The open segment's name.
  std::optional<int> open_segment_name() const;
  /// Calls enter(), which opens, fills and closes segments, while no segment is open. If it throws,
  /// its segments are removed and the current position, ordinals, attributes, modelling
  /// transformation, background and record are restored. Other settings that it changes are not
  /// restored.
  void enter_segments(const std::function<void()>& enter);
  /// Calls change(), which may call any routine. If it throws, the state is restored and nothing of
  /// it is recorded. A retained scene of the application's own is not restored.
  void all_or_nothing(const std::function<void()>& change);
  /// Errors: no such segment, segment still open.
  void delete_segment(int name);
  /// Error: segment still open.
  void delete_all_segments();
  /// Errors: no such segment, new name in use, segment still open.
  void rename_segment(int from, int to);
  /// Sets the segment's title, such as the name of a part: the name of its layer in vector files
  /// and, in SVG, its title and id (interp/vector/README.md). A title stays with a segment that is
  /// renamed; an empty one removes it. Errors: no such segment; not characters that can be drawn;
  /// more than kLongestText bytes.
  void set_segment_title(int name, std::string_view title);
  /// Error: no such segment; the same for the image transformation routines.
  void set_visibility(int name, bool on);
  /// The image transformation, in normalised device coordinates: scale about the image's centre,
  /// rotate about it, then translate. Each routine sets one part; the default centre is the origin.
  void set_image_translation(int name, double tx, double ty);
  void set_image_scale(int name, double sx, double sy);
  void set_image_rotation(int name, double angle);
  void set_image_centre(int name, double x, double y);  ///< Error: more than 1e9 in magnitude.
  /// The segments, for drawing (interp/draw/draw.h), dumping (displayfile/files.h) or an
  /// application's own device (interp/device/output_device.h).
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
  /// A polygon of 3 or more sides, concave or self-crossing (filled even-odd). It starts at its
  /// last vertex and leaves the current position there. In the _rel routines each vertex is
  /// relative to the one before, the first to the current position. Error: fewer than 3 sides.
  void polygon_abs_3(PointList<Point3> vertices);
  void polygon_rel_3(PointList<Point3> steps);
  void polygon_abs_2(PointList<Point2> vertices);
  void polygon_rel_2(PointList<Point2> steps);
  /// Enters many polygons as repeated polygon_abs_3 would, several times as fast. The fill style
  /// and pick identifier in force are unchanged. Errors, before any polygon is entered: those of
  /// polygon_abs_3, set_fill_style, set_vertex_normals and set_vertex_colours; an index out of
  /// range; counts that do not agree; fills and colours of vertices; colours of vertices of a solid
  /// whose cut faces are to be closed; a pick identifier below 0; normals or colours set for the
  /// vertices of one polygon.
  void polygons_abs_3(const ManyPolygons& polygons);
  /// A surface over a grid: each cell is two triangles with an invisible diagonal from its least
  /// corner to its greatest. The surface's curves are the triangles' other sides, in the line
  /// style; curves of an unselected family are invisible, and their cells still hide what is
  /// behind. The light face is the side that faces +z. Cells with an unknown height (NaN) at a
  /// corner are omitted. Each cell has a pick identifier, as a polygon has. The current position
  /// becomes the grid's last point, with z 0 if its height is unknown. Errors, before any cell is
  /// entered: those of require_surface; those of coordinates; normals or colours set for the
  /// vertices of one polygon.
  void surface_3(const SurfaceGrid& grid);

  /// Begins a closed solid, which end_solid ends, made by combining parts in their order
  /// (displayfile/solids/README.md). A part is a shape, a set of closed polygons entered by one
  /// call, a nested solid, or all polygons between two of these. Solids nest up to 32 deep. The
  /// display file is unchanged until the outermost solid ends. Each polygon uses the modelling
  /// transformation and styles in force when it is entered; the cutting planes are those in force
  /// at the end. Errors: no segment open; nested too deep.
  void begin_solid(SolidOperation operation = SolidOperation::unite);
  /// Combines the parts and enters the result as polygons, each with the style and pick identifier
  /// of its source polygon; a single part is entered as it is. An empty result adds one to
  /// counts().empty_solids. Errors, after which the solid is still open: no solid is open; it has
  /// no part; a part is not closed; with several parts, one intersects itself, the result is not a
  /// solid, or no library for combining is built in (ExactSolid); cut faces with more than
  /// kMostHatchingLines.
  void end_solid();
  /// Discards the innermost open solid. Error: none is open.
  void discard_solid();

  /// A text at the current position, which is unchanged: UTF-8, on one line. It is drawn if the
  /// position is within the view volume and, where hidden surfaces are removed, not hidden
  /// (interp/truth/truth.md). An image transformation moves it but does not scale or rotate its
  /// letters. Errors: more than kLongestText bytes; not UTF-8; control characters or noncharacters
  /// of Unicode.
  void text(std::string_view characters);
  /// Enters annotation (displayfile/looks/style.h) into the open segment. It is drawn if the points
  /// of the model are within the view volume. Errors: those of coordinates and texts; a number
  /// below 1; a measure of 0; an offset beyond 1e6; an angle of 180 degrees; a radius not above 0.
  void annotate(const Annotation& annotation);

  // ---- Looks: attributes of the primitives that follow ------------------------------------------

  void set_fill_style(const FillStyle& style);  ///< Error: a colour outside of [0,1].
  /// Leaves the styles of kinds of lines unchanged. Errors: a colour outside of [0,1], width, dash
  /// or gap not positive.
  void set_line_style(const LineStyle& style);
  /// Sets the style of one kind of lines, sides of the polygons that follow, in place of the line
  /// style; or that of the hidden parts of lines and sides that follow. A default style restores
  /// the line style, and for hidden parts dashes, half as wide (hidden_line_style). Lines of
  /// several kinds have the style of the first (displayfile/segments/line_kinds.md). Errors: those
  /// of set_line_style; the kind none; a dash without a gap, a gap without a dash, either without
  /// `dashed`.
  void set_line_kind_style(StyledLines lines, const LineKindStyle& style);
  void set_text_style(const TextStyle& style);  ///< Error: a size not above 0, or above 1.
  /// Errors: a size not above 0, or above 1000; decimals that are not 0 to 9; a text of dimensions
  /// without `<>`, or with several. Each member is a routine of drawing programs, recorded if it
  /// differs from its last recorded value.
  void set_annotation_style(const AnnotationStyle& style);
  /// Sets the light: a world direction toward it, of any non-zero length; ambient in [0,1]. A
  /// polygon's fill colour is multiplied by ambient + (1 - ambient) max(0, cosine of the angle
  /// between the light and the normal of its visible side).
  void set_light(const Point3& toward, double ambient = 0.2);
  /// Gouraud shading (displayfile/looks/gouraud.md): where there is light, a polygon with vertex
  /// normals is lit at its vertices, and the intensities are interpolated. Phong shading
  /// (displayfile/looks/phong.md): the normals are interpolated and each pixel is lit; vectors and
  /// the OSMesa device use Gouraud shading instead. A shaded polygon of more than three sides is
  /// entered as triangles with invisible diagonals. All other polygons are shaded flat.
  void set_shading(Shading shading);
  /// The angle in degrees above which smooth shading keeps a side between two facets sharp, of
  /// meshes imported from now on whose vertices have no normals: a vertex then has a normal for
  /// each group of facets around it that meet at no more. It is that of the lines of kind crease
  /// (displayfile/segments/line_kinds.md). 180: one normal, the mean over all facets around the
  /// vertex [180]. Errors: not 0 to 180.
  void set_crease_angle(double degrees);
  /// Shadows (interp/raster/shadows.md): where there is light, solid polygons entered from now on
  /// get ambient light alone where a solid polygon hides the light from them, whether or not the
  /// occluder was entered with shadows on. Clipped parts and removed back faces cast no shadows.
  /// Every raster method draws shadows, and of vector methods the map
  /// (displayfile/segments/lit_parts.md); sorted vectors and the OSMesa device draw fills without
  /// shadows.
  void set_shadows(bool on);
  /// Vertex normals of the next polygon, in the order of its vertices: directions of any length, in
  /// the coordinates of the vertices, pointing out of the light face (Newell's sums). Zero stands
  /// for the polygon's own normal. An empty list discards normals set before. They have no effect
  /// with flat shading. Errors: one or two normals; a component that is not finite or exceeds
  /// kCoordinateLimit. A next polygon with another number of sides is an error.
  void set_vertex_normals(PointList<Point3> normals);
  /// Colours of the vertices of the next polygon, in the order of its vertices, in place of its
  /// fill style, also of a hollow one. In between they are linear over each of its triangles in
  /// space: it is entered in pieces of one colour each, by which no part of a colour is off by more
  /// than 1/170 (displayfile/looks/colour_pieces.md). Light and shading act on them as on other
  /// fills; its sides are drawn as those of other polygons. An empty list discards colours set
  /// before. Errors: one or two colours; a part of a colour outside of [0,1]. A next polygon with
  /// another number of sides, or within a solid, is an error, as are a surface and many polygons.
  void set_vertex_colours(PointList<Colour> colours);
  /// Sets cutting plane n, 1 to 6: parts with a x + b y + c z + d < 0 of the primitives that follow
  /// are cut away in every view, where x y z are world coordinates after the modelling
  /// transformation (clip/pipeline/cutting_planes.md). Sides made by a cut are not drawn, and cut
  /// solids stay open unless set_cut_faces closes them. Errors: those of CuttingPlanes::set.
  void set_cutting_plane(int n, double a, double b, double c, double d);
  void set_cutting_plane_off(int n);  ///< Error: n is not 1 to 6.
  /// Sets the faces made where cutting planes cut closed solids that one call enters: shapes,
  /// end_solid, polygons_abs_3, meshes [open]. Polygons entered one by one, and anything not
  /// closed, stay open. A cut face has the styles and, as a polygon, the pick identifier in force.
  /// Errors: a spacing that is not above 0; an angle that is not finite.
  void set_cut_faces(const CutFaces& faces);
  /// Selects the curves drawn on surfaces that follow [both].
  void set_surface_curves(SurfaceCurves curves);
  /// Selects the sides of a surface on which curves are drawn [both]; cells of the other side are
  /// drawn without curves and still hide what is behind. A curve between an upper-side cell and a
  /// lower-side cell is drawn if either side is selected.
  void set_surface_sides(SurfaceSides sides);
  /// The line style of a surface's lower side; none: the line style in force, which is the upper
  /// side's. Errors: those of set_line_style.
  void set_lower_line_style(const std::optional<LineStyle>& style);
  void set_back_face_removal(bool on);
  /// The pick identifier of polygons and lines that follow, 0 or more. -1 restores the default:
  /// each polygon gets its ordinal in the program, lines none. Ordinals start at 0, count deleted
  /// polygons too, and wrap to 0 after 2147483647.
  void set_pick_id(int id);
  /// The background of pictures, shared by all segments. Error: a colour outside of [0,1].
  void set_background(const Background& background);

  const Looks& looks() const;

  // ---- How hidden surfaces are found ------------------------------------------------------------

  /// Each option that has a value is a routine of drawing programs, and is recorded as such. Throws
  /// the Errors of all before it sets any.
  void set_hidden_surfaces(const HiddenSurfaceOptions& options);
  const HiddenSurfaces& hidden_surfaces() const;

  // ---- Work, records, retained scenes -----------------------------------------------------------

  /// Sets the number of threads for close_segment's sort, whose result does not depend on it.
  void set_threads(int threads);
  /// Sets a callback for the number of lines that close_segment has processed, by a method that
  /// finds lines; may be empty. An exception it throws leaves close_segment, with the segment still
  /// open and its contents kept.
  void set_progress(WorkProgress progress);

  /// Records every routine that succeeds from now on; null stops. The recorder must outlive its
  /// use.
  void set_recorder(Recorder* recorder);

  /// Retains primitives in world coordinates from now on, in a scene of the system's own, which
  /// all_or_nothing restores too; no effect if a scene is retained already. Renderers draw it in
  /// other views (interp/draw/renderer.h). Error: there are segments that were not retained.
  void retain();
  /// Retains primitives in the caller's scene (displayfile/segments/retained_scene.h), which must
  /// outlive its use; null stops. Errors: there are segments already; stopping while a selection of
  /// lines needs it.
  void retain(RetainedScene* scene);
  /// The scene retained by retain() or by a setting that needs one; null if none.
  const RetainedScene* retained() const;

  const ExplicitSettings& explicit_settings() const;
  SystemCounts counts() const;

 private:
  friend class SystemInside;
  struct State;
  std::unique_ptr<State> state_;
};

// ---- Views of scenes ----------------------------------------------------------------------------

/// Returns `view` with a window that shows all points, given in world coordinates, with at least a
/// twentieth of the picture free at each side, and with front and back planes around them. `aspect`
/// is the width over height of its viewport in the picture. Errors: no points; a point that is not
/// in front of the eye; those of ViewVolume (clip/view/view_volume.h).
View fit(const View& view, std::span<const Point3> points, double aspect = 1.0);
/// The same for an axis-aligned box with these corners.
View fit(const View& view, const Point3& low, const Point3& high, double aspect = 1.0);
/// The same for the visible segments of a system that retains its scene, with the aspect ratio of
/// its pictures, for other views drawn by a renderer. Error: nothing is retained.
View fit(const View& view, const GraphicsSystem& system);

// ---- Shapes and axes ----------------------------------------------------------------------------

// Primitive shapes, entered as polygons_abs_3 (displayfile/shapes/README.md) in the application's
// coordinates, before the modelling transformation. Their polygons are closed, counterclockwise
// seen from outside, share vertices bit for bit and have one pick identifier each. Round shapes
// have 3 to 1000 facets around, normals for smooth shading, and vertices on the true surface.
// Errors, before any polygon is entered: an empty range; a length that is not above 0; facets out
// of range; those of polygons_abs_3.

/// An axis-aligned box with these corners.
void box_3(GraphicsSystem& system, const Point3& low, const Point3& high);
/// A right-angled wedge: half of the box, below the plane from the upper edge at low.x to the lower
/// edge at high.x.
void wedge_3(GraphicsSystem& system, const Point3& low, const Point3& high);
/// An upright prism over a regular polygon with corners at `radius` from `base`, the first in the
/// direction of x; `height` is along z.
void prism_3(GraphicsSystem& system, const Point3& base, double radius, double height, int sides);
void cylinder_3(GraphicsSystem& system, const Point3& base, double radius, double height,
                int facets);
/// A cone, truncated if top_radius is above 0.
void cone_3(GraphicsSystem& system, const Point3& base, double radius, double height, int facets,
            double top_radius = 0.0);
/// A sphere with its axis along z: `facets` around, half as many (rounded up) from pole to pole.
void sphere_3(GraphicsSystem& system, const Point3& centre, double radius, int facets);
/// A torus about the line along z through `centre`; the tube has half as many facets around it
/// (rounded up, at least 3). Error: the tube's radius is not below the ring's.
void torus_3(GraphicsSystem& system, const Point3& centre, double radius, double tube_radius,
             int facets);
/// A profile in the x-y plane, extruded along z (extruded, in displayfile/shapes/swept.h).
void extrude_3(GraphicsSystem& system, double z_min, double z_max, std::span<const Point2> profile);
/// A profile of points (x, z) in the x-z plane, turned about the z axis (turned, in
/// displayfile/shapes/swept.h).
void turn_3(GraphicsSystem& system, int facets, std::span<const Point2> profile);

/// Draws the axes of a box of the model into the open segment. Each axis is a line from its low to
/// its high end with ticks and numbers at about five multiples of 1, 2 or 5 times a power of ten,
/// and its name. It is placed on the lowest of the box's parallel edges that are on the outline in
/// the view in force, or, for steep edges, on the left one; ticks, numbers and names are outside of
/// the box, where nothing in the box hides them. A name is beside the middle of its axis, or, if
/// that is outside of the picture, beside another place of the axis or beyond its end. A number
/// that would overlap another axis' number is moved outward or omitted. An axis is omitted if its
/// ends are equal or no edge of it is on the outline, as when it is seen end on.
///
/// It calls move_abs_3, line_abs_3, set_text_style and text, and is recorded as these: lines in the
/// line style in force, texts in the size in force. It leaves the text style unchanged and the
/// current position at `low`. Other views of a retained scene have the same axes.
///
/// low and high are in the coordinates of the primitives. Errors, before anything is drawn: no
/// segment open; a low end above its high end; all ends equal; a name that is not a valid text; a
/// position out of range or not in front of the eye.
void axes_3(GraphicsSystem& system, const Point3& low, const Point3& high,
            const std::array<std::string_view, 3>& names = {"x", "y", "z"});

}  // namespace displayfile
