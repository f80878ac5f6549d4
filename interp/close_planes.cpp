#include "interp/close_planes.h"

namespace displayfile {

bool are_one_plane(const Plane& a, const Plane& b) {
  return side_of_plane(a.p, b) == 0 && side_of_plane(a.q, b) == 0 && side_of_plane(a.r, b) == 0;
}

void ClosePlanes::compare_with(std::uint32_t other, const Plane& plane) {
  compare_with(other, plane, are_one_plane(later_, plane));
}

void ClosePlanes::compare_with(std::uint32_t other, const Plane& plane, bool coplanar) {
  other_ = plane;
  compared_ = other;
  coplanar_ = coplanar;
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
