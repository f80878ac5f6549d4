#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hidden/lines/grid_surface.h"

namespace displayfile {

/// The order of a surface's cells, nearest first, around the foot of the perpendicular from the
/// eye: no later triangle hides part of an earlier one.
class CellsInOrder {
 public:
  explicit CellsInOrder(const GridSurface& surface)
      : surface_(surface), column_(foot_column()), row_(foot_row()) {
    find_second_first();
  }

  /// Calls visit(i, j, second_first) for each cell; second_first: its triangle at (i, j + 1) is
  /// nearer than the one at (i + 1, j).
  template <class Visit>
  void for_each_cell(const Visit& visit) const {
    outward(row_, surface_.rows(), [&](std::uint32_t j) {
      outward(column_, surface_.columns(),
              [&](std::uint32_t i) { visit(i, j, second_first_[diagonal_of(i, j)] != 0); });
    });
  }

 private:
  /// From the foot upward, then downward below it.
  template <class Visit>
  static void outward(std::uint32_t foot, std::uint32_t end, const Visit& visit) {
    for (std::uint32_t k = foot; k < end; ++k) visit(k);
    for (std::uint32_t k = foot; k-- > 0;) visit(k);
  }
  std::uint32_t foot_column() const;
  std::uint32_t foot_row() const;
  /// A number equal for cells whose diagonals are in one vertical plane.
  std::size_t diagonal_of(std::uint32_t i, std::uint32_t j) const {
    assert(i < surface_.columns() && j < surface_.rows());
    return std::size_t{i} + surface_.rows() - j;
  }
  void find_second_first();
  bool eye_is_beyond(std::uint32_t a, std::uint32_t b, std::uint32_t beside) const;

  const GridSurface& surface_;
  std::vector<std::uint8_t> second_first_;  // of each diagonal_of
  std::uint32_t column_, row_;              // the first cells behind those before them
};

}  // namespace displayfile
