#include "programs/sheet/arrangement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "clip/base/error.h"
#include "displayfile/solids/hatched_loops.h"
#include "programs/sheet/chained_lines.h"
#include "programs/sheet/section_marks.h"
#include "programs/sheet/unique_lines.h"

namespace displayfile {

namespace {

constexpr double kLeastGap = 12.0;     // between views, and to the frame
constexpr double kLeastLength = 1e-6;  // of a line, or across a cut face

/// Sizes of the two columns and the two rows, in the part's unit.
struct Cells {
  Point2 size;  ///< of all, without gaps
  double first_column, second_column, front_row, other_row;
};

Cells cells_of(const std::array<PartDrawing, 4>& views) {
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

/// False where a plane touches a curved face: there rounding may leave a loop with nothing in it.
bool has_area(const std::vector<Point2>& loop) {
  double twice_area = 0.0, around = 0.0;
  Point2 from = loop.back();
  for (const Point2& to : loop) {
    const Point2 a = from - loop.front(), b = to - loop.front();
    twice_area += a.x * b.y - b.x * a.y;
    around += glm::distance(from, to);
    from = to;
  }
  return std::abs(twice_area) > kLeastLength * around;
}

void add_view(const PartDrawing& view, const Point2& at, double mm, double hatch,
              DrawingSheet& sheet) {
  const auto on_paper = [&](const Point2& p) { return at + mm * (p - view.low); };
  std::vector<PartDrawing::Line> lines;
  for (const PartDrawing::Line& line : view.lines) {
    const Point2 from = on_paper(line.from), to = on_paper(line.to);
    if (line.is_alone && glm::distance(from, to) < pen_of(SheetLayer::visible).width) continue;
    lines.push_back({from, to, line.hidden});
  }
  std::vector<std::vector<Point2>> loops;
  for (const auto& loop : view.cut) {
    std::vector<Point2> placed;
    placed.reserve(loop.size());
    for (const Point2& p : loop) placed.push_back(on_paper(p));
    if (!has_area(placed)) continue;
    Point2 from = placed.back();
    for (const Point2& to : placed) lines.push_back({std::exchange(from, to), to, false});
    loops.push_back(std::move(placed));
  }
  for (auto& line : chained_lines(unique_lines(lines))) sheet.lines.push_back(std::move(line));
  for (const auto& [from, to] :
       hatched_loops(loops, WithinLoops::wound, hatch, kHatchingDirection)) {
    if (glm::distance(from, to) > kLeastLength) {
      sheet.lines.push_back({SheetLayer::hatch, {from, to}});
    }
  }
}

}  // namespace

std::array<ViewKind, 4> views_of_sheet(SheetProjection projection) {
  const ViewKind side = projection == SheetProjection::third ? ViewKind::right : ViewKind::left;
  return {ViewKind::front, ViewKind::top, side, ViewKind::isometric};
}

DrawingScale scale_of_sheet(const std::array<PartDrawing, 4>& views, const SheetWords& words,
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

DrawingSheet arrange(const std::array<PartDrawing, 4>& views, const SheetWords& words,
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
  std::array<PlacedDrawing, 4> placed;
  for (std::size_t k = 0; k < 4; ++k) {
    add_view(views[k], at[k], mm, words.hatch, sheet);
    placed[k] = {&views[k], at[k], at[k] + mm * (views[k].high - views[k].low)};
  }
  add_section_marks(placed, words, mm, sheet);
  add_title_block(words, scale, sheet);
  return sheet;
}

}  // namespace displayfile
