#include "hidden/lines/cell_layout.h"

#include <cassert>
#include <cmath>

namespace displayfile {

CellLayout::CellLayout(const Rectangle& all, double cell) {
  const double width = all.x_max - all.x_min, height = all.y_max - all.y_min;
  const double longer = std::max(width, height);
  Size size;
  constexpr double kLeast = 1e-290;  // 1 over a cell of less may be infinite
  if (std::isfinite(longer) && longer > kLeast) {
    origin_ = {all.x_min, all.y_min};
    cell_ = std::max(cell, longer / kMostColumns);
    cells_a_unit_ = 1.0 / cell_;
    size = {static_cast<std::uint32_t>(width * cells_a_unit_) + 1,
            static_cast<std::uint32_t>(height * cells_a_unit_) + 1};
  }
  levels_.push_back(size);
  scales_.push_back(1.0);
  while (size.columns > 1 || size.rows > 1) {
    size = {(size.columns + 1) / 2, (size.rows + 1) / 2};
    levels_.push_back(size);
    scales_.push_back(scales_.back() / 2.0);
  }
  assert(levels_.back().cells() == 1 && scales_.size() == levels_.size());
}

std::size_t CellLayout::level_for(double cells, double most) const {
  assert(!levels_.empty());
  if (!(cells > most)) return 0;
  return std::min(static_cast<std::size_t>(std::ilogb(cells / most)) + 1, levels_.size() - 1);
}

}  // namespace displayfile
