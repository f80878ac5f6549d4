#pragma once

#include "displayfile/segments/viewed_scene.h"
#include "hidden/disjoint_sets.h"

namespace displayfile {

/// The fills known to be coplanar: for n coplanar fills only n - 1 pairs need be compared.
class CoplanarFills {
 public:
  using Fill = ViewedScene::Fill;

  bool are(Fill a, Fill b) { return same_plane_.size() > 0 && same_plane_.joined(a, b); }

  /// Records that two fills are coplanar; all fills of the scene are less than `end`.
  void add(Fill a, Fill b, Fill end) {
    if (same_plane_.size() == 0) same_plane_.resize(end);
    same_plane_.join(a, b);
  }

  void forget() { same_plane_.resize(0); }

 private:
  DisjointSets same_plane_;  // empty while none is known
};

}  // namespace displayfile
