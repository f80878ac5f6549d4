#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "programs/scenes/scene.h"

namespace displayfile {

/// Scenes of any size, for benchmarks: ordinary in kind, and hard by their number of polygons.
struct GeneratedScene {
  std::string_view name, what;
  /// About n polygons (no more than n, and at least a half for n from 12); the same scene, bit for
  /// bit, for the same arguments on every machine.
  Scene (*make)(std::size_t n, std::uint64_t seed);
};

std::span<const GeneratedScene> generated_scenes();

/// Throws Error for an unknown name.
const GeneratedScene& generated_scene(std::string_view name);

}  // namespace displayfile
