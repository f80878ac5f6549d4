#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "displayfile/graphics_system.h"
#include "displayfile/segments/display_file.h"
#include "programs/scenes/generated_scenes.h"
#include "programs/scenes/hard_cases.h"
#include "tests/slower.h"

// Scenes as applications enter them, small enough for a truth by brute force.

namespace displayfile::test {

/// From the front, or in perspective from aside.
inline DisplayFile viewed(const Scene& scene, bool from_aside) {
  GraphicsSystem system;
  if (from_aside) system.set_perspective({1.0, 0.8, 4.0});
  enter(scene, system);
  return system.display_file();
}

/// Expects of every generated scene that `wrong(display file)` is nothing.
template <class Wrong>
void expect_right_generated_scenes(const Wrong& wrong) {
  for (const GeneratedScene& scene : generated_scenes()) {
    for (const std::uint64_t seed : {1u, 2u}) {
      SCOPED_TRACE(std::string(scene.name) + ", seed " + std::to_string(seed));
      EXPECT_EQ(wrong(viewed(scene.make(40, seed), seed == 2)), "");
    }
  }
}

/// The same of every hard case at each of its severities, or of a share of them.
template <class Wrong>
void expect_right_hard_cases(const Wrong& wrong) {
  Share share;
  for (const HardCase& hard : hard_cases()) {
    for (const double severity : hard.severities) {
      if (!share.takes_next()) continue;
      SCOPED_TRACE(std::string(hard.name) + " " + std::to_string(severity));
      const std::size_t n = std::min<std::size_t>(hard.size, 24);
      EXPECT_EQ(wrong(viewed(hard.make(n, severity, 1), false)), "");
    }
  }
}

}  // namespace displayfile::test
