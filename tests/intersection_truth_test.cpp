// Intersection lines against their truth (tests/intersection_truth.h): of what applications enter,
// and of small scenes in which everything touches everything.

#include "tests/intersection_truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "programs/scenes/generated_scenes.h"
#include "programs/scenes/hard_cases.h"
#include "tests/from_environment.h"
#include "tests/line_truth.h"
#include "tests/slower.h"
#include "tests/sort_scenes.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

DisplayFile viewed(const Scene& scene, bool from_aside) {
  GraphicsSystem system;
  if (from_aside) system.set_perspective({1.0, 0.8, 4.0});
  enter(scene, system);
  return system.display_file();
}

TEST(IntersectionTruth, OfGeneratedScenes) {
  for (const GeneratedScene& scene : generated_scenes()) {
    for (const std::uint64_t seed : {1u, 2u}) {
      SCOPED_TRACE(std::string(scene.name) + ", seed " + std::to_string(seed));
      EXPECT_EQ(test::wrong_intersections(viewed(scene.make(40, seed), seed == 2)), "");
    }
  }
}

TEST(IntersectionTruth, OfHardCases) {
  for (const HardCase& hard : hard_cases()) {
    for (const double severity : hard.severities) {
      SCOPED_TRACE(std::string(hard.name) + " " + std::to_string(severity));
      const std::size_t n = std::min<std::size_t>(hard.size, 24);
      EXPECT_EQ(test::wrong_intersections(viewed(hard.make(n, severity, 1), false)), "");
    }
  }
}

/// DISPLAYFILE_INTERSECTION_SCENES sets how many of each kind.
std::uint32_t scenes_of_each(std::uint32_t usual) {
  return static_cast<std::uint32_t>(
             test::from_environment("DISPLAYFILE_INTERSECTION_SCENES", static_cast<int>(usual))) /
         test::kSlower;
}

TEST(IntersectionTruth, OfRandomDegenerateScenes) {
  for (const test::SceneFamily& family : test::scene_families()) {
    for (std::uint32_t seed = 0; seed < scenes_of_each(120); ++seed) {
      SCOPED_TRACE(family.name + ", seed " + std::to_string(seed));
      const DisplayFile file = test::scene(family, seed, 8);
      ASSERT_EQ(test::wrong_intersections(file, 1), "");
    }
  }
}

TEST(IntersectionTruth, OfRandomScenesOfSorts) {
  for (const test::SortFamily& family : test::sort_families()) {
    for (std::uint32_t seed = 0; seed < scenes_of_each(100); ++seed) {
      SCOPED_TRACE(family.name + ", seed " + std::to_string(seed));
      test::Source source(seed);
      ASSERT_EQ(test::wrong_intersections(test::entered(family.make(source)), 1), "");
    }
  }
}

}  // namespace
}  // namespace displayfile
