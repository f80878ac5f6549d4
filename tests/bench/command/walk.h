#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "programs/scenes/scene.h"
#include "tests/bench/command/contenders.h"

namespace displayfile::bench {

/// A walk through a level: the generated city of about n polygons, seen by an eye that goes down
/// its middle and turns, a scene a view. All polygons are the same, bit for bit.
std::vector<Scene> walk(std::size_t n, std::uint64_t seed);
inline constexpr int kViewsOfWalk = 8;

/// Draws all views, each entered in a display file of its own, which is part of the time. The
/// judged picture has those of the views below each other.
std::unique_ptr<Drawing> draw_walk(const std::vector<Scene>& views, const Contender& contender,
                                   const Frame& frame);

/// Appends the picture of a view below the earlier ones.
void append(const Picture& picture, Picture& all);

/// One BSP tree in world coordinates (displayfile/views/retained_views.h), for all views; it is
/// built in draw_anew only. It sees world coordinates, so it claims no exactness in device
/// coordinates. The contender has no `draw`, as it draws no single display file but walks.
Contender retained_tree();
std::unique_ptr<Drawing> draw_walk_with_tree(const std::vector<Scene>& views, const Frame& frame);

}  // namespace displayfile::bench
