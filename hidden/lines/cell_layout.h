#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/geometry/rectangle.h"
#include "clip/point.h"
#include "hidden/boxes/extents.h"

namespace displayfile {

/// The cell of a place along an axis with this many cells; end cells include everything beyond.
/// Monotonic.
inline std::uint32_t cell_at(double place, std::uint32_t cells) {
  assert(cells > 0);
  if (!(place > 0.0)) return 0;
  return static_cast<std::uint32_t>(std::min(place, static_cast<double>(cells - 1)));
}

/// An extent in the projection.
inline Rectangle rectangle_of(const Extent& e) { return {e.x_min, e.x_max, e.y_min, e.y_max}; }

/// The layout of square cells over a rectangle, at several levels with cell widths doubling, up to
/// a single cell.
class CellLayout {
 public:
  static constexpr double kMostColumns = 8192.0;
  /// A fraction of a cell, far larger than rounding errors and far too small to matter.
  static constexpr double kMargin = 0x1p-20;

  /// No level.
  CellLayout() = default;
  /// Cells of this width, at most kMostColumns; 0 or not finite: a single cell.
  CellLayout(const Rectangle& all, double cell);

  struct Size {
    std::uint32_t columns = 1, rows = 1;
    std::size_t cells() const { return std::size_t{columns} * rows; }
  };
  /// From the finest level to the one that is a single cell.
  std::span<const Size> levels() const { return levels_; }

  const Point2& origin() const { return origin_; }
  double cell() const { return cell_; }  ///< width of the finest level's cells

  /// A point in units of the finest level's cells. A cell (i, j) of level k has all points from i
  /// 2^k to (i + 1) 2^k, j likewise, and a margin of kMargin of a cell, which covers rounding here.
  Point2 in_cells(const Point2& p) const {
    return {(p.x - origin_.x) * cells_a_unit_, (p.y - origin_.y) * cells_a_unit_};
  }

  /// The cells of a level that a box overlaps.
  struct Range {
    std::uint32_t left, right, bottom, top;  // the first and the last
  };
  Range range(const Rectangle& box, std::size_t level) const {
    assert(level < levels_.size());
    const double scale = scales_[level];
    const Point2 low = in_cells({box.x_min, box.y_min}) * scale;
    const Point2 high = in_cells({box.x_max, box.y_max}) * scale;
    const auto& [columns, rows] = levels_[level];
    return {cell_at(low.x - kMargin, columns), cell_at(high.x + kMargin, columns),
            cell_at(low.y - kMargin, rows), cell_at(high.y + kMargin, rows)};
  }

  /// The length of a box in cells of the finest level.
  double length_in_cells(const Rectangle& box) const {
    return cells_a_unit_ * std::max(box.x_max - box.x_min, box.y_max - box.y_min);
  }
  /// The finest level at which a length, in cells of the finest level, is at most `most` of its own
  /// cells.
  std::size_t level_for(double cells, double most) const;

 private:
  Point2 origin_{0.0};
  double cell_ = 1.0, cells_a_unit_ = 0.0;  // of the finest level
  std::vector<Size> levels_;
  std::vector<double> scales_;  // per level, relative to the finest level's cells
};

}  // namespace displayfile
