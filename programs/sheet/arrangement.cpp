#include "programs/sheet/arrangement.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "clip/error.h"
#include "displayfile/solids/hatched_loops.h"
#include "programs/sheet/chained_lines.h"
#include "programs/sheet/unique_lines.h"

namespace displayfile {

namespace {

constexpr double kLeastGap = 12.0;  // between views, and to the frame

/// Sizes of the two columns and the two rows, in the part's unit.
struct Cells {
  Point2 size;  ///< of all, without gaps
  double first_column, second_column, front_row, other_row;
};

Cells cells_of(const std::array<PartView, 4>& views) {
  const auto size = [&](std::size_t k) { return views[k].high - views[k].low; };
  Cells cells{};
  cells.first_column = size(0).x;
  cells.second_column = std::max(size(2).x, size(3).x);
  cells.front_row = size(0).y;
  cells.other_row = std::max(size(1).y, size(3).y);
  cells.size = {cells.first_column + cells.second_column, cells.front_row + cells.other_row};
  return cells;
}

/// The paper's room, within the frame and above the title block.
Point2 room_for_views(const SheetWords& words) {
  return {words.width - 2.0 * words.margin, words.height - 2.0 * words.margin - kTitleHeight};
}

void add_view(const PartView& view, const Point2& at, double mm, double hatch,
              DrawingSheet& sheet) {
  const auto on_paper = [&](const Point2& p) { return at + mm * (p - view.low); };
  std::vector<PartView::Line> lines;
  for (const PartView::Line& line : view.lines) {
    lines.push_back({on_paper(line.from), on_paper(line.to), line.hidden});
  }
  for (auto& line : chained_lines(unique_lines(lines))) sheet.lines.push_back(std::move(line));
  std::vector<std::vector<Point2>> loops;
  for (const auto& loop : view.cut) {
    auto& placed = loops.emplace_back();
    for (const Point2& p : loop) placed.push_back(on_paper(p));
    sheet.lines.push_back({SheetLayer::visible, placed, true});
  }
  for (const auto& [from, to] : hatched_loops(loops, hatch, kHatchingDirection)) {
    sheet.lines.push_back({SheetLayer::hatch, {from, to}});
  }
}

/// An end of a cutting line: thick for a little, and an arrow that points along the direction in
/// which the section is seen, with the section's letter behind it (ISO 128-3).
void add_cutting_end(const Point2& end, const Point2& along, const Point2& seen,
                     const std::string& letter, DrawingSheet& sheet) {
  constexpr double kThick = 3.5, kArrow = 6.0, kHead = 2.2, kHalfHead = 0.7, kLetter = 3.5;
  const Point2 tail = end - kArrow * seen;
  const Point2 barb = end - kHead * seen;
  const auto add = [&](std::vector<Point2> points, bool closed = false) {
    sheet.lines.push_back({SheetLayer::cutting_ends, std::move(points), closed});
  };
  add({end - kThick * along, end, tail});
  add({end, barb + kHalfHead * along, barb - kHalfHead * along}, true);
  const Point2 middle = tail - (0.9 * kLetter) * seen;
  sheet.texts.push_back({middle - Point2(0.0, kLetter / 2.0), kLetter, letter, true});
}

/// Where a section is cut, in another view: a line across it.
void add_cutting_line(const PartView& other, const Point2& at, double mm, const PartView& cut,
                      const std::string& letter, DrawingSheet& sheet) {
  constexpr double kBeyond = 5.0;
  const Point3 p = in_view(other.kind, *cut.position * toward_viewer(cut.kind));
  const Point2 seen(in_view(other.kind, -toward_viewer(cut.kind)));
  const bool upright = toward_viewer(cut.kind).x != 0.0;
  const Point2 size = mm * (other.high - other.low);
  const Point2 place = at + mm * (Point2(p) - other.low);
  Point2 from(at.x - kBeyond, place.y), to(at.x + size.x + kBeyond, place.y), along(1.0, 0.0);
  if (upright) {
    from = {place.x, at.y - kBeyond};
    to = {place.x, at.y + size.y + kBeyond};
    along = {0.0, 1.0};
  }
  sheet.lines.push_back({SheetLayer::cutting, {from, to}});
  add_cutting_end(from, -along, seen, letter, sheet);
  add_cutting_end(to, along, seen, letter, sheet);
}

}  // namespace

std::array<ViewKind, 4> views_of_sheet(SheetProjection projection) {
  const ViewKind side = projection == SheetProjection::third ? ViewKind::right : ViewKind::left;
  return {ViewKind::front, ViewKind::top, side, ViewKind::isometric};
}

DrawingScale scale_of_sheet(const std::array<PartView, 4>& views, const SheetWords& words,
                            const DrawingScale* asked) {
  const Cells cells = cells_of(views);
  const Point2 room = room_for_views(words) - Point2(3.0 * kLeastGap);
  if (room.x <= 0.0 || room.y <= 0.0) {
    throw Error(fmt::format("paper of {}x{} mm with margins of {} mm: no room for four views",
                            words.width, words.height, words.margin));
  }
  const auto fits = [&](double factor) {
    const Point2 size = cells.size * (words.unit * factor);
    return size.x <= room.x && size.y <= room.y;
  };
  if (asked == nullptr) return largest_standard_scale(fits);
  if (!fits(asked->factor())) {
    throw Error(fmt::format("--scale {}: the views do not fit on the paper: expected {} or less",
                            asked->text(), largest_standard_scale(fits).text()));
  }
  return *asked;
}

DrawingSheet arrange(const std::array<PartView, 4>& views, const SheetWords& words,
                     const DrawingScale& scale) {
  DrawingSheet sheet;
  sheet.width = words.width;
  sheet.height = words.height;
  sheet.title = words.title;
  const double mm = words.unit * scale.factor();
  const Cells cells = cells_of(views);
  const Point2 gap = (room_for_views(words) - mm * cells.size) / 3.0;
  const bool third = words.projection == SheetProjection::third;
  const Point2 corner(words.margin, words.margin + kTitleHeight);
  const double left = corner.x + gap.x, right = left + mm * cells.first_column + gap.x;
  const double low = corner.y + gap.y;
  const double high = low + mm * (third ? cells.front_row : cells.other_row) + gap.y;
  const double front = third ? low : high, other = third ? high : low;
  // A view in the other row stands as near to the front view as the row allows.
  const auto in_other_row = [&](std::size_t k) {
    const double rest = mm * (cells.other_row - (views[k].high.y - views[k].low.y));
    return third ? other : other + rest;
  };
  const Point2 free_of_isometric(
      mm * (cells.second_column - (views[3].high.x - views[3].low.x)) / 2.0,
      mm * (cells.other_row - (views[3].high.y - views[3].low.y)) / 2.0);
  const std::array<Point2, 4> at{Point2(left, front), Point2(left, in_other_row(1)),
                                 Point2(right, front), Point2(right, other) + free_of_isometric};
  char letter = 'A';
  for (std::size_t k = 0; k < 4; ++k) {
    add_view(views[k], at[k], mm, words.hatch, sheet);
    if (!views[k].position) continue;
    constexpr double kTextHeight = 3.5, kBelow = 7.0;
    const double middle = at[k].x + mm * (views[k].high.x - views[k].low.x) / 2.0;
    sheet.texts.push_back(
        {{middle, at[k].y - kBelow}, kTextHeight, fmt::format("{0}-{0}", letter), true});
    const std::size_t shown_in = k == 0 ? 1 : 0;
    add_cutting_line(views[shown_in], at[shown_in], mm, views[k], std::string(1, letter), sheet);
    ++letter;
  }
  add_title_block(words, scale, sheet);
  return sheet;
}

}  // namespace displayfile
