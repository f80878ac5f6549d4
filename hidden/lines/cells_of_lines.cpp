#include "hidden/lines/cells_of_lines.h"

#include <algorithm>
#include <cmath>

#include "clip/geometry/corners.h"
#include "hidden/lines/cell_walk.h"

namespace displayfile {

namespace {

/// Lines are few if their number, and the number of cells that they pass through, is at most this
/// fraction of the items. There are about as many cells as items.
constexpr std::size_t kPartWithLines = 4;
/// A box is looked up at the level where it is no longer than this many cells.
constexpr double kLongestLookedUp = 4.0;

bool meet(const Rectangle& a, const Rectangle& b) {
  return a.x_min <= b.x_max && b.x_min <= a.x_max && a.y_min <= b.y_max && b.y_min <= a.y_max;
}

}  // namespace

CellsOfLines::CellsOfLines(const Primitives& items, std::span<const LineName> names,
                           std::span<const IntersectionLine> intersections) {
  const std::size_t count = names.size() + intersections.size();
  if (count == 0 || count > items.items.size() / kPartWithLines) return;
  std::vector<Line> lines;
  lines.reserve(count);
  for (const LineName& name : names) {
    const PointRow points = items.points_of(items.items[name.item]);
    const auto before = previous_corner<std::size_t>(name.corner, points.size());
    lines.push_back({Point2(points[before]), Point2(points[name.corner]), 0.0});
  }
  for (const IntersectionLine& line : intersections) {
    lines.push_back({Point2(line.from.near), Point2(line.to.near),
                     2.0 * std::max(line.from.radius, line.to.radius)});
  }
  Extent all = Extent::nothing();
  for (const Line& line : lines) {
    all.include(Point3(line.from, 0.0), line.margin);
    all.include(Point3(line.to, 0.0), line.margin);
  }
  all_ = rectangle_of(all);
  const double longer = std::max(all_.x_max - all_.x_min, all_.y_max - all_.y_min);
  const std::size_t most = items.items.size() / kPartWithLines;
  layout_ = CellLayout(all_, longer / std::sqrt(static_cast<double>(items.items.size())));
  if (enter(lines, most)) pass_on();
}

/// Marks the cells of the finest level that lines pass through. False if there are more than
/// `most`.
bool CellsOfLines::enter(const std::vector<Line>& lines, std::size_t most) {
  const CellLayout::Size& size = layout_.levels()[0];
  std::vector<std::uint8_t> cells(size.cells(), 0);
  std::size_t entered = 0;
  for (const Line& line : lines) {
    const Point2 from = layout_.in_cells(line.from), to = layout_.in_cells(line.to);
    const double margin = line.margin / layout_.cell() + CellLayout::kMargin;
    if (!std::isfinite(margin)) return false;
    for_each_cell_near(size, from, to, margin, [&](std::size_t cell) {
      cells[cell] = 1;
      ++entered;
    });
    if (entered > most) return false;
  }
  with_lines_.push_back(std::move(cells));
  return true;
}

/// A line that passes through one of a cell's four parts passes through the cell.
void CellsOfLines::pass_on() {
  for (std::size_t k = 1; k < layout_.levels().size(); ++k) {
    const CellLayout::Size &parts = layout_.levels()[k - 1], &whole = layout_.levels()[k];
    std::vector<std::uint8_t> cells(whole.cells(), 0);
    for (std::uint32_t j = 0; j < parts.rows; ++j) {
      for (std::uint32_t i = 0; i < parts.columns; ++i) {
        cells[std::size_t{j / 2} * whole.columns + i / 2] |=
            with_lines_[k - 1][std::size_t{j} * parts.columns + i];
      }
    }
    with_lines_.push_back(std::move(cells));
  }
}

bool CellsOfLines::come_near(const Rectangle& box) const {
  if (are_everywhere()) return true;
  if (!meet(box, all_)) return false;
  const std::size_t level = layout_.level_for(layout_.length_in_cells(box), kLongestLookedUp);
  const CellLayout::Range cells = layout_.range(box, level);
  const std::uint32_t columns = layout_.levels()[level].columns;
  for (std::uint32_t j = cells.bottom; j <= cells.top; ++j) {
    for (std::uint32_t i = cells.left; i <= cells.right; ++i) {
      if (with_lines_[level][std::size_t{j} * columns + i] != 0) return true;
    }
  }
  return false;
}

}  // namespace displayfile
