// The invariants of the z-buffer besides having no wrong pixel (software_truth_test.cpp).

#include "interp/visibility/z_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "interp/scan/scan_convert.h"
#include "interp/truth/truth.h"
#include "interp/visibility/row_fills.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

using Fill = ViewedScene::Fill;

/// The fills seen, drawn `rows` at a time from the bottom.
std::vector<Fill> drawn(const ViewedScene& scene, const PictureSize& size,
                        std::optional<double> roundoff, int rows) {
  ZBuffer method;
  method.prepare({scene, size, roundoff}, 1);
  const auto width = static_cast<std::size_t>(size.width);
  std::vector<Fill> seen(width * static_cast<std::size_t>(size.height));
  for (int begin = 0; begin < size.height; begin += rows) {
    method.draw_rows(begin, std::min(begin + rows, size.height),
                     [&](int row, int first, std::span<const Fill> fills) {
                       const auto start = static_cast<std::size_t>(row) * width;
                       std::ranges::copy(
                           fills, seen.begin() + static_cast<std::ptrdiff_t>(
                                                     start + static_cast<std::size_t>(first)));
                     });
  }
  return seen;
}

/// By definition: doubles are stored, and compared as SIGNOF does, in the order of entry.
std::vector<Fill> by_doubles(const ViewedScene& scene, const PictureSize& size, double roundoff) {
  const auto width = static_cast<std::size_t>(size.width);
  const std::size_t pixels = width * static_cast<std::size_t>(size.height);
  std::vector<double> z(pixels, -std::numeric_limits<double>::infinity());
  std::vector<Fill> seen(pixels, ViewedScene::kBackground);
  ScanConverter converter;
  for (Fill fill = 1; fill < scene.end(); ++fill) {
    const PixelDepth depth(scene.plane(fill), size.width, size.height);
    converter.scan_convert(
        scene.vertices(fill), {size, 0, size.height}, [&](int row, int first, int end) {
          for (int i = first; i < end; ++i) {
            const auto at = static_cast<std::size_t>(row) * width + static_cast<std::size_t>(i);
            const double own = depth.at(depth.row(row), i);
            if (own - z[at] < -roundoff) continue;
            z[at] = own;
            seen[at] = fill;
          }
        });
  }
  return seen;
}

/// Sheets all over the picture that pass through each other, some of them not convex, some copies
/// of others, so that most lie behind most.
DisplayFile sheets(std::uint32_t seed, int count) {
  test::Dice dice(seed);
  DisplayFile file;
  Segment& segment = file.create(1);
  segment.set_style(LineStyle{LineStyle::Kind::none});
  std::vector<test::Vertices> entered;
  for (int k = 0; k < count; ++k) {
    segment.set_pick(k);
    if (!entered.empty() && dice.one_in(5)) {
      entered.push_back(entered[static_cast<std::size_t>(dice.from(0, k - 1))]);
      if (dice.one_in(2)) {
        for (Point3& p : entered.back()) p.z = std::nextafter(p.z, 2.0);
      }
    } else {
      const double z = dice.part(), dz_dx = dice.part() - 0.5, dz_dy = dice.one_in(3) ? 0.0 : 0.25;
      const auto at = [&](double x, double y) { return Point3{x, y, z + dz_dx * x + dz_dy * y}; };
      const double left = 0.2 * dice.part(), right = 1.0 - 0.2 * dice.part();
      test::Vertices sheet{at(left, 0.0), at(right, -0.1), at(right, 1.0), at(left, 1.0)};
      if (dice.one_in(4)) sheet.insert(sheet.begin() + 2, at(0.5 * (left + right), 0.4));
      entered.push_back(sheet);
    }
    test::enter(segment, entered.back());
  }
  return file;
}

void expect_truth(const DisplayFile& file, const PictureSize& size) {
  const RasterRequest request{.width = size.width,
                              .height = size.height,
                              .surfaces = {.method = HiddenMethod::z_buffer},
                              .ids = true};
  ASSERT_EQ(draw_with_software(file, request).ids, truth(file, size.width, size.height, false).ids);
}

TEST(ZBuffer, WhatLiesBehindAWholeTileIsTheTruths) {
  constexpr PictureSize kSize{230, 75};
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const DisplayFile file = sheets(seed, 3 + static_cast<int>(seed));
    ASSERT_NO_FATAL_FAILURE(expect_truth(file, kSize)) << seed;
  }
}

/// Triangles turned away are drawn after the others; where depths tie, the one entered later is
/// visible nevertheless.
TEST(ZBuffer, TrianglesThatTieAreSeenByTheOrderOfEntryWhicheverWayTheyTurn) {
  constexpr PictureSize kSize{90, 70};
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    test::Dice dice(seed);
    DisplayFile file;
    Segment& segment = file.create(1);
    segment.set_style(LineStyle{LineStyle::Kind::none});
    for (int k = 0; k < 60; ++k) {
      segment.set_pick(k);
      const int plane = dice.from(0, 2);  // of three, which cross
      const auto corner = [&] {
        const double x = dice.from(0, 8) / 8.0, y = dice.from(0, 8) / 8.0;
        return Point3{x, y, plane == 0 ? 0.5 : plane == 1 ? 0.25 + 0.5 * x : 0.75 - 0.5 * y};
      };
      test::enter(segment, test::Vertices{corner(), corner(), corner()});
    }
    ASSERT_NO_FATAL_FAILURE(expect_truth(file, kSize)) << seed;
  }
}

TEST(ZBuffer, TheSameInWhateverRowsItIsDrawn) {
  constexpr PictureSize kSize{150, 50};
  const DisplayFile file = sheets(3, 30);
  const ViewedScene scene(file);
  for (const std::optional<double> roundoff : {std::optional<double>(), std::optional(1e-3)}) {
    const auto whole = drawn(scene, kSize, roundoff, kSize.height);
    for (const int rows : {1, 7, 16, 40}) EXPECT_EQ(drawn(scene, kSize, roundoff, rows), whole);
  }
}

TEST(ZBuffer, WithRoundoffDoublesAreComparedInTheOrderOfEntry) {
  constexpr PictureSize kSize{150, 41};
  for (const double roundoff : {0.0, 1e-15, 1e-9, 1e-5, 1e-2, 0.3}) {
    for (const test::SceneFamily& family : test::scene_families()) {
      const DisplayFile file = test::scene(family, 8, 60);
      const ViewedScene scene(file);
      ASSERT_EQ(drawn(scene, kSize, roundoff, kSize.height), by_doubles(scene, kSize, roundoff))
          << family.name << ", roundoff " << roundoff;
    }
    const DisplayFile file = sheets(8, 60);
    const ViewedScene scene(file);
    ASSERT_EQ(drawn(scene, kSize, roundoff, kSize.height), by_doubles(scene, kSize, roundoff))
        << "sheets, roundoff " << roundoff;
  }
}

/// A side that is level does not rise or fall, wherever the polygon begins.
TEST(ZBuffer, ARectangleIsConvexFromWhicheverVertexItBegins) {
  test::Vertices rectangle{{0.1, 0.2, 0}, {0.9, 0.2, 0}, {0.9, 0.7, 0}, {0.1, 0.7, 0}};
  test::Vertices notched = rectangle;
  notched.insert(notched.begin() + 1, {0.5, 0.4, 0});
  for (int k = 0; k < 5; ++k) {
    EXPECT_EQ(turn_if_convex(rectangle), 1);
    EXPECT_EQ(turn_if_convex(test::Vertices(rectangle.rbegin(), rectangle.rend())), -1);
    EXPECT_EQ(turn_if_convex(notched), 0);
    std::rotate(rectangle.begin(), rectangle.begin() + 1, rectangle.end());
    std::rotate(notched.begin(), notched.begin() + 1, notched.end());
  }
}

/// Twice around, each time turning the same way.
TEST(ZBuffer, AStarIsNotConvex) {
  test::Vertices star;
  for (int k = 0; k < 5; ++k) star.push_back({std::cos(k * 2.5), std::sin(k * 2.5), 0});
  EXPECT_EQ(turn_if_convex(star), 0);
}

}  // namespace
}  // namespace displayfile
