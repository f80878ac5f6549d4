// The camera that goes round a retained scene.

#include "displayfile/turntable.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>

#include "clip/error.h"
#include "displayfile/retained_views.h"
#include "interp/draw.h"
#include "tests/retained_truth.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

using namespace test;

TEST(Turntable, AtZeroDegreesNothingHasMoved) {
  Retained retained;
  enter_two_segments(retained.system);
  const DisplayFile& file = retained.system.display_file();
  const Turntable turntable(retained.scene, file, {});
  const auto [view, lights] = turntable.at(0.0);
  EXPECT_EQ(view, retained.system.view());
  RetainedViews views(retained.scene, file, {});
  EXPECT_EQ(entered_text(views.view(view, lights)), entered_text(file));
}

/// The camera goes round the world, but it is the world that seems to turn: as if it had been
/// rotated about the axis by the modelling transformation.
TEST(Turntable, TurnsTheSceneCounterclockwiseSeenFromAbove) {
  const auto enter_turned = [](double degrees, GraphicsSystem& g) {
    g.set_perspective({0.4, 0.7, 4.0});
    g.set_light({0.3, 1.0, 0.7}, 0.2);
    g.rotate_y_3(degrees);
    g.open_segment(1);
    g.polygon_abs_3({{-0.5, -0.5, -0.5}, {0.5, -0.5, -0.5}, {0.5, 0.5, -0.5}, {-0.5, 0.5, -0.5}});
    g.polygon_abs_3({{-0.5, -0.5, 0.5}, {0.5, -0.5, 0.5}, {0.5, 0.5, 0.5}});
    g.polygon_abs_3({{0.5, -0.5, -0.5}, {0.5, -0.5, 0.5}, {0.5, 0.5, 0.5}, {0.5, 0.5, -0.5}});
    g.close_segment();
  };
  Retained retained;
  enter_turned(0.0, retained.system);
  const Turntable turntable(retained.scene, retained.system.display_file(), {});
  RetainedViews views(retained.scene, retained.system.display_file(), {});
  for (const double degrees : {30.0, 90.0, 200.0}) {
    GraphicsSystem turned;
    enter_turned(degrees, turned);
    const auto [view, lights] = turntable.at(degrees);
    const Picture seen = drawn(views.view(view, lights), 64);
    DrawOptions options;
    options.width = options.height = 64;
    options.hidden = HiddenMethod::z_buffer;
    options.with_ids = true;
    const Picture right = draw(turned, options);
    EXPECT_LE(different(seen.ids, right.ids), 2u) << degrees;  // at most on edges
    std::size_t colours = 0;
    for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
      for (int shift = 0; shift < 24; shift += 8) {
        const int a = static_cast<int>(seen.pixels[i] >> shift & 255);
        const int b = static_cast<int>(right.pixels[i] >> shift & 255);
        colours += std::abs(a - b) > 1 ? 1 : 0;
      }
    }
    EXPECT_LE(colours, 40u) << degrees;  // of outlines
  }
}

TEST(Turntable, FitsItsWindowToAllViews) {
  Retained retained;
  enter_two_segments(retained.system);
  const DisplayFile& file = retained.system.display_file();
  Turntable turntable(retained.scene, file, {});
  turntable.fit_window(16);
  for (int k = 0; k < 16; ++k) {
    const ViewVolume volume(turntable.at(360.0 * k / 16).view);
    for (const RetainedScene::Segment& segment : retained.scene.segments()) {
      for (const Point3& p : retained.scene.points(segment)) {
        EXPECT_EQ(volume.outcode(volume.transform(p)), 0u) << k;
      }
    }
  }
}

TEST(Turntable, RefusesSegmentsOfSeveralViews) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  enter_two_segments(g);
  g.set_window(-2, 2, -2, 2);
  g.open_segment(7);
  g.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  g.close_segment();
  EXPECT_THROW(Turntable(retained.scene, g.display_file(), {}), Error);
  g.set_visibility(7, false);
  EXPECT_NO_THROW(Turntable(retained.scene, g.display_file(), {}));
}

}  // namespace
}  // namespace displayfile
