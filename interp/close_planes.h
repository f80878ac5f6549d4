#pragma once

#include <cstdint>
#include <limits>

#include "hidden/depth_order.h"
#include "hidden/plane.h"

namespace displayfile {

/// True if a lies in b, exactly.
bool are_one_plane(const Plane& a, const Plane& b);

/// Of a polygon and the polygons entered before it that share pixels with it: which is seen where
/// rounded depths cannot tell, by exact arithmetic at the pixels' centres (interp/z_buffer.md). One
/// pair of planes is made ready at a time.
class ClosePlanes {
 public:
  explicit ClosePlanes(const PictureSize& size) : size_(size) {}

  /// The polygon entered last.
  void begin(const Plane& later) {
    later_ = later;
    compared_ = kNone;
  }
  bool is_compared_with(std::uint32_t other) const { return compared_ == other; }
  void compare_with(std::uint32_t other, const Plane& plane);
  /// The same, known whether the two are one plane.
  void compare_with(std::uint32_t other, const Plane& plane, bool coplanar);

  /// Pixels of a row from the first asked for up to `end`: is the later polygon seen on all, or on
  /// none, rather than the one compared with?
  struct Run {
    int end;
    bool later_is_seen;
  };
  /// Of columns first <= i < end, which all show the polygon compared with; at least one of them.
  ///
  /// Along a row the difference of two depths is linear: if it has one sign at both ends of a run,
  /// it has that sign between them; if not, it changes once.
  Run run(int row, int first, int end) const;

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  bool later_is_seen(int column, int row) const {
    return depth_order(later_, other_, PixelCentre(column, row, size_)) >= 0;
  }

  PictureSize size_;
  Plane later_, other_;
  std::uint32_t compared_ = kNone;
  bool coplanar_ = false;
};

}  // namespace displayfile
