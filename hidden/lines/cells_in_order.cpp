#include "hidden/lines/cells_in_order.h"

#include <algorithm>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

namespace displayfile {

/// True if the eye and a third point are on the same side of the vertical plane through two:
/// compares the signs of two volumes, with the eye infinitely far toward growing depth. If the eye
/// is in the plane except for rounding, neither side hides the other.
bool CellsInOrder::eye_is_beyond(std::uint32_t a, std::uint32_t b, std::uint32_t beside) const {
  const auto homogeneous = [&](std::uint32_t k) {
    return HomogeneousPoint(surface_.point(k), 1.0);
  };
  const HomogeneousPoint p = homogeneous(a), way = homogeneous(b) - p;
  const HomogeneousPoint& up = surface_.upward();
  const double of_eye =
      glm::determinant(glm::dmat4(p, way, up, HomogeneousPoint(0.0, 0.0, 1.0, 0.0)));
  const double of_point = glm::determinant(glm::dmat4(p, way, up, homogeneous(beside) - p));
  return (of_eye > 0.0) == (of_point > 0.0);
}

/// The column of the first cell that is not nearer than the next: the number of grid curves beyond
/// which the eye is, minus one.
std::uint32_t CellsInOrder::foot_column() const {
  std::uint32_t beyond = 0;
  const std::uint32_t last = surface_.columns(), top = surface_.rows();
  for (std::uint32_t i = 0; i <= last; ++i) {
    const std::uint32_t a = surface_.number(i, 0), b = surface_.number(i, top);
    const bool is_beyond = i < last ? eye_is_beyond(a, b, surface_.number(i + 1, 0))
                                    : !eye_is_beyond(a, b, surface_.number(i - 1, 0));
    beyond += is_beyond ? 1 : 0;
  }
  return beyond == 0 ? 0 : beyond - 1;
}

std::uint32_t CellsInOrder::foot_row() const {
  std::uint32_t beyond = 0;
  const std::uint32_t last = surface_.rows(), right = surface_.columns();
  for (std::uint32_t j = 0; j <= last; ++j) {
    const std::uint32_t a = surface_.number(0, j), b = surface_.number(right, j);
    const bool is_beyond = j < last ? eye_is_beyond(a, b, surface_.number(0, j + 1))
                                    : !eye_is_beyond(a, b, surface_.number(0, j - 1));
    beyond += is_beyond ? 1 : 0;
  }
  return beyond == 0 ? 0 : beyond - 1;
}

void CellsInOrder::find_second_first() {
  const std::uint32_t columns = surface_.columns(), rows = surface_.rows();
  second_first_.resize(std::size_t{columns} + rows);
  const auto find_from = [&](std::uint32_t i, std::uint32_t j) {
    const std::uint32_t length = std::min(columns - i, rows - j);
    second_first_[diagonal_of(i, j)] = eye_is_beyond(
        surface_.number(i, j), surface_.number(i + length, j + length), surface_.number(i, j + 1));
  };
  for (std::uint32_t i = 0; i < columns; ++i) find_from(i, 0);
  for (std::uint32_t j = 1; j < rows; ++j) find_from(0, j);
}

}  // namespace displayfile
