// A new view computed in vectors: vertices viewed many at once are those viewed one by one, and the
// decisions about many triangles are correct by the exact scan conversion.

#include "displayfile/views/triangle_sieve.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "clip/pipeline/clip_pipeline.h"
#include "clip/view/view_volume.h"
#include "hidden/exact/orientation.h"
#include "interp/scan/scan_convert.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

using test::Dice;

View random_view(Dice& dice) {
  View view;
  const auto away = [&] { return dice.part() - 0.5; };
  view.plane_normal = {away(), away(), -1.0};
  view.reference_point = {away(), away(), away()};
  view.projection = dice.one_in(2) ? View::Projection::perspective : View::Projection::parallel;
  view.centre_of_projection = view.reference_point - (2.0 + dice.part()) * view.plane_normal;
  view.direction_of_projection = {away(), away(), 1.0};
  view.front = -1.0 - dice.part();
  view.back = 0.5 + dice.part();
  view.front_clipping = dice.one_in(2);
  view.back_clipping = dice.one_in(2);
  if (dice.one_in(2)) view.viewport = {0.25 * dice.part(), 0.75, 0.0, 0.5 + 0.5 * dice.part()};
  return view;
}

TEST(ViewPoints, AreThoseViewedOneByOne) {
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    Dice dice(seed);
    const ViewVolume volume(random_view(dice));
    const ClipPipeline pipeline(volume);
    std::vector<Point3> world;
    const int n = dice.from(0, 40);
    const double spread = dice.of(std::array{1.0, 3.0, 1e6});
    for (int i = 0; i < n; ++i) {
      const auto coordinate = [&] { return spread * (2.0 * dice.part() - 1.0); };
      world.emplace_back(coordinate(), coordinate(), coordinate());
    }
    std::vector<Point3> device(world.size());
    std::vector<std::uint8_t> outcodes(world.size(), 255);
    view_points(volume, world, device, outcodes);
    for (std::size_t i = 0; i < world.size(); ++i) {
      const PipelineVertex one = pipeline.view(world[i]);
      ASSERT_EQ(outcodes[i], one.outcode) << seed;
      ASSERT_EQ(device[i], one.device) << seed;
    }
  }
}

/// Vertices in a picture, and their computed places.
struct Vertices {
  PictureSize size;
  std::vector<Point3> device;
  std::vector<std::uint8_t> outcodes;
  std::vector<PicturePlace> places;
  double largest_depth = 0.0;

  void find() {
    places.resize(device.size());
    largest_depth = find_places(device, outcodes, size, places);
  }
};

/// Triangles of that extent in pixels, some of their vertices on a grid through the centres.
Vertices scattered(Dice& dice, const PictureSize& size, int triangles, double extent, bool grid) {
  Vertices all{size, {}, {}, {}};
  for (int k = 0; k < triangles; ++k) {
    const double x = dice.part() * size.width, y = dice.part() * size.height;
    for (int corner = 0; corner < 3; ++corner) {
      const auto near = [&](double at, int side) {
        const double pixels = at + extent * (dice.part() - 0.5);
        const double there = grid ? std::round(2.0 * pixels) / 2.0 : pixels;
        return std::min(1.0, std::max(0.0, there / side));
      };
      const bool outside = dice.one_in(20);
      all.outcodes.push_back(outside ? 1 : 0);
      all.device.push_back(
          outside ? Point3(0.0)
                  : Point3(near(x, size.width), near(y, size.height), 2.0 * dice.part() - 1.0));
    }
  }
  all.find();
  return all;
}

TEST(TriangleSieve, PlacesAreOffByNoMoreThanOne) {
  Dice dice(7);
  for (const PictureSize& size : {PictureSize{1, 1}, PictureSize{640, 480}, {65535, 65535}}) {
    const Vertices all = scattered(dice, size, 37, size.width, false);
    double largest = 0.0;
    for (std::size_t i = 0; i < all.device.size(); ++i) {
      if (all.outcodes[i] != 0) {
        EXPECT_EQ(all.places[i].x, PicturePlace::kOutside);
        continue;
      }
      EXPECT_NEAR(all.places[i].x, all.device[i].x * size.width * 0x1p15, 1.0);
      EXPECT_NEAR(all.places[i].y, all.device[i].y * size.height * 0x1p15, 1.0);
      largest = std::max(largest, std::abs(all.device[i].z));
    }
    EXPECT_EQ(all.largest_depth, largest);
  }
}

TEST(TriangleSieve, CentresBetweenAreAllThatThereAre) {
  constexpr std::int32_t kPixel = 1 << PicturePlace::kBits;
  for (const int low :
       {0, 100, kPixel / 2 - 1, kPixel / 2, kPixel / 2 + 1, kPixel, 9 * kPixel / 2}) {
    for (const int more : {0, 1, 2, kPixel / 2, kPixel - 2, kPixel, kPixel + 1, 5 * kPixel}) {
      const CentresBetween between(low, low + more);
      for (int centre = 0; centre < 12; ++centre) {
        const int at = centre * kPixel + kPixel / 2;
        const bool is_between = at >= low - 1 && at <= low + more + 1;
        EXPECT_EQ(is_between, centre >= between.first && centre < between.first + between.count);
      }
    }
  }
}

bool covers_a_centre(const std::array<Point3, 3>& triangle, const PictureSize& size) {
  bool covers = false;
  ScanConverter converter;
  converter.scan_convert(triangle, {size, 0, size.height},
                         [&](int, int first, int end) { covers = covers || first < end; });
  return covers;
}

struct Counts {
  int covering_none = 0, of_these_left = 0, more = 0, all = 0;
};

Counts check(const Vertices& vertices) {
  Counts counts;
  std::vector<std::uint32_t> corners(vertices.device.size());
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = static_cast<std::uint32_t>(i);
  const int n = static_cast<int>(corners.size() / 3);
  const SievedTriangles found =
      sieve_triangles(corners.data(), corners.size() / 3, vertices.places.data());
  const std::uint64_t given = n == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << n) - 1;
  EXPECT_EQ((found.stays | found.needs_more) & ~given, 0u);
  EXPECT_EQ(found.stays & found.needs_more, 0u);
  EXPECT_EQ(found.turned_away & ~found.stays, 0u);
  for (int k = 0; k < n; ++k) {
    const auto first = static_cast<std::size_t>(3 * k);
    const auto is = [&](std::uint64_t bits) { return (bits >> k & 1) != 0; };
    const bool outside = vertices.outcodes[first] != 0 || vertices.outcodes[first + 1] != 0 ||
                         vertices.outcodes[first + 2] != 0;
    if (outside) {
      EXPECT_TRUE(is(found.needs_more));
      continue;
    }
    const std::array triangle{vertices.device[first], vertices.device[first + 1],
                              vertices.device[first + 2]};
    const bool covers = covers_a_centre(triangle, vertices.size);
    const bool left = is(found.stays) || is(found.needs_more);
    EXPECT_TRUE(left || !covers);
    const int turn = orientation(triangle[0], triangle[1], triangle[2]);
    if (is(found.stays)) {
      EXPECT_EQ(turn, is(found.turned_away) ? -1 : 1);
    }
    ++counts.all;
    counts.more += is(found.needs_more) ? 1 : 0;
    counts.covering_none += covers ? 0 : 1;
    counts.of_these_left += !covers && left ? 1 : 0;
  }
  return counts;
}

/// Triangles that stay nearly always cover a centre, and few need more work.
TEST(TriangleSieve, WhatIsLeftOutCoversNoCentre) {
  for (const double extent : {0.3, 1.0, 2.0, 5.0, 40.0, 700.0}) {
    for (const bool grid : {false, true}) {
      SCOPED_TRACE(testing::Message() << extent << (grid ? " on a grid" : ""));
      Counts sum;
      for (std::uint32_t seed = 0; seed < 200; ++seed) {
        Dice dice(seed);
        const PictureSize size{dice.from(1, 900), dice.from(1, 900)};
        const Counts counts = check(scattered(dice, size, dice.from(1, 64), extent, grid));
        sum.covering_none += counts.covering_none;
        sum.of_these_left += counts.of_these_left;
        sum.more += counts.more;
        sum.all += counts.all;
      }
      if (grid || extent > 2.0) continue;
      EXPECT_LT(sum.of_these_left, sum.covering_none / 100);
      EXPECT_LT(sum.more, sum.all / 20);
    }
  }
}

}  // namespace
}  // namespace displayfile
