#pragma once

#include <cstddef>

#include "displayfile/viewed_scene.h"
#include "programs/bench/embree_rays.h"
#include "programs/bench/timing.h"

namespace displayfile::bench {

/// Ray casting in image space beside Embree's primary rays: the same triangles, the same parallel
/// rays through the pixel centres of a size x size picture, as many threads, what is hit as the
/// result.
struct BesideEmbree {
  Spread rays;         ///< how many times as fast ours are
  Spread building;     ///< the same of making the tree
  double hit;          ///< part of the rays that hit something
  std::size_t others;  ///< pixels at which Embree sees another triangle
};
/// All fills are triangles.
BesideEmbree cast_beside_embree(const ViewedScene& triangles, int size, int threads,
                                EmbreeRays::Quality quality, const Effort& effort);

}  // namespace displayfile::bench
