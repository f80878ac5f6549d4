#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "clip/base/words.h"
#include "displayfile/looks/style.h"

namespace displayfile {

namespace {

constexpr Word<StyledLines> kStyledLines[] = {
    {StyledLines::outline, "outline"},
    {StyledLines::boundary, "boundary"},
    {StyledLines::crease, "crease"},
    {StyledLines::material, "material"},
    {StyledLines::intersection, "intersection"},
    {StyledLines::all, "all"},
    {StyledLines::hidden, "hidden"},
    {StyledLines::hatch, "hatch"},
};

std::size_t index_of(StyledLines lines) { return static_cast<std::size_t>(lines); }

/// The bits of kinds are in the order of StyledLines, from outline on.
StyledLines first_of(LineKinds kinds) {
  static_assert(kinds_of(LineKind::outline) == 2 && kinds_of(LineKind::all) == 64 &&
                StyledLines::all == static_cast<StyledLines>(5));
  const int determined = kinds & ~(kDrawn | kHiddenLine);
  if (determined == 0) return StyledLines::all;
  return static_cast<StyledLines>(std::countr_zero(static_cast<unsigned>(determined)) - 1);
}

/// Width, colour and kind; and the dashes, unless they depend on the width.
void apply(const LineKindStyle& own, LineStyle& line) {
  line.width = own.width.value_or(line.width);
  line.colour = own.colour.value_or(line.colour);
  line.kind = own.kind.value_or(line.kind);
  line.dash = own.dash.value_or(line.dash);
  line.gap = own.gap.value_or(line.gap);
}

}  // namespace

StyledLines styled_lines(std::string_view text) { return value_of(kStyledLines, text, "expected"); }
std::string_view name_of(StyledLines lines) { return word_of(kStyledLines, lines); }

struct LineKindStyles::Table {
  std::array<LineKindStyle, std::size(kStyledLines)> styles{};
  bool operator==(const Table&) const = default;
};

const LineKindStyle& LineKindStyles::of(StyledLines lines) const {
  static const LineKindStyle kDefault{};
  return empty() ? kDefault : table_->styles[index_of(lines)];
}

LineKindStyles LineKindStyles::with(StyledLines lines, const LineKindStyle& style) const {
  if (of(lines) == style) return *this;
  Table table = empty() ? Table{} : *table_;
  table.styles[index_of(lines)] = style;
  LineKindStyles changed;
  if (table != Table{}) changed.table_ = std::make_shared<const Table>(table);
  return changed;
}

bool LineKindStyles::operator==(const LineKindStyles& other) const {
  if (table_ == other.table_) return true;
  return !empty() && !other.empty() && *table_ == *other.table_;
}

LineStyle side_line_style(const LineStyle& line, LineKinds kinds) {
  LineStyle side = line;
  if (line.of_kinds.empty() || line.kind == LineStyle::Kind::none) return side;
  apply(line.of_kinds.of(first_of(kinds)), side);
  return side;
}

LineStyle hidden_line_style(const LineStyle& line) {
  const LineKindStyle& own = line.of_kinds.of(StyledLines::hidden);
  LineStyle hidden = line;
  hidden.kind = LineStyle::Kind::dashed;
  hidden.width = own.width.value_or(std::min(line.width, std::max(0.5, line.width / 2.0)));
  hidden.dash *= std::max(1.0, hidden.width);
  hidden.gap *= std::max(1.0, hidden.width);
  apply(own, hidden);
  return hidden;
}

LineStyle hatching_line_style(const LineStyle& line) {
  const LineKindStyle& own = line.of_kinds.of(StyledLines::hatch);
  LineStyle hatching = line;
  if (line.kind == LineStyle::Kind::none && own != LineKindStyle{}) {
    hatching.kind = LineStyle::Kind::solid;
  }
  if (hatching.kind != LineStyle::Kind::none) apply(own, hatching);
  return hatching;
}

}  // namespace displayfile
