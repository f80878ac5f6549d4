#pragma once

#include <cstdint>
#include <limits>

#include "hidden/exact/depth_comparison.h"
#include "hidden/exact/pixel_centre.h"
#include "hidden/exact/plane.h"

namespace displayfile {

/// A polygon compared with polygons entered before it that share pixels with it: which is seen, by
/// exact arithmetic at the pixels' centres (interp/visibility/close_depths.md). One pair of planes
/// is remembered, the last. This memory stands beside PairOrders, which remembers pairs by the
/// numbers of a scene's fills: the polygons compared here, those over undecided centres and those
/// of the sampled vectors, come one after another and belong to no scene.
class ClosePlanes {
 public:
  explicit ClosePlanes(const PictureSize& size) : size_(size) {}

  /// The polygon entered last.
  void begin(const Plane& later) {
    later_ = later;
    compared_ = kNone;
  }
  bool is_compared_with(std::uint32_t other) const { return compared_ == other; }
  void compare_with(std::uint32_t other, const Plane& plane) {
    compared_ = other;
    comparison_ = DepthComparison(later_, plane);
  }

  /// Whether the polygon entered last is seen at a centre, rather than the one compared with.
  bool later_is_seen(int column, int row) {
    return comparison_.order(PixelCentre(column, row, size_)) >= 0;
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  PictureSize size_;
  Plane later_;
  std::uint32_t compared_ = kNone;
  DepthComparison comparison_;
};

}  // namespace displayfile
