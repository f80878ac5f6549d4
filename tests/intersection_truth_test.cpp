// Intersection lines against their truth (tests/intersection_truth.h): of scenes as applications
// enter them, and of small scenes in which everything touches everything.

#include "tests/intersection_truth.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/entered_scenes.h"
#include "tests/from_environment.h"
#include "tests/line_truth.h"
#include "tests/slower.h"
#include "tests/sort_scenes.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

TEST(IntersectionTruth, OfGeneratedScenes) {
  test::expect_right_generated_scenes(
      [](const DisplayFile& file) { return test::wrong_intersections(file); });
}

TEST(IntersectionTruth, OfHardCases) {
  test::expect_right_hard_cases(
      [](const DisplayFile& file) { return test::wrong_intersections(file); });
}

/// DISPLAYFILE_INTERSECTION_SCENES sets the number of each kind.
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
