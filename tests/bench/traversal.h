#pragma once

#include <cstddef>

#include "programs/bench/side_by_side.h"
#include "tests/bench/device_scene.h"

namespace displayfile::bench {

/// What a tree in world coordinates (hidden/sort/world_tree.h) gives: polygons put in order a
/// second, of those entered and of the pieces that the tree made of them.
struct Traversal {
  std::size_t polygons, pieces;
  Spread polygons_a_second, pieces_a_second;  ///< over the eyes
};

/// One tree of the scene, taken as a world, walked far to near for eyes all around and among the
/// polygons, every other one at infinity. One thread.
Traversal traversal(const DeviceScene& scene, int eyes);

}  // namespace displayfile::bench
