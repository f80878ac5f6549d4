#include "programs/sheet/arrangement.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "clip/base/error.h"
#include "programs/sheet/detail_view.h"
#include "programs/sheet/hatched_bodies.h"
#include "programs/sheet/placed_view.h"
#include "programs/sheet/section_marks.h"

namespace displayfile {

namespace {

/// The extent of views that stand in one row or column, in the part's unit.
struct RowExtent {
  double low, high;
  double size() const { return high - low; }
};

RowExtent around(double low, double high, double other_low, double other_high) {
  return {std::min(low, other_low), std::max(high, other_high)};
}

/// The two columns and the two rows. The front view and the one above or below it have their
/// horizontal coordinate in common, the front view and the one beside it the vertical one.
struct Cells {
  RowExtent column, row;  ///< of the front view
  double second_column, other_row;
  Point2 size;  ///< of all, without gaps
};

Cells cells_of(const std::array<PartDrawing, 4>& views) {
  const auto size = [&](std::size_t k) { return views[k].high - views[k].low; };
  const PartDrawing &front = views[0], &top = views[1], &side = views[2];
  Cells cells{};
  cells.column = around(front.low.x, front.high.x, top.low.x, top.high.x);
  cells.row = around(front.low.y, front.high.y, side.low.y, side.high.y);
  cells.second_column = std::max(size(2).x, size(3).x);
  cells.other_row = std::max(size(1).y, size(3).y);
  cells.size = {cells.column.size() + cells.second_column, cells.row.size() + cells.other_row};
  return cells;
}

/// The paper's room, within the frame and above the title block.
Point2 room_for_views(const SheetWords& words) {
  return {words.width - 2.0 * words.margin,
          words.height - words.margin - block_of_titles(words).high.y};
}

std::array<ViewPlace, 4> places_of_views(const std::array<PartDrawing, 4>& views,
                                         const SheetWords& words, double mm) {
  const Cells cells = cells_of(views);
  const Point2 gap = (room_for_views(words) - mm * cells.size) / 3.0;
  const bool third = words.projection == SheetProjection::third;
  const Point2 corner(words.margin, block_of_titles(words).high.y);
  const double left = corner.x + gap.x, right = left + mm * cells.column.size() + gap.x;
  const double low = corner.y + gap.y;
  const double high = low + mm * (third ? cells.row.size() : cells.other_row) + gap.y;
  const double front = third ? low : high, other = third ? high : low;
  // A view in the other row stands as near to the front view as the row allows.
  const auto in_other_row = [&](std::size_t k) {
    const double rest = mm * (cells.other_row - (views[k].high.y - views[k].low.y));
    return third ? other : other + rest;
  };
  const auto in_column = [&](std::size_t k) {
    return left + mm * (views[k].low.x - cells.column.low);
  };
  const auto in_row = [&](std::size_t k) { return front + mm * (views[k].low.y - cells.row.low); };
  const Point2 free_of_isometric(
      mm * (cells.second_column - (views[3].high.x - views[3].low.x)) / 2.0,
      mm * (cells.other_row - (views[3].high.y - views[3].low.y)) / 2.0);
  return {ViewPlace{{in_column(0), in_row(0)}, mm}, ViewPlace{{in_column(1), in_other_row(1)}, mm},
          ViewPlace{{right, in_row(2)}, mm},
          ViewPlace{Point2(right, other) + free_of_isometric, mm}};
}

}  // namespace

std::array<ViewKind, 4> views_of_sheet(SheetProjection projection) {
  const ViewKind side = projection == SheetProjection::third ? ViewKind::right : ViewKind::left;
  return {ViewKind::front, ViewKind::top, side, ViewKind::isometric};
}

DrawingScale scale_of_sheet(const std::array<PartDrawing, 4>& views, const SheetWords& words,
                            const DrawingScale* asked) {
  const Cells cells = cells_of(views);
  const Point2 room = room_for_views(words) - Point2(3.0 * words.least_gap);
  if (room.x <= 0.0 || room.y <= 0.0) {
    throw Error(fmt::format("paper of {}x{} mm with margins of {} mm: no room for four views{}",
                            words.width, words.height, words.margin,
                            words.parts.empty() ? "" : " above the parts list"));
  }
  const auto views_fit = [&](double factor) {
    const Point2 size = cells.size * (words.unit * factor);
    return size.x <= room.x && size.y <= room.y;
  };
  const auto fits = [&](double factor) {
    if (!views_fit(factor)) return false;
    const auto places = places_of_views(views, words, words.unit * factor);
    return places_of_details(views, places, words).has_value();
  };
  if (asked != nullptr && fits(asked->factor())) return *asked;
  const double largest = largest_standard_scale(views_fit).factor();
  // Smaller scales leave more room for details; those that are too small show nothing.
  constexpr double kSmallest = 1.0 / 50.0;
  const DrawingScale found = largest_standard_scale(
      [&](double factor) { return fits(factor) || factor < kSmallest * largest; });
  if (!fits(found.factor())) {
    throw Error(
        "--detail: no room on the paper: expected a smaller circle or scale, or larger paper");
  }
  if (asked == nullptr) return found;
  throw Error(fmt::format("--scale {}: the views do not fit on the paper: expected {} or less",
                          asked->text(), found.text()));
}

DrawingSheet arrange(const std::array<PartDrawing, 4>& views, const PartAnnotation& annotation,
                     const SheetWords& words, const DrawingScale& scale) {
  DrawingSheet sheet;
  sheet.width = words.width;
  sheet.height = words.height;
  sheet.title = words.title;
  const double mm = words.unit * scale.factor();
  const std::array<ViewPlace, 4> places = places_of_views(views, words, mm);
  const auto boxes = places_of_details(views, places, words).value_or(std::vector<PaperBox>());
  const auto hatching = hatching_of_bodies(views, mm, words.hatch);
  std::array<PlacedDrawing, 4> placed;
  for (std::size_t k = 0; k < 4; ++k) {
    add_view(views[k], places[k], hatching, sheet);
    placed[k] = {&views[k], places[k].at, places[k].on_paper(views[k], views[k].high)};
  }
  std::vector<PaperBox> taken = boxes;
  if (!boxes.empty()) {
    const auto letters = add_details(views, places, boxes, words, hatching, sheet);
    taken.insert(taken.end(), letters.begin(), letters.end());
  }
  taken.push_back(block_of_titles(words));
  sheet.not_as_wanted =
      add_annotation(annotation, views, places, usual_places_of_section_marks(placed, mm),
                     words.margin, sheet, taken);
  add_section_marks(placed, taken, words, mm, sheet);
  remove_covered_centre_lines(sheet);
  add_title_block(words, scale, sheet);
  return sheet;
}

}  // namespace displayfile
