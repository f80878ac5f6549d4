#pragma once

#include <optional>

#include "tests/bench/command/bench_scene.h"
#include "tests/bench/command/report.h"

namespace displayfile::bench {

/// The effect of viewing's rounding on a scene: of the `pixels` that show a polygon, the number
/// that are `different` in the truth of the display file, from which all methods begin, and in that
/// of the world (interp/truth/world_truth.md); in hard cases of touching polygons in that of the
/// scene as entered (interp/truth/entered_truth.md). `different_and_tied`: those of them where the
/// polygons that the two truths show are no farther from each other than 1e-13 of the view volume's
/// depth; the others are decided by an edge.
///
/// A hard case or a generated scene is entered through a perspective view of the unit cube that is
/// turned about all axes, unless it comes with a view of its own; an input in its own. Nothing for
/// a walk.
std::optional<Json> rounding_of_viewing(const BenchScene& scene);

}  // namespace displayfile::bench
