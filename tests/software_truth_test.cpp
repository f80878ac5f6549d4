// The picture of the software z-buffer is the oracle's, to the last pixel: no tolerance.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "interp/software.h"
#include "interp/truth.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

/// Where the two differ first; empty if nowhere.
std::string wrong_pixels(const DisplayFile& file, int width, int height, int threads) {
  const RasterRequest request{
      .width = width, .height = height, .z_buffer = true, .ids = true, .threads = threads};
  const Picture drawn = draw_with_software(file, request);
  const Picture expected = truth(file, width, height, false);
  std::size_t wrong = 0;
  std::string first;
  for (std::size_t k = 0; k < expected.ids.size(); ++k) {
    if (drawn.ids[k] == expected.ids[k]) continue;
    if (wrong++ > 0) continue;
    const auto columns = static_cast<std::size_t>(width);
    first = fmt::format("row {} from the top, column {}: drawn {}, truth {}", k / columns,
                        k % columns, drawn.ids[k], expected.ids[k]);
  }
  return wrong == 0 ? std::string() : fmt::format("{} wrong pixels; {}", wrong, first);
}

TEST(SoftwareTruth, NoWrongPixelsInAnyFamily) {
  constexpr std::uint32_t kScenes = 400;
  for (const test::SceneFamily& family : test::scene_families()) {
    for (std::uint32_t seed = 0; seed < kScenes; ++seed) {
      const DisplayFile file = test::scene(family, seed, 2 + static_cast<int>(seed % 11));
      const auto [width, height] = test::kSmallShapes[seed % test::kSmallShapes.size()];
      ASSERT_EQ(wrong_pixels(file, width, height, 1 + static_cast<int>(seed % 3)), "")
          << fmt::format("{}, seed {}, {}x{}", family.name, seed, width, height);
    }
  }
}

TEST(SoftwareTruth, NoWrongPixelsWithManyPolygons) {
  for (const test::SceneFamily& family : test::scene_families()) {
    const DisplayFile file = test::scene(family, 1000, 300);
    ASSERT_EQ(wrong_pixels(file, 100, 75, 2), "") << family.name;
  }
}

}  // namespace
}  // namespace displayfile
