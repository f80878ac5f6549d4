// The picture of every image-space method is the oracle's, to the last pixel: no tolerance.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "clip/geometry/unit.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "interp/truth/truth.h"
#include "interp/visibility/image_space.h"
#include "tests/slower.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

/// Where the two differ first; empty if nowhere.
std::string wrong_pixels(const DisplayFile& file, int width, int height, int threads,
                         HiddenMethod method = HiddenMethod::z_buffer) {
  const RasterRequest request{.width = width,
                              .height = height,
                              .surfaces = {.method = method, .threads = threads},
                              .ids = true};
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

class EveryMethod : public testing::TestWithParam<ImageSpaceEntry> {
 protected:
  static std::string wrong(const DisplayFile& file, int width, int height, int threads) {
    return wrong_pixels(file, width, height, threads, GetParam().method);
  }
};

INSTANTIATE_TEST_SUITE_P(ImageSpace, EveryMethod,
                         testing::ValuesIn(image_space_methods().begin(),
                                           image_space_methods().end()),
                         [](const auto& entry) {
                           std::string name(name_of(entry.param.method));
                           std::erase(name, '-');
                           return name;
                         });

TEST_P(EveryMethod, NoWrongPixelsInAnyFamily) {
  constexpr std::uint32_t kScenes = 400 / test::kSlower;
  for (const test::SceneFamily& family : test::scene_families()) {
    for (std::uint32_t seed = 0; seed < kScenes; ++seed) {
      const DisplayFile file = test::scene(family, seed, 2 + static_cast<int>(seed % 11));
      const auto [width, height] = test::kSmallShapes[seed % test::kSmallShapes.size()];
      ASSERT_EQ(wrong(file, width, height, 1 + static_cast<int>(seed % 3)), "")
          << fmt::format("{}, seed {}, {}x{}", family.name, seed, width, height);
    }
  }
}

TEST_P(EveryMethod, NoWrongPixelsWithManyPolygons) {
  for (const test::SceneFamily& family : test::scene_families()) {
    const DisplayFile file = test::scene(family, 1000, 300);
    ASSERT_EQ(wrong(file, 100, 75, 2), "") << family.name;
  }
}

/// Values computed for the first pixel of a span, or for the first row of a polygon, are carried
/// over thousands.
TEST_P(EveryMethod, NoWrongPixelsFarFromWhereASpanBegins) {
  constexpr std::uint32_t kScenes = 4 / test::kSlower + 1;
  for (const test::SceneFamily& family : test::scene_families()) {
    for (std::uint32_t seed = 0; seed < kScenes; ++seed) {
      const DisplayFile file = test::scene(family, 500 + seed, 4);
      ASSERT_EQ(wrong(file, 3001, 2, 1), "") << family.name << ", seed " << seed;
      ASSERT_EQ(wrong(file, 2, 3001, 1), "") << family.name << ", seed " << seed;
    }
  }
}

/// Depths of all sizes in one scene, some beyond the largest float.
TEST_P(EveryMethod, NoWrongPixelsWhereDepthsExceedFloats) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const auto unit = [&] { return static_cast<double>(random() >> 8) * 0x1p-24; };
    const int powers = seed % 2 == 0 ? 101 : 9, middle = seed % 2 == 0 ? 0 : 39;
    DisplayFile file;
    Segment& segment = file.create(1);
    for (int i = 0; i < 20; ++i) {
      segment.set_pick(i);
      std::vector<Point3> triangle;
      for (int k = 0; k < 3; ++k) {
        const int power = middle - powers / 2 + static_cast<int>(random() % 1000) % powers;
        const double x = unit(), y = unit();
        triangle.emplace_back(x, y, (2.0 * unit() - 1.0) * std::pow(10.0, power));
      }
      test::enter(segment, triangle);
    }
    ASSERT_EQ(wrong(file, 32, 32, 1), "") << "seed " << seed;
  }
}

/// The differences round to those of three points in line: by the definition the triangle is
/// edge-on, although it has an area and the centre is on its edge.
TEST(SoftwareTruth, EdgeOnIsDecidedInDoublesAsTheDefinitionSays) {
  DisplayFile file;
  Segment& segment = file.create(1);
  segment.set_pick(0);
  test::enter(segment, {{0x1p-60, 0, 0}, {1, 1, 0}, {0.25, 0.25, 0}});
  EXPECT_EQ(wrong_pixels(file, 1, 1, 1), "");
}

/// r's value in doubles is 2^-52, but the three vertices of the support plane lie in line (y = 3x):
/// there is no plane, and the polygon covers nothing, although its edges enclose (1/8, 3/8).
TEST(SoftwareTruth, NoPlaneWhereExactlyInLine) {
  const double p = -0x1.f3f5f786b8a40p-2, q = 0x1.d6c126d0047a0p-3, r = 0x1.812d0ba1fa748p-3;
  DisplayFile file;
  Segment& segment = file.create(1);
  segment.set_pick(0);
  test::enter(segment, {{p, 3 * p, 0},
                        {q, 3 * q, 1},
                        {r, 3 * r, 0},
                        {0x1.669e6b68d4351p-4, 0x1.0cf6d08e9f27cp-2, 0}});
  EXPECT_EQ(wrong_pixels(file, 4, 4, 1), "");
}

}  // namespace
}  // namespace displayfile
