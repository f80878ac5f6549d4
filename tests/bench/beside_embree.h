#pragma once

#include <cstddef>

#include "displayfile/viewed_scene.h"
#include "programs/bench/side_by_side.h"

namespace displayfile::bench {

/// A scene's fills, those of more sides cut into triangles: Embree knows nothing else.
ViewedScene scene_of_triangles(const ViewedScene& scene);

/// Ray casting in image space beside Embree's primary rays: the same triangles, the same parallel
/// rays through the pixel centres of a size x size picture, what is hit as the result.
struct BesideEmbree {
  Spread rays;         ///< how many times as fast ours are
  Spread building;     ///< the same of making the scene ready
  double hit;          ///< part of the rays that hit something
  std::size_t others;  ///< pixels at which Embree sees another triangle
};
BesideEmbree cast_beside_embree(const ViewedScene& triangles, int size, int threads, int rounds);

}  // namespace displayfile::bench
