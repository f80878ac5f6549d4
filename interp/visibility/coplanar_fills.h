#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

#include "interp/visibility/fill_scene.h"

namespace displayfile {

/// The fills that are known to lie in one plane: of n of them n - 1 pairs need be compared to know
/// it of all.
class CoplanarFills {
 public:
  using Fill = FillScene::Fill;

  bool are(Fill a, Fill b) { return !same_plane_.empty() && one_of_plane(a) == one_of_plane(b); }

  /// Of a scene with fills up to `end`.
  void add(Fill a, Fill b, Fill end) {
    if (same_plane_.empty()) {
      same_plane_.resize(end);
      std::iota(same_plane_.begin(), same_plane_.end(), Fill{0});
    }
    same_plane_[one_of_plane(b)] = one_of_plane(a);
  }

 private:
  Fill one_of_plane(Fill fill) {
    while (same_plane_[fill] != fill) {
      same_plane_[fill] = same_plane_[same_plane_[fill]];
      fill = same_plane_[fill];
    }
    return fill;
  }

  std::vector<Fill> same_plane_;  // another fill of its plane, or itself; empty: none is known
};

}  // namespace displayfile
