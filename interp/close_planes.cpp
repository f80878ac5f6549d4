#include "interp/close_planes.h"

namespace displayfile {

void ClosePlanes::compare_with(std::uint32_t other, const Plane& plane) {
  other_ = plane;
  compared_ = other;
  coplanar_ = side_of_plane(later_.p, other_) == 0 && side_of_plane(later_.q, other_) == 0 &&
              side_of_plane(later_.r, other_) == 0;
}

ClosePlanes::Run ClosePlanes::run(int row, int first, int end) const {
  if (coplanar_) return {end, true};
  const bool seen = later_is_seen(first, row);
  if (end - first < 5) return {first + 1, seen};  // as soon asked one by one
  int same = first;
  for (int different = end; different - same > 1;) {
    const int middle = different == end ? end - 1 : same + (different - same) / 2;
    (later_is_seen(middle, row) == seen ? same : different) = middle;
  }
  return {same + 1, seen};
}

}  // namespace displayfile
