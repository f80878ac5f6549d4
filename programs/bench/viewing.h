#pragma once

#include <cstddef>
#include <optional>

#include "programs/bench/bench_scene.h"

namespace displayfile::bench {

/// What the rounding of viewing decides of a scene: in how many pixels the truth of the display
/// file, from which all methods begin, is not that of the world (interp/truth/world_truth.md); in
/// hard cases of what touches not that of what was entered (interp/truth/entered_truth.md).
struct ViewingRow {
  BenchScene scene;
  std::size_t pixels = 0;  ///< that show a polygon, in one truth or the other
  std::size_t different = 0;
  /// Those different ones where the polygons that the two truths show are no farther from
  /// each other than kTie: the others are decided by an edge.
  std::size_t ties = 0;

  static constexpr double kTie = 1e-13;  ///< the view volume is 1 deep
};

/// A hard case or a generated scene is entered through a perspective view of the unit cube that is
/// turned about all axes, unless it comes with a view of its own; an input in its own. Nothing for
/// a walk.
std::optional<ViewingRow> rounding_of_viewing(const BenchScene& scene);

}  // namespace displayfile::bench
