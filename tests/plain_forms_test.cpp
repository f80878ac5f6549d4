// The plain forms, one file each that reads like the textbook, judge the fast ones: item buffers
// and visible lines are the same.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "displayfile/segments/hidden_surface_check.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/lines/visible_lines.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "interp/visibility/image_space.h"
#include "tests/entered_scenes.h"
#include "tests/slower.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

struct Pair {
  HiddenMethod fast, plain;
};
void PrintTo(const Pair& pair, std::ostream* out) { *out << name_of(pair.plain); }

std::vector<std::int32_t> ids_by(DisplayFile& file, HiddenMethod method, const PictureSize& size,
                                 int threads) {
  const SurfacePlan plan{.method = method, .threads = threads};
  RasterRequest request{.width = size.width, .height = size.height, .surfaces = plan, .ids = true};
  if (!is_image_space(method)) {
    file.set_sorted(hidden_surface_check(file.visible_segments(), plan));
    request.surfaces.method = HiddenMethod::none;
    request.sorted = true;
  }
  return draw_with_software(file, request).ids;
}

/// The visible parts of all sides, drawn or not.
std::vector<VisiblePiece> lines_by(const DisplayFile& file, HiddenMethod method, int threads) {
  const ViewedScene scene(file);
  const std::vector<std::uint8_t> sides(scene.drawn_sides().size(), kDrawn);
  Primitives items = scene.primitives();
  items.visible = sides;
  return visible_lines(items, drawn_lines(items), {.method = method, .threads = threads}).pieces;
}

class PlainForm : public testing::TestWithParam<Pair> {
 protected:
  /// How the scene looks otherwise by the plain form; empty if it looks the same.
  static std::string difference(DisplayFile file, const PictureSize& size, int threads = 1) {
    const auto& [fast, plain] = GetParam();
    if (finds_lines(fast)) {
      return lines_by(file, fast, threads) == lines_by(file, plain, 1) ? "" : "other lines";
    }
    const std::size_t pixels =
        test::different(ids_by(file, fast, size, threads), ids_by(file, plain, size, threads));
    return pixels == 0 ? "" : fmt::format("{} pixels differ", pixels);
  }
};

INSTANTIATE_TEST_SUITE_P(Methods, PlainForm,
                         testing::Values(Pair{HiddenMethod::scan_line,
                                              HiddenMethod::plain_scan_line},
                                         Pair{HiddenMethod::warnock, HiddenMethod::plain_warnock},
                                         Pair{HiddenMethod::bsp, HiddenMethod::plain_bsp},
                                         Pair{HiddenMethod::appel, HiddenMethod::plain_appel}),
                         [](const auto& pair) {
                           std::string name(name_of(pair.param.fast));
                           std::erase(name, '-');
                           return name;
                         });

TEST_P(PlainForm, DrawsRandomScenesAsTheFastOne) {
  constexpr std::uint32_t kScenes = 100 / test::kSlower + 1;
  for (const test::SceneFamily& family : test::scene_families()) {
    for (std::uint32_t seed = 0; seed < kScenes; ++seed) {
      const DisplayFile file = test::scene(family, seed, 2 + static_cast<int>(seed % 11));
      const auto [width, height] = test::kSmallShapes[seed % test::kSmallShapes.size()];
      ASSERT_EQ(difference(file, {width, height}, 1 + static_cast<int>(seed % 3)), "")
          << fmt::format("{}, seed {}, {}x{}", family.name, seed, width, height);
    }
    ASSERT_EQ(difference(test::scene(family, 1000, 150), {100, 75}, 2), "") << family.name;
  }
}

TEST_P(PlainForm, DrawsWhatApplicationsEnterAsTheFastOne) {
  test::expect_right_generated_scenes([](const DisplayFile& file) {
    return difference(file, {61, 47});
  });
}

TEST_P(PlainForm, DrawsTheHardCasesAsTheFastOne) {
  test::expect_right_hard_cases([](const DisplayFile& file) { return difference(file, {64, 64}); });
}

}  // namespace
}  // namespace displayfile
