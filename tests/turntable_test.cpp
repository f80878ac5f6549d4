// The camera that goes round a retained scene.

#include "displayfile/views/turntable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "clip/base/error.h"
#include "clip/geometry/bounds.h"
#include "clip/view/view_volume.h"
#include "displayfile/views/picture_windows.h"
#include "displayfile/views/retained_views.h"
#include "interp/draw/draw.h"
#include "tests/predicate_inputs.h"
#include "tests/random_views.h"
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
    DrawOptions options{.samples = 1};
    options.width = options.height = 64;
    options.surfaces.method = HiddenMethod::z_buffer;
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

/// The window that all points need, in all views.
Rectangle fitted_by_all_points(const Turntable& turntable, const RetainedScene& scene, int views) {
  const Rectangle window = turntable.at(0.0).view.window;
  const double width = window.x_max - window.x_min, height = window.y_max - window.y_min;
  Bounds seen;
  for (int k = 0; k < views; ++k) {
    const ViewVolume volume(turntable.at(360.0 * k / views).view);
    for (const RetainedScene::Segment& segment : scene.segments()) {
      for (const Point3& point : scene.points(segment)) {
        const HomogeneousPoint p = volume.transform(point);
        if (!(p.w > 0.0)) continue;
        seen.include(
            {window.x_min + width * (p.x / p.w), window.y_min + height * (p.y / p.w), 0.0});
      }
    }
  }
  return fitted_window(seen, width / height);
}

void enter_triangles(Source& s, const Point3& middle, GraphicsSystem& g) {
  g.open_segment(1);
  for (int k = 0; k < 300; ++k) {
    const double reach = s.unit();
    g.polygon_abs_3({middle + reach * any_direction(s), middle + reach * any_direction(s),
                     middle + reach * any_direction(s)});
  }
  g.close_segment();
}

/// Not all points are looked at where there are many views; the window is the same to the last bit,
/// wherever the eye is, about whichever axis the scene turns, and far from the origin.
TEST(Turntable, FitsItsWindowToManyViewsAsIfAllPointsWereLookedAt) {
  Source s(7);
  for (int round = 0; round < 40; ++round) {
    Retained retained;
    GraphicsSystem& g = retained.system;
    const Point3 middle = (round % 4 == 3 ? 1e7 : 3.0) * any_direction(s);
    const Point3 into = any_direction(s);
    g.set_view_reference_point(middle);
    g.set_view_plane_normal(into);
    g.set_view_up(any_direction(s));
    g.set_view_depth(-0.5, 9.0);
    if (round % 2 == 0) {
      g.set_perspective(middle - (round % 8 == 0 ? 0.7 : 3.0) * into);  // among the points, too
    } else {
      g.set_parallel(into + 0.5 * any_direction(s));
    }
    enter_triangles(s, middle, g);
    for (const int views : {3, 500}) {
      Turntable turntable(retained.scene, g.display_file(), {});
      if (round % 3 != 0) turntable.set_axis(any_direction(s));
      const Rectangle expected = fitted_by_all_points(turntable, retained.scene, views);
      turntable.fit_window(views);
      EXPECT_EQ(turntable.at(0.0).view.window, expected) << round << " " << views;
    }
  }
}

TEST(OutermostPoints, AreFew) {
  Source s(3);
  std::vector<Point3> points(3000);
  for (Point3& p : points) p = s.unit() * any_direction(s);
  View view;
  view.set_perspective({0.3, 0.4, 6.0});
  Bounds seen;
  for (int k = 0; k < 64; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / 64;
    for (const Point3& p : points) {
      const double x = p.x * std::cos(turn) + p.z * std::sin(turn);
      const double z = p.z * std::cos(turn) - p.x * std::sin(turn);
      const HomogeneousPoint h = ViewVolume(view).transform({x, p.y, z});
      seen.include({2.0 * h.x / h.w - 1.0, 2.0 * h.y / h.w - 1.0, 0.0});
    }
  }
  const std::vector<Point3> beyond =
      points_beyond({points, Point3(0, 1, 0), Point3(0.0)}, view, seen);
  EXPECT_GT(beyond.size(), 0u);
  EXPECT_LT(beyond.size(), 30u);
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
