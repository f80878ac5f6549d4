#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat4x3.hpp>
#include <iterator>
#include <vector>

namespace displayfile {

/// The modelling matrices of points or polygons, which are numbered in order of entry: each matrix
/// from a number on, the identity before the first.
class ModellingRuns {
 public:
  using Matrix = glm::dmat4x3;  ///< x' = column 0 x + column 1 y + column 2 z + column 3
  struct Run {
    std::uint32_t first;
    Matrix matrix;
  };

  bool empty() const { return runs_.empty(); }
  const std::vector<Run>& runs() const { return runs_; }

  /// Sets the matrix of the points or polygons from `first` on; null: the identity.
  void begin(std::size_t first, const Matrix* matrix) {
    if (matrix == nullptr && runs_.empty()) return;
    static constexpr Matrix kIdentity(1.0);
    const Matrix& begun = matrix == nullptr ? kIdentity : *matrix;
    if (runs_.empty() || runs_.back().matrix != begun) {
      runs_.push_back({static_cast<std::uint32_t>(first), begun});
    }
  }

  /// The matrix in force at that number; null for the identity. Valid until another begins.
  const Matrix* at(std::size_t number) const {
    const auto after = std::ranges::upper_bound(runs_, number, {}, &Run::first);
    if (after == runs_.begin()) return nullptr;
    const Matrix& matrix = std::prev(after)->matrix;
    return matrix == Matrix(1.0) ? nullptr : &matrix;
  }

  /// The length of the longest column, at least 1.
  double longest_column() const {
    double most = 1.0;
    for (const auto& [first, m] : runs_) {
      for (int k = 0; k < 3; ++k) most = std::max(most, glm::length(m[k]));
    }
    return most;
  }

  /// Bound on all world coordinates, and on the products summed for them, where no coordinate
  /// entered is larger than `largest`.
  double largest_in_world(double largest) const {
    double most = largest;
    for (const auto& [first, m] : runs_) {
      for (int k = 0; k < 3; ++k) {
        const double row = std::abs(m[0][k]) + std::abs(m[1][k]) + std::abs(m[2][k]);
        most = std::max(most, row * largest + std::abs(m[3][k]));
      }
    }
    return most;
  }

 private:
  std::vector<Run> runs_;
};

}  // namespace displayfile
