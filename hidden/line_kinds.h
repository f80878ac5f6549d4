#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace displayfile {

/// Why a line is a line (displayfile/line_kinds.md), a bit each. A line may be of several kinds;
/// the first of them, in this order, is the one that it is sorted under where only one can be.
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
/// A line of which nobody asked what kind it is.
inline constexpr LineKinds kDrawn = 1;

constexpr LineKinds kinds_of(LineKind kind) { return static_cast<LineKinds>(kind); }
constexpr bool contains(LineKinds kinds, LineKind kind) { return (kinds & kinds_of(kind)) != 0; }
/// True if it was asked what kind it is.
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

  /// What the line style shows and no more: then nothing needs to be found out.
  bool is_all_alone() const { return kinds == kinds_of(LineKind::all); }
  bool operator==(const LineSelection&) const = default;
};

/// Adds what a word asks for, `all`, `outline`, `boundary`, `crease`, `crease=DEGREES`,
/// `intersection` or `material`, to a selection. Throws Error for another word, or for degrees that
/// are not a number from 0 to 180.
void add_line_kind(std::string_view word, LineSelection& selection);
/// Reads words with commas between them. Throws Error if there are none, too.
LineSelection line_selection(std::string_view text);
/// The words, with blanks between them, that read back to the selection.
std::string words_of(const LineSelection& selection);
/// Throws Error for a selection of no kind, or of what is none, or of degrees out of their range.
void require_selection(const LineSelection& selection);

}  // namespace displayfile
