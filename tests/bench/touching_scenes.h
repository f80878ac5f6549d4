#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "programs/scenes/scene.h"

namespace displayfile::bench {

/// Scenes of any size in which nearly every polygon lies in the plane of others, as people draw
/// them: in decimals, seen in perspective along no axis.
struct TouchingScene {
  std::string_view name, what;
  /// About n polygons; the same scene, bit for bit, for the same arguments on every machine.
  Scene (*make)(std::size_t n, std::uint64_t seed);
};

std::span<const TouchingScene> touching_scenes();

}  // namespace displayfile::bench
