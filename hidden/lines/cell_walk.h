#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "hidden/lines/cell_layout.h"
#include "hidden/lines/hidden_parts.h"

namespace displayfile {

/// The cells of one column through which a stretch of a line passes (or of one row, for a steep
/// line).
struct CellsOfStretch {
  PartOfLine part;  ///< the stretch, as a part of the line
  bool inside;      ///< it stays within the grid
  std::uint32_t low, high;
  std::uint32_t first, step;

  /// The cells' numbers, row by row, for j from low to high.
  std::size_t cell(std::uint32_t j) const {
    assert(low <= j && j <= high);
    return first + std::size_t{j} * step;
  }
};

/// Walks along a line, whose ends are in units of that level's cells, column by column, or row by
/// row if it is steep, until visit(stretch) returns false. The cells' borders are at parameters
/// that are doubles, and each stretch begins where the one before ends.
template <class Visit>
void walk_cells(const CellLayout::Size& level, const Point2& from, const Point2& to,
                const Visit& visit) {
  const Point2 along = to - from;
  const int axis = std::abs(along.x) >= std::abs(along.y) ? 0 : 1, other = 1 - axis;
  const std::uint32_t count = axis == 0 ? level.columns : level.rows;
  const std::uint32_t others = axis == 0 ? level.rows : level.columns;
  const std::uint32_t first = cell_at(from[axis], count), last = cell_at(to[axis], count);
  const bool rising = first <= last;
  const auto within = [](double u, double v, std::uint32_t cells) {
    return std::min(u, v) >= 0.0 && std::max(u, v) <= cells;
  };
  double t = 0.0;
  for (std::uint32_t i = first;; rising ? ++i : --i) {
    double next = 1.0;
    if (i != last) {
      const double border = rising ? i + 1.0 : i + 0.0;
      next = std::clamp((border - from[axis]) / along[axis], t, 1.0);
    }
    const double v = from[other] + t * along[other], w = from[other] + next * along[other];
    const double u = from[axis] + t * along[axis], x = from[axis] + next * along[axis];
    const bool inside = within(u, x, count) && within(v, w, others);
    const bool goes_on = visit(CellsOfStretch{{t, next},
                                              inside,
                                              cell_at(std::min(v, w), others),
                                              cell_at(std::max(v, w), others),
                                              axis == 0 ? i : i * level.columns,
                                              axis == 0 ? level.columns : 1});
    if (!goes_on || i == last) return;
    t = next;
  }
}

/// Calls visit(cell) for the cells of that level that contain a point of the line, or of a margin
/// around it, in cells; for some more than once. The line's ends are in units of cells.
template <class Visit>
void for_each_cell_near(const CellLayout::Size& level, const Point2& from, const Point2& to,
                        double margin, const Visit& visit) {
  const Point2 along = to - from;
  const int axis = std::abs(along.x) >= std::abs(along.y) ? 0 : 1, other = 1 - axis;
  const std::uint32_t count = axis == 0 ? level.columns : level.rows;
  const std::uint32_t others = axis == 0 ? level.rows : level.columns;
  const double rise = along[axis] == 0.0 ? 0.0 : along[other] / along[axis];
  const double low = std::min(from[axis], to[axis]), high = std::max(from[axis], to[axis]);
  const std::uint32_t last = cell_at(high + margin, count);
  for (std::uint32_t i = cell_at(low - margin, count); i <= last; ++i) {
    const double u = std::clamp(i + 0.0, low, high), v = std::clamp(i + 1.0, low, high);
    const double p = from[other] + (u - from[axis]) * rise;
    const double q = from[other] + (v - from[axis]) * rise;
    const std::uint32_t end = cell_at(std::max(p, q) + margin, others);
    for (std::uint32_t j = cell_at(std::min(p, q) - margin, others); j <= end; ++j) {
      visit(axis == 0 ? std::size_t{j} * count + i : std::size_t{i} * others + j);
    }
  }
}

}  // namespace displayfile
