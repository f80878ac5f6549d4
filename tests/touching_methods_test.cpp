// Touching polygons, by every method of surfaces: they are coplanar if they were entered so,
// whatever viewing rounds. Judged by the truth from the scene as entered.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/segments/hidden_surface_check.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/views/retained_views.h"
#include "displayfile/views/scene_viewer.h"
#include "interp/draw/draw.h"
#include "interp/draw/world_views.h"
#include "interp/truth/entered_truth.h"
#include "interp/truth/truth.h"
#include "tests/from_environment.h"
#include "tests/from_eyes.h"
#include "tests/ids_by_method.h"
#include "tests/retained_truth.h"
#include "tests/slower.h"
#include "tests/touching_scenes.h"
#include "tests/without_entered.h"

namespace displayfile {
namespace {

using test::FromEyes;

using test::from_environment;
using test::ids_by;
using test::Retained;
using test::Source;
using test::wrong_pixels;

constexpr int kSize = 48;
const test::Ball3 kAboutTheOrigin{Point3(0.0), 3.0};
using Enter = void (*)(Source&, GraphicsSystem&);

/// Enters a scene in several segments or one, in a random view.
void enter_in_view(Source& s, GraphicsSystem& g, Enter enter, bool transformed) {
  test::view_from_anywhere(s, g, kAboutTheOrigin);
  if (s.below(3) == 0) g.set_viewport(0.1, 0.8, 0.2, 0.9);
  if (transformed) test::turn_and_move(s, g);
  g.open_segment(1);
  enter(s, g);
  g.close_segment();
}

/// No pixel is wrong by any method, and the scene touches in most views.
void expect_no_wrong_pixel(Enter enter, bool transformed) {
  const int views = from_environment("DISPLAYFILE_TOUCHING_VIEWS", 24 / test::kSlower);
  std::size_t touching = 0;
  for (int seed = 0; seed < views; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Source s(static_cast<std::uint64_t>(seed));
    Retained retained;
    enter_in_view(s, retained.system, enter, transformed);
    const EnteredTruth truth = entered_truth(retained.scene, retained.system.display_file(), kSize,
                                             kSize, false, std::nullopt);
    touching += truth.touching > 0 ? 1 : 0;
    for (const HiddenMethod method : test::kSurfaceMethods) {
      EXPECT_EQ(wrong_pixels(ids_by(retained.system, method, kSize), truth.picture), 0u)
          << name_of(method);
    }
    EXPECT_EQ(
        wrong_pixels(displayfile::truth(retained.system.display_file(), kSize, kSize, false).ids,
                     truth.picture),
        0u)
        << "truth";
  }
  EXPECT_GT(10 * touching, 9 * static_cast<std::size_t>(views));
}

TEST(TouchingMethods, ARugOnAFloor) {
  expect_no_wrong_pixel(test::enter_rug_on_floor, false);
  expect_no_wrong_pixel(test::enter_rug_on_floor, true);
}
TEST(TouchingMethods, AWindowInARoof) {
  expect_no_wrong_pixel(test::enter_window_in_roof, false);
  expect_no_wrong_pixel(test::enter_window_in_roof, true);
}
TEST(TouchingMethods, BoxesOnAFloor) {
  expect_no_wrong_pixel(test::enter_boxes_on_floor, false);
  expect_no_wrong_pixel(test::enter_boxes_on_floor, true);
}
TEST(TouchingMethods, WindowsFlushInWalls) {
  expect_no_wrong_pixel(test::enter_flush_windows, false);
  expect_no_wrong_pixel(test::enter_flush_windows, true);
}

/// How often sorts cut boxes that stand on a floor in a random view, by a precision.
std::uint64_t cuts_of_boxes(HiddenMethod method, const Precision& precision, int seed) {
  Source s(static_cast<std::uint64_t>(seed));
  GraphicsSystem g;
  enter_in_view(s, g, test::enter_boxes_on_floor, seed % 2 == 1);
  return hidden_surface_check(g.display_file().segment(1).entered(), {},
                              {.method = method, .precision = precision})
      ->counts.cuts;
}

/// Touching polygons are cut no more than with the ROUNDOFF that hides viewing's rounding.
TEST(TouchingMethods, SortsCutNoVerticesThatTouchOff) {
  for (const HiddenMethod method : {HiddenMethod::bsp, HiddenMethod::depth_sort}) {
    std::uint64_t exact = 0, roundoff = 0;
    for (int seed = 0; seed < 60; ++seed) {
      exact += cuts_of_boxes(method, {}, seed);
      roundoff += cuts_of_boxes(method, {.exact = false, .roundoff = 0x1p-40}, seed);
    }
    EXPECT_LE(exact, roundoff + roundoff / 20) << name_of(method);
  }
}

/// Tiles pass through a floor at angles as small as viewing's rounding: half of each is visible, as
/// it was entered.
void expect_tiles_seen(int rows, int columns, int size) {
  Source s(4);
  Retained retained;
  GraphicsSystem& g = retained.system;
  test::view_from_anywhere(s, g, kAboutTheOrigin);
  g.set_hidden_surfaces({.touching = Touching{Touching::Kind::length, 1e-30}});
  g.set_line_style({LineStyle::Kind::none});
  g.open_segment(1);
  g.polygon_abs_3({{-2, 0, -2}, {-2, 0, 2}, {2, 0, 2}, {2, 0, -2}});
  const double x_step = 4.0 / rows, z_step = 4.0 / columns;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double x = -2.0 + row * x_step, z = -2.0 + column * z_step;
      const double x_end = x + 0.9 * x_step, z_end = z + 0.9 * z_step;
      const double up = (s.below(2) == 0 ? 1.0 : -1.0) * 1e-16 * (1.0 + s.below(4));
      g.polygon_abs_3({{x, up, z}, {x, up, z_end}, {x_end, -up, z_end}, {x_end, -up, z}});
    }
  }
  g.close_segment();
  const EnteredTruth truth =
      entered_truth(retained.scene, g.display_file(), size, size, false, std::nullopt);
  for (const HiddenMethod method : {HiddenMethod::bsp, HiddenMethod::depth_sort}) {
    EXPECT_EQ(wrong_pixels(ids_by(g, method, size), truth.picture), 0u) << name_of(method);
  }
}

TEST(TouchingMethods, SortsTellManyPlanesApartThatAreClose) {
  constexpr int kTiles = test::kSlower > 1 ? 12 : 47;
  expect_tiles_seen(kTiles, kTiles, 2 * kTiles);
  // Each is as long as the picture: there are too many pairs to look at.
  if (test::kSlower == 1) expect_tiles_seen(2000, 1, kSize);
}

/// Far away before they are moved, so that world coordinates are off by more than the reach there.
void enter_rug_far_away(GraphicsSystem& g) {
  g.set_view_plane_normal({-1, -2, -2});
  g.set_parallel({1, 2, 2});
  g.set_window(-2, 2, -2, 2);
  g.set_line_style({LineStyle::Kind::none});
  g.translate_3(-1e5, -1e5, -1e5);
  g.rotate_x_3(13.0);
  g.open_segment(1);
  const double low = 1e5 - 1.3, high = 1e5 + 1.2, y = 1e5 + 0.1;
  g.polygon_abs_3({{low, y, low}, {low, y, high}, {high, y, high}, {high, y, low}});
  g.polygon_abs_3(
      {{1e5 - 0.7, y, 1e5 - 0.7}, {1e5 - 0.4, y, 1e5 + 0.7}, {1e5 + 0.9, y, 1e5 + 0.4}});
  g.close_segment();
}

TEST(TouchingMethods, ACuttingPlaneThatCutsNothingChangesNothing) {
  Retained plain, with_plane;
  enter_rug_far_away(plain.system);
  with_plane.system.set_cutting_plane(1, 1, 0, 0, 9);
  enter_rug_far_away(with_plane.system);
  for (const HiddenMethod method : test::kSurfaceMethods) {
    const auto ids = ids_by(plain.system, method, kSize);
    EXPECT_GT(std::ranges::count(ids, 1), 50) << name_of(method);
    EXPECT_EQ(ids_by(with_plane.system, method, kSize), ids) << name_of(method);
  }
}

/// In millimetres, a rug that is above the floor by less than the length within which things touch.
void enter_rug_in_millimetres(GraphicsSystem& g) {
  g.set_view_plane_normal({-1, -2, -2});
  g.set_parallel({1, 2, 2});
  g.set_window(-2, 2, -2, 2);
  g.set_line_style({LineStyle::Kind::none});
  g.set_hidden_surfaces({.touching = Touching{Touching::Kind::length, 0.25}});
  g.scale_3(0.001, 0.001, 0.001);
  g.open_segment(1);
  g.polygon_abs_3({{-1300, 0, -1300}, {-1300, 0, 1200}, {1200, 0, 1200}, {1200, 0, -1300}});
  g.polygon_abs_3({{-700, 0.2, -700}, {-400, 0.2, 700}, {900, 0.2, 400}});
  g.close_segment();
}

/// Polygons cut by cutting planes touch as whole ones do: each pixel shows the same as before, or
/// nothing.
TEST(TouchingMethods, WhatCuttingPlanesLeaveTouches) {
  for (const auto enter : {enter_rug_far_away, enter_rug_in_millimetres}) {
    Retained whole, cut;
    cut.system.set_cutting_plane(1, 1, 0.25, 0, 0.2);
    cut.system.set_cutting_plane(2, 0, 0, 1, 0.5);
    enter(whole.system);
    enter(cut.system);
    for (const HiddenMethod method : test::kSurfaceMethods) {
      const auto of_whole = ids_by(whole.system, method, kSize);
      const auto left = ids_by(cut.system, method, kSize);
      std::size_t shown = 0, others = 0;
      for (std::size_t k = 0; k < left.size(); ++k) {
        shown += left[k] == 1 ? 1 : 0;
        others += left[k] >= 0 && left[k] != of_whole[k] ? 1 : 0;
      }
      EXPECT_GT(shown, 50u) << name_of(method);
      EXPECT_EQ(others, 0u) << name_of(method);
    }
  }
}

/// Touching polygons may be as far apart as polygons are large: then the planes of others are seen
/// at places far from them, at any slope, or edge-on.
TEST(TouchingMethods, WithinLengthsAsLargeAsPolygons) {
  const int views = from_environment("DISPLAYFILE_TOUCHING_VIEWS", 48 / test::kSlower);
  constexpr Enter kScenes[] = {test::enter_boxes_on_floor, test::enter_flush_windows,
                               test::enter_rug_on_floor};
  for (int seed = 0; seed < views; ++seed) {
    Source s(static_cast<std::uint64_t>(seed));
    Retained retained;
    GraphicsSystem& g = retained.system;
    g.set_hidden_surfaces(
        {.touching = Touching{Touching::Kind::length, std::pow(10.0, -3.0 * s.unit())}});
    const bool is_transformed = seed % 4 == 3;
    enter_in_view(s, g, kScenes[seed % 3], is_transformed);
    const EnteredTruth truth =
        entered_truth(retained.scene, g.display_file(), kSize, kSize, false, std::nullopt);
    for (const HiddenMethod method : test::kSurfaceMethods) {
      // A modelling transformation has rounded the vertices before viewing.
      if (is_transformed && method == HiddenMethod::world_ray_cast) continue;
      EXPECT_EQ(wrong_pixels(ids_by(g, method, kSize), truth.picture), 0u)
          << name_of(method) << ", seed " << seed;
    }
  }
}

/// A wall that is no higher than the length lies in its floor's plane, and is seen at its depth.
TEST(TouchingMethods, WallsWithinALengthOfTheFloorHaveItsDepth) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  g.set_parallel({0, 0.1, 2});
  g.set_window(-3, 3, -3, 3);
  g.set_hidden_surfaces({.touching = Touching{Touching::Kind::length, 0.6}});
  g.set_line_style({LineStyle::Kind::none});
  g.open_segment(1);
  g.polygon_abs_3({{-6, 0, -6}, {-6, 0, 6}, {6, 0, 6}, {6, 0, -6}});
  g.polygon_abs_3({{2, 0, -0.2}, {2, 0.63, -0.2}, {-3, 0.63, -3}, {-3, 0, -3}});
  g.polygon_abs_3({{-0.5, 0, -0.6}, {-0.5, 0.5, -0.6}, {2, 0.5, 0.3}, {2, 0, 0.3}});
  g.close_segment();
  const EnteredTruth truth =
      entered_truth(retained.scene, g.display_file(), kSize, kSize, false, std::nullopt);
  for (const HiddenMethod method : test::kSurfaceMethods) {
    EXPECT_EQ(wrong_pixels(ids_by(g, method, kSize), truth.picture), 0u) << name_of(method);
  }
}

/// No polygon lies in the plane of an invisible one, and it does again when that becomes visible.
TEST(TouchingMethods, PlanesAreThoseOfVisibleSegments) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  g.set_hidden_surfaces({.scope = HiddenScope::all});
  g.set_view_plane_normal({-1, -2, -2});
  g.set_parallel({1, 2, 2});
  g.set_window(-2, 2, -2, 2);
  g.set_hidden_surfaces({.touching = Touching{Touching::Kind::length, 0.1}});
  g.set_line_style({LineStyle::Kind::none});
  g.open_segment(1);
  g.polygon_abs_3({{-3, 0.05, -3}, {-3, 0.05, 3}, {3, 0.05, 3}, {3, 0.05, -3}});
  g.close_segment();
  g.open_segment(2);
  g.polygon_abs_3({{-1.3, 0, -1.3}, {-1.3, 0, 1.2}, {1.2, 0, 1.2}, {1.2, 0, -1.3}});
  g.polygon_abs_3({{-0.7, 0.12, -0.7}, {-0.7, 0.12, 0.7}, {0.7, 0.12, 0.7}});
  g.polygon_abs_3({{-0.5, -0.04, -0.7}, {-0.7, -0.04, 0.7}, {0.7, -0.04, 0.7}});
  g.close_segment();
  const DisplayFile& file = g.display_file();
  FromEyes renderer(retained.scene, file);
  std::size_t seen_of_last = 0;
  for (const bool is_visible : {true, false, true}) {
    SCOPED_TRACE(is_visible);
    g.set_visibility(1, is_visible);
    const Picture truth =
        entered_truth(retained.scene, file, kSize, kSize, false, std::nullopt).picture;
    for (const HiddenMethod method : test::kSurfaceMethods) {
      EXPECT_EQ(wrong_pixels(ids_by(g, method, kSize), truth), 0u) << name_of(method);
    }
    const DrawOptions options = test::options_for_ids(kSize, HiddenMethod::z_buffer);
    EXPECT_EQ(wrong_pixels(renderer.draw(g.view(), options).ids, truth), 0u);
    const auto of_last = static_cast<std::size_t>(std::ranges::count(truth.ids, 3));
    EXPECT_NE(of_last, seen_of_last);
    seen_of_last = of_last;
  }
}

/// Two floors are apart by somewhat more than the reach: the lower one, entered later, is hidden,
/// though no vertex is farther from the other's plane than viewing's rounding may move it.
TEST(TouchingMethods, SortsKeepApartWhatIsNearlyInOnePlane) {
  for (int seed = 0; seed < 60; ++seed) {
    Source s(static_cast<std::uint64_t>(seed));
    Retained retained;
    GraphicsSystem& g = retained.system;
    test::view_from_anywhere(s, g, kAboutTheOrigin);
    const double reach = 0x1p-44, below = -2.0 * reach;
    g.set_hidden_surfaces({.touching = Touching{Touching::Kind::length, reach}});
    g.set_line_style({LineStyle::Kind::none});
    g.open_segment(1);
    g.polygon_abs_3({{-2, 0, -2}, {-2, 0, 2}, {2, 0, 2}, {2, 0, -2}});
    g.polygon_abs_3({{-1, below, -1}, {-1, below, 1}, {1, below, 1}, {1, below, -1}});
    g.polygon_abs_3({{0, below, 0}, {0, below, 1.5}, {1, 1, 1.5}, {1, 1, 0}});
    g.close_segment();
    const EnteredTruth truth =
        entered_truth(retained.scene, g.display_file(), kSize, kSize, false, std::nullopt);
    for (const HiddenMethod method : {HiddenMethod::bsp, HiddenMethod::depth_sort}) {
      EXPECT_EQ(wrong_pixels(ids_by(g, method, kSize), truth.picture), 0u)
          << name_of(method) << ", seed " << seed;
    }
  }
}

/// A slope of two triangles, and triangles that pass through it and each other at angles of 1e-14
/// to 1e-6.
void enter_tiny_angles(Source& s, GraphicsSystem& g) {
  const auto between = [&](double least, double most) { return least + (most - least) * s.unit(); };
  const double low = between(-1.0, 1.0), along = between(-1.0, 1.0), across = between(-1.0, 1.0);
  const auto on_slope = [&](double x, double z) {
    return Point3(x, low + along * x + across * z, z);
  };
  const Point3 a = on_slope(-2, -2), b = on_slope(-2, 2), c = on_slope(2, 2), d = on_slope(2, -2);
  g.set_line_style({LineStyle::Kind::none});
  g.polygon_abs_3({a, b, c});
  g.polygon_abs_3({a, c, d});
  for (int k = 0; k < 3; ++k) {
    const double tilt = std::pow(10.0, between(-14.0, -6.0));
    const Point3 off = tilt * Point3(between(-1.0, 1.0), between(-1.0, 1.0), 0.3);
    std::vector<Point3> triangle;
    for (int corner = 0; corner < 3; ++corner) {
      Point3 p = on_slope(between(-1.5, 1.5), between(-1.5, 1.5));
      p.y += off.x * p.x + off.y * p.z + off.z;
      triangle.push_back(p);
    }
    g.polygon_abs_3(triangle);
  }
}

/// Planes meet where they do as entered, however small viewing makes the angle between them, and
/// whether or not closer polygons would touch.
TEST(TouchingMethods, PlanesThatMeetAtTinyAngles) {
  for (int seed = 0; seed < 60 / test::kSlower; ++seed) {
    for (const bool transformed : {false, true}) {
      for (const bool touches : {true, false}) {
        SCOPED_TRACE(fmt::format("seed {}, {} {}", seed, transformed, touches));
        Source s(static_cast<std::uint64_t>(seed));
        Retained retained;
        if (!touches)
          retained.system.set_hidden_surfaces({.touching = Touching{Touching::Kind::off}});
        enter_in_view(s, retained.system, enter_tiny_angles, transformed);
        const EnteredTruth truth = entered_truth(retained.scene, retained.system.display_file(),
                                                 kSize, kSize, false, std::nullopt);
        for (const HiddenMethod method : test::kSurfaceMethods) {
          // A modelling transformation has rounded the vertices before viewing.
          if (transformed && method == HiddenMethod::world_ray_cast) continue;
          EXPECT_EQ(wrong_pixels(ids_by(retained.system, method, kSize), truth.picture), 0u)
              << name_of(method);
        }
      }
    }
  }
}

/// Polygons that coincide exactly are coplanar with touching off too.
TEST(TouchingMethods, WhatCoincidesDoesSoWithTouchingOff) {
  std::ptrdiff_t seen = 0;
  for (int seed = 0; seed < 24 / test::kSlower; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Source s(static_cast<std::uint64_t>(seed));
    Retained retained;
    GraphicsSystem& g = retained.system;
    test::view_from_anywhere(s, g, kAboutTheOrigin);
    g.set_hidden_surfaces({.touching = Touching{Touching::Kind::off}});
    g.set_line_style({LineStyle::Kind::none});
    g.open_segment(1);
    g.polygon_abs_3({{-2, 0.25, -2}, {-2, 0.25, 2}, {2, 0.25, 2}, {2, 0.25, -2}});
    g.polygon_abs_3({{-1, 0.25, -1}, {-1, 0.25, 1}, {1, 0.25, 1}, {1, 0.25, -1}});
    g.close_segment();
    const EnteredTruth truth =
        entered_truth(retained.scene, g.display_file(), kSize, kSize, false, std::nullopt);
    seen += std::ranges::count(truth.picture.ids, 1);
    for (const HiddenMethod method : test::kSurfaceMethods) {
      EXPECT_EQ(wrong_pixels(ids_by(g, method, kSize), truth.picture), 0u) << name_of(method);
    }
  }
  EXPECT_GT(seen, test::kSlower == 1 ? 1000 : 0);
}

/// Planes all of which are parallel to an axis or to the other one: the cut sides of one run along
/// others, and a third plane has no point in common with both.
TEST(TouchingMethods, SortsCutAlongLinesThatOtherPlanesAreParallelTo) {
  constexpr int kPlanes = 16;
  for (int seed = 1; seed <= 6 / test::kSlower; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Source s(static_cast<std::uint64_t>(seed));
    std::vector<std::vector<Point3>> planes;
    for (int k = 0; k < kPlanes; ++k) {
      const double z = static_cast<double>(k) / kPlanes, rise = 1.0 - 2.0 * z;
      planes.push_back({{0, 0, z}, {1, 0, z + rise}, {1, 1, z + rise}, {0, 1, z}});
      planes.push_back({{0, 0, z}, {1, 0, z}, {1, 1, z + rise}, {0, 1, z + rise}});
    }
    for (std::size_t k = planes.size(); k > 1; --k) {
      std::swap(planes[k - 1], planes[static_cast<std::size_t>(s.below(static_cast<int>(k)))]);
    }
    Retained retained;
    GraphicsSystem& g = retained.system;
    g.set_window(0, 1, 0, 1);
    g.set_line_style({LineStyle::Kind::none});
    g.open_segment(1);
    for (const std::vector<Point3>& plane : planes) g.polygon_abs_3(plane);
    g.close_segment();
    const EnteredTruth truth =
        entered_truth(retained.scene, g.display_file(), kSize, kSize, false, std::nullopt);
    for (const HiddenMethod method : test::kSurfaceMethods) {
      EXPECT_EQ(wrong_pixels(ids_by(g, method, kSize), truth.picture), 0u) << name_of(method);
    }
  }
}

/// A triangle thinner than doubles can resolve covers the centres that its left side goes through.
TEST(TouchingMethods, ATriangleThinnerThanDoublesTellCoversCentresOnItsSide) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  g.set_window(0, 1, 0, 1);
  g.set_line_style({LineStyle::Kind::none});
  g.open_segment(1);
  g.polygon_abs_3({{0.984375, 0.734375, 0.5},
                   {0.359375, 0.234375, 0.75},
                   {0.3593750000000002, 0.23437500000000017, 0.75}});
  g.close_segment();
  constexpr int kPixels = 32;
  const EnteredTruth truth =
      entered_truth(retained.scene, g.display_file(), kPixels, kPixels, false, std::nullopt);
  EXPECT_EQ(std::ranges::count(truth.picture.ids, 0), 3);
  for (const HiddenMethod method : test::kSurfaceMethods) {
    EXPECT_EQ(wrong_pixels(ids_by(g, method, kPixels), truth.picture), 0u) << name_of(method);
  }
  EXPECT_EQ(displayfile::truth(g.display_file(), kPixels, kPixels, false).ids, truth.picture.ids);
}

/// A wall seen nearly edge-on, so that it covers one column of the picture, and two windows in it:
/// one lies in front of it by the reach, the other behind. All are triangles. `steep`: depth over
/// width.
void enter_steep_wall(double reach, double steep, GraphicsSystem& g) {
  const double middle = (kSize / 2 + 0.5) / kSize, half = 1.0 / steep;
  const auto rectangle = [&](double low, double high, double off) {
    const double depth = off * std::sqrt(1.0 + steep * steep);
    const Point3 a(middle - half, low, depth - 1.0), b(middle + half, low, depth + 1.0);
    const Point3 c(b.x, high, b.z), d(a.x, high, a.z);
    g.polygon_abs_3({a, b, c});
    g.polygon_abs_3({a, c, d});
  };
  g.set_window(0.0, 1.0, 0.0, 1.0);
  g.set_line_style({LineStyle::Kind::none});
  g.set_hidden_surfaces({.touching = Touching{Touching::Kind::length, reach}});
  g.open_segment(1);
  rectangle(0.1, 0.9, 0.0);
  rectangle(0.2, 0.45, -0.9 * reach);
  rectangle(0.55, 0.8, 0.9 * reach);
  g.close_segment();
}

TEST(TouchingMethods, WindowsInAWallThatIsSeenNearlyEdgeOn) {
  for (const double reach : {0x1p-46, 0x1p-42, 0x1p-40, 0x1p-38, 0x1p-32, 0x1p-26, 0x1p-20}) {
    for (const double steep : {0x1p6, 0x1p10, 0x1p13, 0x1p18}) {
      SCOPED_TRACE(fmt::format("reach {}, steep {}", reach, steep));
      Retained retained;
      enter_steep_wall(reach, steep, retained.system);
      const EnteredTruth truth = entered_truth(retained.scene, retained.system.display_file(),
                                               kSize, kSize, false, std::nullopt);
      EXPECT_EQ(truth.touching, 5u);
      const auto seen = [&](int id) { return std::ranges::count(truth.picture.ids, id); };
      EXPECT_GT(seen(2) + seen(3), 10);
      EXPECT_GT(seen(4) + seen(5), 10);
      for (const HiddenMethod method : test::kSurfaceMethods) {
        EXPECT_EQ(wrong_pixels(ids_by(retained.system, method, kSize), truth.picture), 0u)
            << name_of(method);
      }
    }
  }
}

/// A program of the gallery is right in every pixel, by every method, though `touching` of its
/// polygons lie in the planes of others; and by the display file alone many pixels would be wrong.
void expect_program_right(const std::string& name, std::size_t touching) {
  constexpr int kProgramSize = 160;
  const std::string program = DISPLAYFILE_SOURCE_DIR "/programs/" + name + ".draw";
  Retained retained;
  replay_file(program, retained.system);
  const EnteredTruth truth = entered_truth(retained.scene, retained.system.display_file(),
                                           kProgramSize, kProgramSize, false, std::nullopt);
  EXPECT_GE(truth.touching, touching);
  for (const HiddenMethod method : test::kSurfaceMethods) {
    EXPECT_EQ(wrong_pixels(ids_by(retained.system, method, kProgramSize), truth.picture), 0u)
        << name_of(method);
  }
  const DisplayFile as_viewed = test::without_entered(retained.system.display_file());
  SortedDisplayFile sorted;
  const DisplayFile& in_order = sorted.update(as_viewed, {.method = HiddenMethod::bsp});
  const Picture drawn = draw(
      in_order, {.width = kProgramSize, .height = kProgramSize, .samples = 1, .with_ids = true});
  EXPECT_GT(wrong_pixels(drawn.ids, truth.picture), truth.picture.ids.size() / 50);
}

TEST(TouchingMethods, AFurnishedRoom) { expect_program_right("furnished-room", 90); }
TEST(TouchingMethods, PitchedRoofs) { expect_program_right("pitched-roofs", 60); }

}  // namespace
}  // namespace displayfile
