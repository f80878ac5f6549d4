#pragma once

/// How hidden surfaces are found, and which lines are drawn: methods, scope, precision, hidden
/// lines, kinds of lines and touching, each with the words for it in drawing programs.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "clip/base/work_budget.h"

namespace displayfile {

// Methods.

/// How hidden surfaces or hidden lines are found. `automatic` lets the system pick. Beside those
/// that have a name here there is the colour rule by each method of surfaces: colour_rule_by().
enum class HiddenMethod {
  automatic,
  none,        ///< the heedless painter: polygons in the order they were entered
  back_face,   ///< the back-face check alone: right for a single convex object
  z_buffer,    ///< in image space, pixel by pixel
  bsp,         ///< in object space: a tree of the polygons' planes (hidden/sort/bsp.md)
  depth_sort,  ///< in object space: a graph of what must be drawn first (hidden/sort/depth_sort.md)
  map,         ///< in object space: what is seen of each polygon (hidden/map/visible_map.md)
  scan_line,   ///< in image space, row by row, without a z-buffer (interp/visibility/scan_line.md)
  scan_line_z,  ///< in image space, row by row, with a z-buffer one row high
  ray_cast,     ///< in image space, a ray through each pixel centre (interp/visibility/ray_cast.md)
  world_ray_cast,  ///< in object space, before viewing: the same by rays in world coordinates
  warnock,         ///< in image space, areas subdivided until it is easy to tell
                   ///< (interp/visibility/warnock.md)
  plain_z_buffer,  ///< the z-buffer as textbooks give it, with the depths' rounding and all that it
                   ///< gets wrong (interp/visibility/plain_z_buffer.h): depths as floats;
  plain_z_buffer_16,      ///< as integers of 16 bits,
  plain_z_buffer_24,      ///< of 24,
  plain_z_buffer_32,      ///< of 32;
  plain_z_buffer_double,  ///< as doubles. Never what `automatic` picks, as no plain form is
  plain_scan_line,  ///< `scan_line`, as textbooks give it (interp/visibility/plain_scan_line.h)
  plain_warnock,    ///< `warnock`, the same (interp/visibility/plain_warnock.h)
  plain_bsp,        ///< `bsp`, the same (hidden/sort/plain_bsp.h)
  roberts,          ///< lines in object space, each against all polygons (hidden/lines/roberts.md)
  appel,            ///< lines in object space, by the number of polygons before them
                    ///< (hidden/lines/appel.md)
  franklin,         ///< lines in object space, by cells of the picture (hidden/lines/franklin.md)
  perimeter,        ///< the curves of one surface over a grid (hidden/lines/perimeter.md)
  plain_appel,      ///< `appel`, as textbooks give it (hidden/lines/plain_appel.h)
  colour_rule,      ///< fills in the background's colour, lines over them, by the surfaces that
                    ///< `automatic` finds (interp/raster/colour_rule.md). The last of this list
};

/// The colour rule by a method of surfaces; by `automatic` it is HiddenMethod::colour_rule.
constexpr HiddenMethod colour_rule_by(HiddenMethod surfaces) {
  return static_cast<HiddenMethod>(static_cast<int>(HiddenMethod::colour_rule) +
                                   static_cast<int>(surfaces));
}
constexpr bool is_colour_rule(HiddenMethod method) { return method >= HiddenMethod::colour_rule; }
/// The method by which a colour rule finds surfaces; of another method, that method.
constexpr HiddenMethod surfaces_of(HiddenMethod method) {
  if (!is_colour_rule(method)) return method;
  return static_cast<HiddenMethod>(static_cast<int>(method) -
                                   static_cast<int>(HiddenMethod::colour_rule));
}

/// True for the methods that find which lines are seen: polygons hide, but their fills are not
/// drawn.
constexpr bool finds_lines(HiddenMethod method) {
  return method == HiddenMethod::roberts || method == HiddenMethod::appel ||
         method == HiddenMethod::franklin || method == HiddenMethod::perimeter ||
         method == HiddenMethod::plain_appel;
}
/// True for what draws surfaces over grids alone, and refuses other scenes.
constexpr bool needs_surface(HiddenMethod method) { return method == HiddenMethod::perimeter; }

/// True for the methods whose pictures are of lines: of fills nothing is seen but what they hide.
constexpr bool shows_lines_only(HiddenMethod method) {
  return finds_lines(method) || is_colour_rule(method);
}

/// One line a name: that of a method in drawing programs and on the command line. A method's first
/// name is the one it is written with. Of the colour rules only the first is in the list.
struct HiddenMethodEntry {
  HiddenMethod method;
  std::string_view name;
};
std::span<const HiddenMethodEntry> hidden_methods();

/// The method of that name; for colour-rule=METHOD the colour rule by that method of surfaces.
/// Throws Error for any other name, after colour-rule= also for a method that finds no surfaces,
/// and lists the names that are allowed there.
HiddenMethod hidden_method(std::string_view name);
std::string_view name_of(HiddenMethod method);

// Scope, precision and hidden lines.

/// Among which polygons hidden surfaces are sorted.
enum class HiddenScope {
  segment,  ///< the textbook's: those of one segment; segments are drawn in order of creation
  all,      ///< those of all visible segments together
};

/// Reads `segment` or `all`; throws Error for anything else.
HiddenScope hidden_scope(std::string_view text);
std::string_view name_of(HiddenScope scope);

/// The precision of a method that finds hidden surfaces: `exact`, or `roundoff` with ROUNDOFF as a
/// part of the scene's size.
struct Precision {
  static constexpr double kUsualRoundoff = 1e-9;
  bool exact = true;
  double roundoff = kUsualRoundoff;
  /// True if both find the same: an exact one has no use for its roundoff.
  bool operator==(const Precision& o) const {
    return exact == o.exact && (exact || roundoff == o.roundoff);
  }
};

/// Reads `exact`, `roundoff` or `roundoff=EPS`; throws Error for anything else, and unless
/// 0 <= EPS < 1.
Precision precision(std::string_view text);

/// How lines are drawn where they are hidden.
enum class HiddenLines {
  none,    ///< they are not drawn
  dashed,  ///< they are drawn dashed, before the visible ones (hidden/lines/hidden_pieces.md)
};

/// Reads `none` or `dashed`; throws Error for anything else.
HiddenLines hidden_lines(std::string_view text);
std::string_view name_of(HiddenLines lines);

/// How the root of a (sub)tree of polygons is chosen, by `bsp`.
enum class RootChoice {
  last,    ///< the textbook's: the polygon entered last (algorithm 9.8)
  first,   ///< the polygon entered first
  sample,  ///< of a sample of polygons the one with the lowest cost of cuts and balance
  free,    ///< also of planes that belong to no polygon; and only among polygons that overlap
};

/// By the names last, first, sample and free. Throws Error for any other.
RootChoice root_choice(std::string_view name);

/// Into how many pieces a sort may cut polygons, unless another number is set.
inline constexpr std::size_t kMostPieces = 10'000'000;

/// How one call finds hidden surfaces and lines: what has a value here is in place of what the
/// application set.
struct HiddenSurfaceOptions {
  std::optional<HiddenMethod> method = std::nullopt;
  std::optional<HiddenScope> scope = std::nullopt;
  std::optional<Precision> precision = std::nullopt;
  std::optional<HiddenLines> hidden_lines = std::nullopt;
  RootChoice root = RootChoice::free;     ///< of the trees of `bsp`; Error for any other method
  int threads = 1;                        ///< at most, 1 or more; the result is the same for any
  std::size_t most_pieces = kMostPieces;  ///< that a sort may cut polygons into; Error for more
  /// Called by a method that finds lines with the number of lines it has done, anew for each
  /// segment, or group of segments, that is looked at by itself.
  WorkProgress progress = {};
  /// What the call may use at most, and a way to stop it, if not null: LimitReached for more, and
  /// no file is written (clip/base/work_budget.md).
  WorkBudget* budget = nullptr;
};

// Lines.

/// Why a line is a line (displayfile/segments/line_kinds.md), a bit each. A line may be of several
/// kinds; the first of them, in this order, is the one that it is sorted under where only one can
/// be.
enum class LineKind : std::uint8_t {
  outline = 2,        ///< a side between polygons that face the viewer and others that do not
  boundary = 4,       ///< a side that one polygon alone has
  crease = 8,         ///< a side at which two polygons meet at an angle
  material = 16,      ///< a side at which fills differ
  intersection = 32,  ///< where two polygons pass through each other
  all = 64,           ///< a side that the line style shows
};

/// Kinds of a line, together. Where sides carry them, 0 is a side that is not drawn.
using LineKinds = std::uint8_t;
/// A line whose kind was not looked for.
inline constexpr LineKinds kDrawn = 1;

constexpr LineKinds kinds_of(LineKind kind) { return static_cast<LineKinds>(kind); }
constexpr bool contains(LineKinds kinds, LineKind kind) { return (kinds & kinds_of(kind)) != 0; }
/// True if its kind was looked for.
constexpr bool has_kind(LineKinds kinds) { return kinds > kDrawn; }

struct LineKindEntry {
  LineKind kind;
  std::string_view name;
};
/// All kinds, in order.
std::span<const LineKindEntry> line_kinds();
/// The names of the kinds, in order, with a blank between two; empty of a line without any.
std::string names_of(LineKinds kinds);
/// The name of the first kind; empty of a line without any.
std::string_view first_name_of(LineKinds kinds);

/// Which lines are drawn: those of one of these kinds or more.
struct LineSelection {
  LineKinds kinds = kinds_of(LineKind::all);
  double crease_degrees = 30.0;  ///< a crease turns by more, 0 to 180

  /// True if all that the line style shows is selected, and no more: then no kinds are looked for.
  bool is_all_alone() const { return kinds == kinds_of(LineKind::all); }
  bool operator==(const LineSelection&) const = default;
};

/// Adds a word to a selection, `all`, `outline`, `boundary`, `crease`, `crease=DEGREES`,
/// `intersection` or `material`. Throws Error for another word, or for degrees that
/// are not a number from 0 to 180.
void add_line_kind(std::string_view word, LineSelection& selection);
/// Reads words with commas between them. Throws Error if there are none, too.
LineSelection line_selection(std::string_view text);
/// The words, with blanks between them, that read back to the selection.
std::string words_of(const LineSelection& selection);
/// Throws Error for a selection of no kind, or of what is none, or of degrees out of their range.
void require_selection(const LineSelection& selection);

/// At which ends a part of a line is cut: the line goes on there, but something hides the rest of
/// it, or it is outside of the view. An end that is not cut is an end of the line itself.
struct LineCuts {
  bool at_start = false, at_end = false;

  bool any() const { return at_start || at_end; }
  LineCuts reversed() const { return {at_end, at_start}; }
  bool operator==(const LineCuts&) const = default;

  /// As a byte, 0 without cuts.
  std::uint8_t byte() const {
    return static_cast<std::uint8_t>((at_start ? 1 : 0) | (at_end ? 2 : 0));
  }
  static LineCuts of(std::uint8_t byte) { return {(byte & 1) != 0, (byte & 2) != 0}; }
};

// Touching.

/// Within which distance parts of a scene touch: their *reach* (interp/truth/entered_truth.md).
/// Files and decimals say less exactly than they mean, so that what is meant to touch lies a few
/// units of its last digit apart.
struct Touching {
  enum class Kind {
    automatic,  ///< by the precision of the input's numbers
    off,        ///< nothing touches but what coincides exactly
    length,     ///< within that length
  };
  Kind kind = Kind::automatic;
  double length = 0.0;  ///< in the coordinates of the input, before its modelling transformation

  bool operator==(const Touching&) const = default;
};

/// By what part of the largest a number may be off, as it is rounded.
inline constexpr double kUnitOfDoubles = 0x1p-52, kUnitOfSingles = 0x1p-24;

/// The reach before the modelling transformation. `largest` is the largest magnitude of a
/// coordinate that was entered, of polygons and lines; `unit` is that of these numbers.
double entered_reach(const Touching& touching, double largest, double unit = kUnitOfDoubles);
/// The default.
inline constexpr Touching kUnlessSet{Touching::Kind::automatic};

/// Throws Error unless a length is above 0 and at most kCoordinateLimit.
void require_touching(const Touching& touching);
/// As `touching` reads it.
std::string word_of(const Touching& touching);

/// `auto`, `off` or a positive number up to kCoordinateLimit; throws Error for anything else.
Touching touching(std::string_view word);

}  // namespace displayfile
