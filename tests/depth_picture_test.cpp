// Depths returned by pictures and picks are the truth's, whatever the method, where planes are too
// steep for doubles.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "interp/draw/renderer.h"
#include "interp/truth/entered_truth.h"
#include "interp/truth/truth.h"
#include "programs/scenes/hard_cases.h"
#include "tests/slower.h"
#include "tests/truth_scenes.h"
#include "tests/unit_square.h"

namespace displayfile {
namespace {

constexpr int kSize = 16;

constexpr std::array kMethods{HiddenMethod::z_buffer,    HiddenMethod::scan_line,
                              HiddenMethod::scan_line_z, HiddenMethod::ray_cast,
                              HiddenMethod::warnock,     HiddenMethod::bsp,
                              HiddenMethod::depth_sort,  HiddenMethod::map};

void expect_depths_of_the_truth(const GraphicsSystem& system) {
  const Picture right = truth_as_entered(system.display_file(), kSize, kSize, true);
  const auto is_right = [&](double depth, std::size_t k) {
    return std::abs(depth - right.depth[k]) <= 1e-12 * std::max(1.0, std::abs(right.depth[k]));
  };
  Renderer renderer;
  for (const HiddenMethod method : kMethods) {
    const DrawOptions options{.width = kSize,
                              .height = kSize,
                              .surfaces = {.method = method},
                              .samples = 1,
                              .with_ids = true,
                              .with_depth = true};
    const Picture& drawn = renderer.draw(system, options);
    ASSERT_EQ(drawn.ids, right.ids) << name_of(method);
    for (std::size_t k = 0; k < right.ids.size(); ++k) {
      if (right.ids[k] < 0) continue;
      ASSERT_TRUE(is_right(drawn.depth[k], k))
          << name_of(method) << ": " << drawn.depth[k] << ", truth " << right.depth[k];
    }
  }
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const auto k = static_cast<std::size_t>(y * kSize + x);
      if (right.ids[k] < 0) continue;
      const auto pick =
          renderer.pick(system, x + 0.5, y + 0.5, {.width = kSize, .height = kSize}, 0.0);
      ASSERT_TRUE(pick);
      ASSERT_TRUE(is_right(pick->depth, k)) << pick->depth << ", truth " << right.depth[k];
    }
  }
}

TEST(DepthPicture, NeedlesWhosePlaneDoublesDoNotTell) {
  test::Dice dice(3);
  int covered = 0;
  for (int trial = 0; trial < 300 / test::kSlower; ++trial) {
    GraphicsSystem system = test::unit_square();
    system.open_segment(1);
    for (int needle = 0; needle < 3; ++needle) {
      // Through centres of pixels, with a vertex an ulp or two beside the side between the others.
      const auto centre = [&] { return (2 * dice.from(0, kSize - 1) + 1) / (2.0 * kSize); };
      const Point3 a(centre(), centre(), -dice.part()), b(centre(), centre(), -dice.part());
      Point3 c((a.x + b.x) / 2.0, (a.y + b.y) / 2.0, -dice.part());
      for (int ulps = dice.from(1, 3); ulps > 0; --ulps) c.x = std::nextafter(c.x, 2.0);
      system.polygon_abs_3({a, b, c});
    }
    system.close_segment();
    SCOPED_TRACE(trial);
    ASSERT_NO_FATAL_FAILURE(expect_depths_of_the_truth(system));
    const Picture right = truth(system.display_file(), kSize, kSize, false);
    covered += static_cast<int>(std::ranges::count_if(right.ids, [](auto id) { return id >= 0; }));
  }
  EXPECT_GT(covered, 100 / test::kSlower);
}

TEST(DepthPicture, HardCases) {
  const auto all = hard_cases();
  const std::size_t step = test::kSlower > 1 ? 5 : 1;
  for (std::size_t k = 0; k < all.size(); k += step) {
    const HardCase& family = all[k];
    SCOPED_TRACE(family.name);
    const double hardest = family.severities.back();
    ASSERT_NO_FATAL_FAILURE(
        expect_depths_of_the_truth(entered(family.make(family.size, hardest, 1))));
  }
}

}  // namespace
}  // namespace displayfile
