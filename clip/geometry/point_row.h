#pragma once

#include <array>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// A polygon's corners in contiguous memory: in place, or gathered here from shared points. Spans
/// of them are valid during its lifetime.
class PointRow {
 public:
  /// Contiguous points: a span, an array, a vector. They must outlive it.
  template <std::convertible_to<std::span<const Point3>> Row>
  requires(!std::same_as<Row, PointRow>) PointRow(const Row& row) : row_(row) {}
  /// The points with these indices.
  PointRow(std::span<const Point3> points, std::span<const std::uint32_t> corners) {
    if (corners.size() > kFew) many_.resize(corners.size());
    Point3* const row = corners.size() > kFew ? many_.data() : few_.data();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      assert(corners[i] < points.size());
      row[i] = points[corners[i]];
    }
    row_ = {row, corners.size()};
  }
  PointRow(const PointRow&) = delete;
  PointRow& operator=(const PointRow&) = delete;

  std::span<const Point3> row() const { return row_; }
  const Point3* data() const { return row_.data(); }
  std::size_t size() const { return row_.size(); }
  bool empty() const { return row_.empty(); }
  const Point3& operator[](std::size_t i) const {
    assert(i < row_.size());
    return row_[i];
  }
  const Point3& front() const { return row_.front(); }
  const Point3& back() const { return row_.back(); }
  auto begin() const { return row_.begin(); }
  auto end() const { return row_.end(); }

 private:
  static constexpr std::size_t kFew = 8;
  std::array<Point3, kFew> few_;
  std::vector<Point3> many_;
  std::span<const Point3> row_;
};

}  // namespace displayfile
