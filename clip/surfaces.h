#pragma once

/// How hidden surfaces and lines are found: methods, scope, precision, hidden lines, kinds of lines
/// and touching, each with its words in drawing programs; the options and the plan made of them.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "clip/base/work_budget.h"

namespace displayfile {

// Methods.

/// Methods of hidden-surface and hidden-line removal. `automatic` lets the system choose. Besides
/// the named methods there is the colour rule by each method of surfaces: colour_rule_by().
enum class HiddenMethod {
  automatic,
  none,         ///< no removal: polygons in order of entry
  back_face,    ///< the back-face check alone: correct for a single convex object
  z_buffer,     ///< in image space, pixel by pixel
  bsp,          ///< in object space: a tree of the polygons' planes (hidden/sort/bsp.md)
  depth_sort,   ///< in object space: a graph of drawing order (hidden/sort/depth_sort.md)
  map,          ///< in object space: the visible parts of each polygon (hidden/map/visible_map.md)
  scan_line,    ///< in image space, row by row, without a z-buffer (interp/visibility/scan_line.md)
  scan_line_z,  ///< in image space, row by row, with a z-buffer one row high
  ray_cast,     ///< in image space, a ray through each pixel centre (interp/visibility/ray_cast.md)
  world_ray_cast,         ///< in object space, before viewing: by rays in world coordinates
  warnock,                ///< in image space, areas subdivided until they are simple
                          ///< (interp/visibility/warnock.md)
  plain_z_buffer,         ///< the textbook's z-buffer, with the errors of rounded depths
                          ///< (interp/visibility/plain_z_buffer.h): depths as floats;
  plain_z_buffer_16,      ///< as 16-bit integers,
  plain_z_buffer_24,      ///< 24-bit,
  plain_z_buffer_32,      ///< 32-bit;
  plain_z_buffer_double,  ///< as doubles. `automatic` never chooses a plain form
  plain_scan_line,        ///< the textbook's `scan_line` (interp/visibility/plain_scan_line.h)
  plain_warnock,          ///< the textbook's `warnock` (interp/visibility/plain_warnock.h)
  plain_bsp,              ///< the textbook's `bsp` (hidden/sort/plain_bsp.h)
  roberts,      ///< lines in object space, each against all polygons (hidden/lines/roberts.md)
  appel,        ///< lines in object space, by the number of polygons in front of them
                ///< (hidden/lines/appel.md)
  franklin,     ///< lines in object space, by cells of the picture (hidden/lines/franklin.md)
  perimeter,    ///< the curves of one surface over a grid (hidden/lines/perimeter.md)
  plain_appel,  ///< the textbook's `appel` (hidden/lines/plain_appel.h)
  colour_rule,  ///< fills in the background colour with lines over them, surfaces by `automatic`
                ///< (interp/raster/colour_rule.md). Must be last
};

/// The colour rule with surfaces found by `surfaces`; with `automatic`, HiddenMethod::colour_rule.
constexpr HiddenMethod colour_rule_by(HiddenMethod surfaces) {
  return static_cast<HiddenMethod>(static_cast<int>(HiddenMethod::colour_rule) +
                                   static_cast<int>(surfaces));
}
constexpr bool is_colour_rule(HiddenMethod method) { return method >= HiddenMethod::colour_rule; }
/// The method by which a colour rule finds surfaces; any other method is returned unchanged.
constexpr HiddenMethod surfaces_of(HiddenMethod method) {
  if (!is_colour_rule(method)) return method;
  return static_cast<HiddenMethod>(static_cast<int>(method) -
                                   static_cast<int>(HiddenMethod::colour_rule));
}

/// True for methods that find visible lines: polygons hide, but their fills are not drawn.
constexpr bool finds_lines(HiddenMethod method) {
  return method == HiddenMethod::roberts || method == HiddenMethod::appel ||
         method == HiddenMethod::franklin || method == HiddenMethod::perimeter ||
         method == HiddenMethod::plain_appel;
}
/// True for methods that draw only surfaces over grids and refuse other scenes.
constexpr bool needs_surface(HiddenMethod method) { return method == HiddenMethod::perimeter; }

/// True for methods whose pictures show lines only: fills hide but are not visible.
constexpr bool shows_lines_only(HiddenMethod method) {
  return finds_lines(method) || is_colour_rule(method);
}

/// One name of a method in drawing programs and on the command line. A method may have several; the
/// first is the one written. Only the first colour rule is in the list.
struct HiddenMethodEntry {
  HiddenMethod method;
  std::string_view name;
};
std::span<const HiddenMethodEntry> hidden_methods();

/// The method with that name; for colour-rule=METHOD, the colour rule by that method. Throws Error,
/// listing the allowed names, for any other name, and after colour-rule= for a method that finds no
/// surfaces.
HiddenMethod hidden_method(std::string_view name);
std::string_view name_of(HiddenMethod method);

// Scope, precision and hidden lines.

/// The set of polygons among which hidden surfaces are found.
enum class HiddenScope {
  segment,  ///< the textbook's: each segment by itself; segments are drawn in order of creation
  all,      ///< all visible segments together
};

/// Reads `segment` or `all`; throws Error for anything else.
HiddenScope hidden_scope(std::string_view text);
std::string_view name_of(HiddenScope scope);

/// Precision of hidden-surface removal: `exact`, or `roundoff`, with ROUNDOFF as a fraction of the
/// scene's size.
struct Precision {
  static constexpr double kUsualRoundoff = 1e-9;
  bool exact = true;
  double roundoff = kUsualRoundoff;
  /// True if both give the same results: exact precision ignores roundoff.
  bool operator==(const Precision& o) const {
    return exact == o.exact && (exact || roundoff == o.roundoff);
  }
};

/// Reads `exact`, `roundoff` or `roundoff=EPS`, 0 <= EPS < 1; throws Error for anything else.
Precision precision(std::string_view text);
/// The word that precision() reads back.
std::string word_of(const Precision& precision);

/// How hidden parts of lines are drawn.
enum class HiddenLines {
  none,    ///< not drawn
  dashed,  ///< drawn dashed, before the visible ones (hidden/lines/hidden_pieces.md)
};

/// Reads `none` or `dashed`; throws Error for anything else.
HiddenLines hidden_lines(std::string_view text);
std::string_view name_of(HiddenLines lines);

/// The order in which visible lines and sides are drawn where they overlap in the picture.
enum class LineOrder {
  entry,  ///< the one entered later is drawn over the other
  depth,  ///< the nearer one is (hidden/lines/strokes_by_depth.md)
};

/// Reads `entry` or `depth`; throws Error for anything else.
LineOrder line_order(std::string_view text);
std::string_view name_of(LineOrder order);

/// The widest halo of a line in pixels.
inline constexpr double kWidestHalo = 1e6;
/// Throws Error unless it is 0 to kWidestHalo.
void require_line_halo(double halo);

/// How `bsp` chooses the root of a (sub)tree of polygons.
enum class RootChoice {
  last,    ///< the textbook's: the polygon entered last (algorithm 9.8)
  first,   ///< the polygon entered first
  sample,  ///< the polygon of a sample with the lowest cost of cuts and imbalance
  free,    ///< also planes that belong to no polygon; and only among polygons that overlap
};

/// Reads `last`, `first`, `sample` or `free`; throws Error for anything else.
RootChoice root_choice(std::string_view name);

/// The default limit on the pieces into which a sort cuts polygons.
inline constexpr std::size_t kMostPieces = 10'000'000;

// Lines.

/// Kinds of lines (displayfile/segments/line_kinds.md), one bit each. A line may have several;
/// where only one can be used, it is the first in this order.
enum class LineKind : std::uint8_t {
  outline = 2,        ///< a side between polygons that face the viewer and polygons that do not
  boundary = 4,       ///< a side of only one polygon
  crease = 8,         ///< a side at which two polygons meet at an angle
  material = 16,      ///< a side between different fills
  intersection = 32,  ///< where two polygons intersect
  all = 64,           ///< any side that the line style shows
};

/// A combination of kinds. For sides, 0 means not drawn.
using LineKinds = std::uint8_t;
/// A drawn line whose kinds were not determined.
inline constexpr LineKinds kDrawn = 1;
/// Added to the kinds of a line that is drawn although it is hidden. Never in a selection.
inline constexpr LineKinds kHiddenLine = 128;

constexpr LineKinds kinds_of(LineKind kind) { return static_cast<LineKinds>(kind); }
constexpr bool contains(LineKinds kinds, LineKind kind) { return (kinds & kinds_of(kind)) != 0; }
/// True if the kinds were determined, or the line is hidden.
constexpr bool has_kind(LineKinds kinds) { return kinds > kDrawn; }
constexpr bool is_hidden_line(LineKinds kinds) { return (kinds & kHiddenLine) != 0; }

struct LineKindEntry {
  LineKind kind;
  std::string_view name;
};
/// All kinds, in order.
std::span<const LineKindEntry> line_kinds();
/// The names of the kinds, in order, then `hidden` for a hidden line, separated by blanks; empty
/// for no kind.
std::string names_of(LineKinds kinds);
/// `hidden` for a hidden line, otherwise the name of the first kind; empty for no kind.
std::string_view first_name_of(LineKinds kinds);

/// A selection of the lines to draw: those with at least one of these kinds.
struct LineSelection {
  LineKinds kinds = kinds_of(LineKind::all);
  double crease_degrees = 30.0;  ///< minimum angle of a crease, exclusive; 0 to 180

  /// True if the selection is `all` alone: then no kinds are determined.
  bool is_all_alone() const { return kinds == kinds_of(LineKind::all); }
  bool operator==(const LineSelection&) const = default;
};

/// Adds a word to a selection: `all`, `outline`, `boundary`, `crease`, `crease=DEGREES`,
/// `intersection` or `material`. Throws Error for another word, or degrees that are not a number
/// from 0 to 180.
void add_line_kind(std::string_view word, LineSelection& selection);
/// Reads one or more words separated by commas; throws Error as add_line_kind, or for no word.
LineSelection line_selection(std::string_view text);
/// The selection as words separated by blanks.
std::string words_of(const LineSelection& selection);
/// Throws Error for a selection without kinds, with unknown kinds, or with degrees out of range.
void require_selection(const LineSelection& selection);

/// The ends at which a piece of a line is cut: the line continues there, hidden or outside of the
/// view. Other ends are ends of the line itself.
struct LineCuts {
  bool at_start = false, at_end = false;

  bool any() const { return at_start || at_end; }
  LineCuts reversed() const { return {at_end, at_start}; }
  bool operator==(const LineCuts&) const = default;

  /// As a byte; 0: no cuts.
  std::uint8_t byte() const {
    return static_cast<std::uint8_t>((at_start ? 1 : 0) | (at_end ? 2 : 0));
  }
  static LineCuts of(std::uint8_t byte) { return {(byte & 1) != 0, (byte & 2) != 0}; }
};

// Touching.

/// The distance within which parts of a scene touch, their *reach* (interp/truth/entered_truth.md).
/// Files and decimals round coordinates, so parts meant to touch may be a few units of the last
/// digit apart.
struct Touching {
  enum class Kind {
    automatic,  ///< from the precision of the input's numbers
    off,        ///< only coincident parts touch
    length,     ///< within `length`
  };
  Kind kind = Kind::automatic;
  double length = 0.0;  ///< in the coordinates of the input, before its modelling transformation

  bool operator==(const Touching&) const = default;
};

/// Relative rounding units of input numbers.
inline constexpr double kUnitOfDoubles = 0x1p-52, kUnitOfSingles = 0x1p-24;

/// The reach before the modelling transformation. `largest` is the largest magnitude of a
/// coordinate of the polygons and lines entered; `unit` is the relative rounding unit of the
/// coordinates.
double entered_reach(const Touching& touching, double largest, double unit = kUnitOfDoubles);
/// The default.
inline constexpr Touching kUnlessSet{Touching::Kind::automatic};

/// Throws Error unless a length is above 0 and at most kCoordinateLimit.
void require_touching(const Touching& touching);
/// The word that touching() reads back.
std::string word_of(const Touching& touching);

/// Reads `auto`, `off` or a positive number up to kCoordinateLimit; throws Error for anything else.
Touching touching(std::string_view word);

// How surfaces and lines are found.

/// How hidden surfaces and lines are found: by one call (DrawOptions::surfaces), or, unless the
/// call sets otherwise, whenever the application draws (GraphicsSystem::set_hidden_surfaces).
/// Members without a value leave what is in force.
struct HiddenSurfaceOptions {
  // Set for the application; an Error in a call's options.

  /// Also turns back-face removal on or off, as in the textbook. When off, pictures are drawn in
  /// order of entry. If neither this nor `method` was ever set, segments are stored unsorted, and
  /// pictures are drawn by `automatic` unless all points have the same depth.
  std::optional<bool> removal = std::nullopt;
  std::optional<bool> z_buffer = std::nullopt;  ///< draws with the z-buffer whatever the method

  // Set for the application or a call.

  /// For the application: world_ray_cast, ray casting in object space, reads the primitives in
  /// world coordinates: if no scene is retained, setting it retains one in the system from now on.
  /// Errors: an unknown method; world_ray_cast when there are segments that were not retained.
  std::optional<HiddenMethod> method = std::nullopt;
  /// A segment closed while the application's scope is `all` is sorted when it is drawn, if the
  /// scope is `segment` then.
  std::optional<HiddenScope> scope = std::nullopt;
  std::optional<Precision> precision = std::nullopt;  ///< Error: a ROUNDOFF outside of [0,1)
  /// Draws hidden parts of lines dashed, or not at all, by the methods that find lines
  /// (hidden/lines/README.md): when a segment is closed, or with scope `all` when a picture is
  /// drawn.
  std::optional<HiddenLines> hidden_lines = std::nullopt;
  /// The line drawn over the other where two overlap in a picture: the one entered later, or the
  /// nearer one. `depth` takes all visible segments together, whatever the scope, and acts where
  /// lines are drawn over fills or without them: not in order of entry, nor in vectors by bsp or
  /// depth-sort. A call that sets it where it cannot act is an Error.
  std::optional<LineOrder> line_order = std::nullopt;
  /// With `depth`: the gap beside a line that crosses another one in front of it, in pixels of the
  /// picture, as widths of lines; 0: none. Error: outside of 0 to kWidestHalo, and in a call
  /// without `depth`.
  std::optional<double> line_halo = std::nullopt;

  // Set for the application; an Error in a call's options.

  /// The sides of polygons that are drawn as lines (displayfile/segments/line_kinds.md), for
  /// segments closed from now on, whatever the method: the selected kinds, of sides that have a
  /// line style. Any value except `all` alone retains the scene in the system from now on, if none
  /// is retained. Errors: no kind; a crease outside of 0 to 180 degrees; there are segments that
  /// were not retained.
  std::optional<LineSelection> lines = std::nullopt;
  /// The distance within which polygons touch, for segments opened from now on
  /// (hidden/touching/touching_planes.md): a polygon that touches another's plane is taken to lie
  /// in it. Error: a length that is not above 0 and at most kCoordinateLimit.
  std::optional<Touching> touching = std::nullopt;

  // Set for one call; an Error for the application.

  RootChoice root = RootChoice::free;     ///< for `bsp`; Error with any other method
  int threads = 1;                        ///< maximum, at least 1; the result does not depend on it
  std::size_t most_pieces = kMostPieces;  ///< limit on pieces that a sort makes; Error above it
  /// Called by methods that find lines with the number of lines done, starting anew for each
  /// segment or group of segments processed together.
  WorkProgress progress = {};
  /// Limits of the call and a way to stop it, if not null: beyond them LimitReached is thrown and
  /// no file is written (clip/base/work_budget.md).
  WorkBudget* budget = nullptr;

  bool sets_applications() const { return removal || z_buffer || lines || touching; }
  bool sets_calls() const {
    return root != RootChoice::free || threads != 1 || most_pieces != kMostPieces || progress ||
           budget != nullptr;
  }
};

/// The plan by which one picture's hidden surfaces and lines are found: made once per picture from
/// a call's HiddenSurfaceOptions and the application's settings, and read by every method.
struct SurfacePlan {
  HiddenMethod method = HiddenMethod::automatic;  ///< `automatic` until one is chosen
  Precision precision = {};
  RootChoice root = RootChoice::free;
  /// How methods that find lines draw hidden parts (hidden/lines/lines_in_order.h).
  HiddenLines hidden_lines = HiddenLines::none;
  /// The order of visible lines that overlap, and with `depth` the gap beside the farther one, in
  /// pixels of a picture of that size.
  LineOrder line_order = LineOrder::entry;
  double line_halo = 0.0;
  int width = 512, height = 512;
  /// True if they also draw lines along which polygons intersect
  /// (hidden/lines/intersection_lines.h).
  bool intersections = false;
  /// True if the map finds which of its pieces are lit, for shadows.
  bool shadows = false;
  std::optional<HiddenScope> scope = std::nullopt;  ///< none: the default of the drawing function
  int threads = 1;                                  ///< the result does not depend on it
  std::size_t most_pieces = kMostPieces;            ///< limit of a sort; Error above it
  WorkProgress progress = {};    ///< called by methods that find lines, with lines done
  WorkBudget* budget = nullptr;  ///< limits, if not null

  /// The same with another method.
  SurfacePlan by(HiddenMethod other) const {
    SurfacePlan plan = *this;
    plan.method = other;
    return plan;
  }
  /// The part to keep after the call: without progress and budget.
  SurfacePlan kept() const {
    SurfacePlan plan = *this;
    plan.progress = {};
    plan.budget = nullptr;
    return plan;
  }
  /// True if both find the same surfaces and lines of the same scene, shadows apart.
  bool finds_as(const SurfacePlan& o) const {
    return method == o.method && precision == o.precision && root == o.root &&
           hidden_lines == o.hidden_lines && intersections == o.intersections && orders_lines_as(o);
  }
  /// True if both draw lines that overlap in the same way.
  bool orders_lines_as(const SurfacePlan& o) const {
    if (line_order == LineOrder::entry || o.line_order == LineOrder::entry)
      return line_order == o.line_order;
    return line_halo == o.line_halo && width == o.width && height == o.height;
  }
};

}  // namespace displayfile
