#include "displayfile/user_routines/plane_uses.h"

#include <algorithm>

namespace displayfile {

namespace {

unsigned bit_of_plane(int n) { return 1u << (n - 1); }

}  // namespace

void PlaneUses::set(int n, const std::array<double, 4>& plane) {
  end(n);
  on_ |= bit_of_plane(n);
  planes_[static_cast<std::size_t>(n - 1)] = {plane, ++set_};
}

void PlaneUses::set_off(int n) {
  end(n);
  on_ &= ~bit_of_plane(n);
}

bool PlaneUses::has_no_effect(int n) const {
  return (on_ & met_ & ~(cuts_ & leaves_) & bit_of_plane(n)) != 0;
}

PlaneWithoutEffect PlaneUses::now(int n, bool is_set) const {
  const InForce& plane = planes_[static_cast<std::size_t>(n - 1)];
  return {n, plane.plane, plane.order, (leaves_ & bit_of_plane(n)) == 0, is_set};
}

void PlaneUses::end(int n) {
  if (has_no_effect(n) && ended_.size() < kMostKept) ended_.push_back(now(n, false));
  for (unsigned* planes : {&met_, &cuts_, &leaves_}) *planes &= ~bit_of_plane(n);
}

std::vector<PlaneWithoutEffect> PlaneUses::without_effect() const {
  std::vector<PlaneWithoutEffect> all = ended_;
  for (int n = 1; n <= CuttingPlanes::kMost; ++n) {
    if (has_no_effect(n)) all.push_back(now(n, true));
  }
  std::ranges::sort(all, {}, &PlaneWithoutEffect::order);
  return all;
}

}  // namespace displayfile
