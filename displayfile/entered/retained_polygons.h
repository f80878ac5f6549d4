#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "clip/base/growing_array.h"
#include "clip/geometry/point_row.h"

namespace displayfile {

/// A polygon of a retained scene (displayfile/segments/retained_scene.h), or a line of two points.
struct RetainedPrimitive {
  std::uint32_t first;  ///< of its corners
  std::uint32_t sides;  ///< 2: a line
  std::uint32_t look;   ///< index of its attributes
  std::int32_t pick;    ///< -1: a line without one
  bool is_line() const { return sides == 2; }
};

/// The primitives of a retained scene's segment with their points as entered, in arrays shared with
/// the scene. They are unchanged whatever happens to the scene.
class RetainedPolygons {
 public:
  using Primitives = GrowingArray<RetainedPrimitive>::Part;
  using Points = GrowingArray<Point3>::Part;
  using Corners = GrowingArray<std::uint32_t>::Part;

  RetainedPolygons() = default;
  /// `size` primitives from `first` on. corners empty: the points in order.
  RetainedPolygons(Primitives primitives, Points points, Corners corners, std::size_t first,
                   std::size_t size)
      : primitives_(std::move(primitives)),
        points_(std::move(points)),
        corners_(std::move(corners)),
        first_(first),
        size_(size) {}

  std::size_t size() const { return size_; }
  const RetainedPrimitive& primitive(std::size_t i) const {
    assert(i < size_ && first_ + size_ <= primitives_.size);
    return primitives_.elements[static_cast<std::ptrdiff_t>(first_ + i)];
  }
  PointRow points(std::size_t i) const {
    const RetainedPrimitive& of = primitive(i);
    if (corners_.size == 0) return points_.span().subspan(of.first, of.sides);
    return {points_.span(), corners_.span().subspan(of.first, of.sides)};
  }
  /// The addresses of the arrays, for comparison.
  using Place = std::array<const void*, 3>;
  Place place() const {
    return {primitives_.elements.get(), points_.elements.get(), corners_.elements.get()};
  }

 private:
  Primitives primitives_;
  Points points_;
  Corners corners_;
  std::size_t first_ = 0, size_ = 0;
};

}  // namespace displayfile
