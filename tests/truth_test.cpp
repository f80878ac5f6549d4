// The oracle against the brute-force check in rationals, and against pictures worked out by hand.

#include "interp/truth/truth.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "interp/truth/depth_ties.h"
#include "tests/brute_force_truth.h"
#include "tests/slower.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

using test::enter;
using test::file_of;
using test::letters_of;
using test::Vertices;

constexpr double kNothing = -std::numeric_limits<double>::infinity();

Vertices rectangle(double x0, double y0, double x1, double y1, double z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

class TruthOfFamily : public testing::TestWithParam<test::SceneFamily> {};

TEST_P(TruthOfFamily, IsThatOfBruteForceInRationals) {
  constexpr std::uint32_t kScenes = 140 / test::kSlower;
  std::size_t covered = 0, tied = 0;
  for (std::uint32_t seed = 0; seed < kScenes; ++seed) {
    const DisplayFile file = test::scene(GetParam(), seed, 2 + static_cast<int>(seed % 6));
    const auto [width, height] = test::kSmallShapes[seed % test::kSmallShapes.size()];
    SCOPED_TRACE(fmt::format("seed {}, {}x{}", seed, width, height));
    test::BruteForceTruth::Ties expected_ties;
    const Picture expected = test::BruteForceTruth(file, width, height).picture(&expected_ties);
    DepthTies ties;
    const Picture found = truth(file, width, height, true, {}, &ties);
    ASSERT_EQ(found.ids, expected.ids);
    for (std::size_t pixel = 0; pixel < expected_ties.size(); ++pixel) {
      for (std::int32_t pick = -1; pick < 8; ++pick) {
        ASSERT_EQ(ties.contains(pixel, pick), std::ranges::count(expected_ties[pixel], pick) > 0)
            << pixel << ' ' << pick;
      }
      tied += expected_ties[pixel].empty() ? 0 : 1;
    }
    ASSERT_EQ(found.depth, expected.depth);
    ASSERT_EQ(truth(file, width, height, false).ids, expected.ids);
    covered += found.ids.size() - static_cast<std::size_t>(std::ranges::count(found.ids, -1));
  }
  EXPECT_GT(covered, 500u / test::kSlower);  // the scenes are not empty
  if (std::string_view(GetParam().name) == "coplanar") {
    EXPECT_GT(tied, 0u);
  }
}

std::string name_of_family(const testing::TestParamInfo<test::SceneFamily>& info) {
  std::string name;
  for (char c : info.param.name) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}
INSTANTIATE_TEST_SUITE_P(All, TruthOfFamily, testing::ValuesIn(test::scene_families()),
                         name_of_family);

TEST(Truth, CentresOnLeftAndTopEdgesBelong) {
  // From centre to centre of a 4 x 4 picture.
  EXPECT_EQ(letters_of(truth(file_of({rectangle(0.125, 0.125, 0.625, 0.625, 0)}), 4, 4, false)),
            "....\n"
            "aa..\n"
            "aa..\n"
            "....\n");
}

TEST(Truth, EvenOddForConcaveAndSelfCrossingPolygons) {
  const Vertices with_hole = {{0, 0, 0},       {1, 0, 0},       {1, 1, 0},       {0, 1, 0},
                              {0, 0, 0},       {0.25, 0.25, 0}, {0.75, 0.25, 0}, {0.75, 0.75, 0},
                              {0.25, 0.75, 0}, {0.25, 0.25, 0}};
  EXPECT_EQ(letters_of(truth(file_of({with_hole}), 4, 4, false)),
            "aaaa\n"
            "a..a\n"
            "a..a\n"
            "aaaa\n");
  const Vertices valley = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 0.25, 0}, {0, 1, 0}};
  EXPECT_EQ(letters_of(truth(file_of({valley}), 8, 4, false)),
            "a......a\n"
            "aa....aa\n"
            "aaa..aaa\n"
            "aaaaaaaa\n");
}

TEST(Truth, TheNearestIsSeenAndOfEqualOnesTheLater) {
  const Vertices left = rectangle(0, 0, 0.75, 1, 0.5), right = rectangle(0.25, 0, 1, 1, 0.5);
  EXPECT_EQ(letters_of(truth(file_of({left, right}), 4, 1, false)), "abbb\n");
  EXPECT_EQ(letters_of(truth(file_of({right, left}), 4, 1, false)), "bbba\n");
  const Vertices nearer = rectangle(0, 0, 0.75, 1, std::nextafter(0.5, 1.0));
  EXPECT_EQ(letters_of(truth(file_of({nearer, right}), 4, 1, false)), "aaab\n");
}

/// Two in one plane, a nearer one before the middle of them, and one behind all.
TEST(Truth, TiesAreWhatOnlyTheOrderOfEntryHides) {
  const Vertices first = rectangle(0, 0, 0.75, 1, 0.5), second = rectangle(0.25, 0, 1, 1, 0.5);
  const Vertices behind = rectangle(0, 0, 1, 1, 0.25);
  const Vertices before = rectangle(0.5, 0, 0.75, 1, std::nextafter(0.5, 1.0));
  DepthTies ties;
  const Picture picture = truth(file_of({behind, first, second, before}), 4, 1, false, {}, &ties);
  EXPECT_EQ(letters_of(picture), "bcdc\n");
  for (std::size_t pixel = 0; pixel < 4; ++pixel) {
    for (std::int32_t pick = -1; pick < 4; ++pick) {
      EXPECT_EQ(ties.contains(pixel, pick), pixel == 1 && pick == 1) << pixel << ' ' << pick;
    }
  }
  // One double, but two depths: no tie.
  const double up = 0.25 + 0x1p-54;
  const Vertices above = {{0, 0, 0.75}, {1, 0, 0.75}, {1, 1, up}, {0, 1, up}};
  DepthTies none;
  truth(file_of({rectangle(0, 0, 1, 1, 0.5), above}), 1, 1, false, {}, &none);
  EXPECT_FALSE(none.contains(0, 0));
}

TEST(Truth, DepthsThatNoDoubleTellsApartAreToldApart) {
  // At the only centre the planes' depths are 1/2 and 1/2 + 2^-55, or 2^-55 less: one double.
  const double up = 0.25 + 0x1p-54;
  const Vertices level = rectangle(0, 0, 1, 1, 0.5);
  const Vertices above = {{0, 0, 0.75}, {1, 0, 0.75}, {1, 1, up}, {0, 1, up}};
  const double down = 0.25 - 0x1p-54;
  const Vertices below = {{0, 0, 0.75}, {1, 0, 0.75}, {1, 1, down}, {0, 1, down}};
  for (const Vertices& other : {above, below}) {
    EXPECT_EQ(truth(file_of({other}), 1, 1, true).depth[0], 0.5);
  }
  EXPECT_EQ(letters_of(truth(file_of({level, above}), 1, 1, false)), "b\n");
  EXPECT_EQ(letters_of(truth(file_of({above, level}), 1, 1, false)), "a\n");
  EXPECT_EQ(letters_of(truth(file_of({level, below}), 1, 1, false)), "a\n");
  EXPECT_EQ(letters_of(truth(file_of({below, level}), 1, 1, false)), "b\n");
}

TEST(Truth, SegmentsCountInOrderOfCreationAndOnlyVisibleOnes) {
  DisplayFile file;
  for (int name : {7, 3}) {
    Segment& segment = file.create(name);
    segment.set_pick(name);
    enter(segment, rectangle(0, 0, 1, 1, 0.5));
  }
  EXPECT_EQ(truth(file, 1, 1, false).ids[0], 3);
  file.segment(3).visible = false;
  EXPECT_EQ(truth(file, 1, 1, false).ids[0], 7);
  file.segment(7).visible = false;
  EXPECT_EQ(truth(file, 1, 1, false).ids[0], -1);
  EXPECT_EQ(truth(file, 1, 1, true).depth[0], kNothing);
}

TEST(Truth, HollowFillsAndLinesCoverNothing) {
  DisplayFile file;
  Segment& segment = file.create(1);
  segment.set_style(LineStyle{});
  segment.set_pick(0);
  enter(segment, rectangle(0, 0, 1, 1, 0.0));
  segment.set_style(FillStyle{FillStyle::Kind::hollow});
  segment.set_pick(1);
  enter(segment, rectangle(0, 0, 1, 1, 1.0));
  segment.enter_line({0, 0.5, 1}, {1, 0.5, 1});
  EXPECT_EQ(letters_of(truth(file, 3, 3, false)), "aaa\naaa\naaa\n");
  segment.set_style(FillStyle{});
  enter(segment, rectangle(0, 0, 1, 1, 0.5));
  EXPECT_EQ(letters_of(truth(file, 3, 3, false)), "bbb\nbbb\nbbb\n");
}

TEST(Truth, TheImageTransformationComesFirst) {
  DisplayFile file = file_of({rectangle(0, 0, 0.5, 0.5, 0)});
  file.segment(1).image.translation = {0.5, 0.25};
  EXPECT_EQ(letters_of(truth(file, 4, 4, false)),
            "....\n"
            "..aa\n"
            "..aa\n"
            "....\n");
}

TEST(Truth, TheSupportPlaneIsTheDepthOfAVertexOffIt) {
  // p is the first, q the farthest, r the farthest from the line pq, first of equals: the second.
  // The last vertex's own z counts for nothing.
  Vertices bent = rectangle(0, 0, 1, 1, 0.25);
  bent[3].z = 1.0;
  EXPECT_EQ(truth(file_of({bent}), 8, 8, true).depth, std::vector<double>(64, 0.25));
}

TEST(Truth, EdgeOnPolygonsCoverNothing) {
  EXPECT_EQ(letters_of(
                truth(file_of({{{0, 0.5, 0}, {1, 0.5, 0}, {1, 0.5, 1}, {0, 0.5, 1}}}), 1, 1, true)),
            ".\n");
}

/// A triangle that is degenerate in doubles is edge-on only if it is so exactly.
TEST(Truth, SliversCoverCentresOnTheirLeftSides) {
  // The differences round to those of three points in line, so that r's value is 0; the triangle
  // has an area, with the centre on its edge.
  EXPECT_EQ(letters_of(truth(file_of({{{0x1p-60, 0, 0}, {1, 1, 0}, {0.25, 0.25, 0}}}), 1, 1, true)),
            "a\n");
  // p, q and r lie in line (y = 3x), although r's value in doubles is 2^-52. The fourth vertex is
  // an ulp beside the line and gives the plane, and the centre (1/8, 3/8) is on it.
  const double p = -0x1.f3f5f786b8a40p-2, q = 0x1.d6c126d0047a0p-3, r = 0x1.812d0ba1fa748p-3;
  const Vertices sliver = {
      {p, 3 * p, 0}, {q, 3 * q, 1}, {r, 3 * r, 0}, {0x1.669e6b68d4351p-4, 0x1.0cf6d08e9f27cp-2, 0}};
  EXPECT_EQ(letters_of(truth(file_of({sliver}), 4, 4, true)), "....\n....\na...\n....\n");
  EXPECT_EQ(letters_of(test::brute_force_truth(file_of({sliver}), 4, 4)),
            "....\n....\na...\n....\n");
}

TEST(Truth, DepthIsRoundedOnceToTheNearestDouble) {
  const auto depth_at_centre = [](double z0, double z1) {  // the mean of the two
    const Vertices v = {{0, 0, z0}, {1, 0, z1}, {1, 1, z1}, {0, 1, z0}};
    return truth(file_of({v}), 1, 1, true).depth[0];
  };
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(depth_at_centre(1.0, std::nextafter(1.0, 2.0)), 1.0);  // a tie, to even
  EXPECT_EQ(depth_at_centre(1.0 + 0x1p-52, 1.0 + 0x1p-51), 1.0 + 0x1p-51);
  EXPECT_EQ(depth_at_centre(0.0, least), 0.0);
  EXPECT_EQ(depth_at_centre(least, 2 * least), 2 * least);
  EXPECT_EQ(depth_at_centre(-least, -2 * least), -2 * least);
  EXPECT_EQ(depth_at_centre(0.0, 3 * least), 2 * least);
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(depth_at_centre(largest, largest), largest);
  EXPECT_EQ(depth_at_centre(-largest, largest), 0.0);
  EXPECT_EQ(depth_at_centre(1e-300, 1e300), 5e299);
}

TEST(Truth, WhatItRefuses) {
  const DisplayFile file = file_of({rectangle(0, 0, 1, 1, 0)});
  for (const auto& [width, height] : {std::pair{0, 1}, {1, 0}, {-1, 5}, {kLargestSide + 1, 1}}) {
    EXPECT_THROW(truth(file, width, height, false), Error);
  }
  EXPECT_EQ(truth(file, kLargestSide, 1, false).ids, std::vector<std::int32_t>(kLargestSide, 0));
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), kNothing, -kNothing}) {
    for (int axis : {0, 1, 2}) {
      Vertices v = rectangle(0, 0, 1, 1, 0);
      v[1][axis] = bad;
      try {
        truth(file_of({v}), 4, 4, false);
        ADD_FAILURE() << "accepted " << bad;
      } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("segment 1"), std::string::npos) << error.what();
      }
    }
  }
}

TEST(Truth, AnEmptyDisplayFileIsBackground) {
  const Picture picture = truth(DisplayFile(), 3, 2, true);
  EXPECT_EQ(picture.ids, std::vector<std::int32_t>(6, -1));
  EXPECT_EQ(picture.depth, std::vector<double>(6, kNothing));
  EXPECT_TRUE(truth(DisplayFile(), 3, 2, false).depth.empty());
}

TEST(Truth, ProgressCountsEveryVisiblePolygon) {
  DisplayFile file = file_of({rectangle(0, 0, 1, 1, 0), rectangle(5, 5, 6, 6, 0)});
  Segment& hidden = file.create(2);
  enter(hidden, rectangle(0, 0, 1, 1, 0));
  hidden.visible = false;
  std::vector<std::size_t> counts;
  truth(file, 2, 2, false, [&](std::size_t done, std::size_t polygons) {
    counts.push_back(done);
    EXPECT_EQ(polygons, 2u);
  });
  EXPECT_EQ(counts, (std::vector<std::size_t>{1, 2}));
}

/// A polygon of very many sides, some across the whole picture.
TEST(Truth, ManySides) {
  test::Dice dice(1);
  Vertices v;
  for (int k = 0; k < 2000; ++k)
    v.push_back(Point3{dice.from(0, 8) / 8.0, dice.from(0, 8) / 8.0, 0.5});
  const DisplayFile file = file_of({v});
  EXPECT_EQ(truth(file, 16, 16, false).ids, test::brute_force_truth(file, 16, 16).ids);
}

}  // namespace
}  // namespace displayfile
