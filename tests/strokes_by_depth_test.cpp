// hidden/lines/strokes_by_depth.h against rationals, pair by pair.

#include "hidden/lines/strokes_by_depth.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "tests/rational_points.h"

namespace displayfile {
namespace {

using test::Q;
using test::QPoint;

constexpr StrokePicture kPicture{{256.0, 256.0}, 1e-9};

QPoint exactly(const Point3& p) { return {Q(p.x), Q(p.y), Q(p.z)}; }

/// The crossing of two axes, as fractions of their lengths, and the depth by which the second is
/// nearer.
struct JudgedCrossing {
  Q at_a, at_b, nearer;
};

std::optional<JudgedCrossing> judged(const DeepStroke& one, const DeepStroke& other) {
  const QPoint a = exactly(one.from), b = exactly(one.to);
  const QPoint c = exactly(other.from), d = exactly(other.to);
  const QPoint u = b - a, v = d - c, w = c - a;
  const Q turn = u.x * v.y - u.y * v.x;
  if (turn == 0) return std::nullopt;
  const Q s = (w.x * v.y - w.y * v.x) / turn, t = (w.x * u.y - w.y * u.x) / turn;
  if (s < 0 || s > 1 || t < 0 || t > 1) return std::nullopt;
  return JudgedCrossing{s, t, Q(c.z + t * v.z) - Q(a.z + s * u.z)};
}

/// The places in the order of the parts of a stroke that have the point at that fraction.
std::vector<std::size_t> places_of(const std::vector<PartByDepth>& parts, std::uint32_t stroke,
                                   const Q& at) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k].stroke == stroke && Q(parts[k].from) <= at && at <= Q(parts[k].to)) {
      places.push_back(k);
    }
  }
  return places;
}

/// The stroke drawn last at the crossing of two must be the nearer one.
void expect_nearer_last(const std::vector<DeepStroke>& strokes,
                        const std::vector<PartByDepth>& parts) {
  const Q apart(kPicture.apart);
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < strokes.size(); ++j) {
      const auto crossing = judged(strokes[i], strokes[j]);
      if (!crossing) continue;
      const bool is_tie = abs(crossing->nearer) <= apart;
      const bool second = is_tie ? strokes[j].entry >= strokes[i].entry : crossing->nearer > 0;
      if (is_tie && strokes[i].look == strokes[j].look) continue;
      const auto of_i = places_of(parts, i, crossing->at_a);
      const auto of_j = places_of(parts, j, crossing->at_b);
      ASSERT_FALSE(of_i.empty() || of_j.empty()) << i << " " << j;
      const bool j_is_last = of_j.back() > of_i.back();
      ASSERT_EQ(j_is_last, second) << i << " and " << j << " of " << strokes.size();
    }
  }
}

/// Every stroke is drawn from end to end.
void expect_whole(const std::vector<DeepStroke>& strokes, std::vector<PartByDepth> parts) {
  std::ranges::sort(parts, [](const PartByDepth& a, const PartByDepth& b) {
    return std::pair(a.stroke, a.from) < std::pair(b.stroke, b.from);
  });
  std::size_t k = 0;
  for (std::uint32_t s = 0; s < strokes.size(); ++s) {
    double to = 0.0;
    for (; k < parts.size() && parts[k].stroke == s; ++k) {
      ASSERT_LE(parts[k].from, to);
      ASSERT_EQ(parts[k].cuts.at_start, parts[k].from > 0.0);
      ASSERT_EQ(parts[k].cuts.at_end, parts[k].to < 1.0);
      to = parts[k].to;
    }
    ASSERT_EQ(to, 1.0);
  }
  ASSERT_EQ(k, parts.size());
}

class RandomStrokes {
 public:
  explicit RandomStrokes(std::uint64_t seed) : random_(seed) {}

  /// On a coarse grid many meet, end on each other, and lie along each other.
  std::vector<DeepStroke> strokes(std::size_t n, int grid, double longest, std::uint32_t looks) {
    std::vector<DeepStroke> all;
    for (std::uint32_t k = 0; k < n; ++k) {
      const Point3 from = point(grid);
      Point3 to = point(grid);
      if (longest < 1.0) to = from + longest * (to - Point3(0.5));
      all.push_back({from, to, 1.0 + static_cast<double>(random_() % 3), k % looks, k});
    }
    return all;
  }

 private:
  double coordinate(int grid) {
    const double u = static_cast<double>(random_() >> 11) * 0x1p-53;
    return grid == 0 ? u : std::floor(u * grid) / grid;
  }
  Point3 point(int grid) { return {coordinate(grid), coordinate(grid), coordinate(grid)}; }
  std::mt19937_64 random_;
};

TEST(StrokesByDepth, AreAsInRationals) {
  RandomStrokes random(11);
  for (int round = 0; round < 60; ++round) {
    const int grid = round % 3 == 0 ? 0 : round % 3 == 1 ? 4 : 16;
    for (const std::size_t n : {2u, 3u, 5u, 12u, 30u}) {
      const auto strokes = random.strokes(n, grid, 1.0, 3);
      const auto parts = strokes_by_depth(strokes, kPicture, 0.0, 1);
      expect_whole(strokes, parts);
      if (grid == 0) expect_nearer_last(strokes, parts);
      if (HasFatalFailure()) return;
    }
  }
}

/// Coarse points: crossings in ends, ties, and lines through one point.
TEST(StrokesByDepth, PairsOnAGridAreAsInRationals) {
  RandomStrokes random(12);
  for (int round = 0; round < 3000; ++round) {
    const auto strokes = random.strokes(2, 3 + round % 4, 1.0, 2);
    expect_nearer_last(strokes, strokes_by_depth(strokes, kPicture, 0.0, 1));
    if (HasFatalFailure()) return;
  }
}

DeepStroke stroke(const Point3& from, const Point3& to, std::uint32_t entry, double width = 4.0) {
  return {from, to, width, entry, entry};
}

TEST(StrokesByDepth, TheNearerOneOfACrossIsLast) {
  const std::vector<DeepStroke> strokes{stroke({0.5, 0.1, 0.75}, {0.5, 0.9, 0.75}, 0),
                                        stroke({0.1, 0.5, 0.25}, {0.9, 0.5, 0.25}, 1)};
  const auto parts = strokes_by_depth(strokes, kPicture, 0.0, 1);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].stroke, 1u);
  EXPECT_EQ(parts[1].stroke, 0u);
}

TEST(StrokesByDepth, LinesThatMeetAreInOrderOfEntryAndLeaveNoGap) {
  std::vector<DeepStroke> strokes{stroke({0.5, 0.1, 0.5}, {0.5, 0.9, 0.5}, 0),
                                  stroke({0.1, 0.5, 0.25}, {0.9, 0.5, 0.75}, 1)};
  strokes[1].from.z += 1e-12;  // less than the distance that counts as apart
  for (const double halo : {0.0, 8.0}) {
    const auto parts = strokes_by_depth(strokes, kPicture, halo, 1);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].stroke, 0u);
    EXPECT_EQ(parts[1].stroke, 1u);
  }
  strokes[0].from.z = strokes[0].to.z = 0.5 + 1e-6;
  EXPECT_EQ(strokes_by_depth(strokes, kPicture, 0.0, 1).back().stroke, 0u);
  EXPECT_EQ(strokes_by_depth(strokes, kPicture, 8.0, 1).size(), 3u);
}

/// Three sticks, each over the next.
std::vector<DeepStroke> three_sticks(double width) {
  std::vector<DeepStroke> strokes;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / 3.0;
    const Point2 along(std::cos(turn), std::sin(turn)), out(along.y, -along.x);
    const Point2 middle = Point2(0.5) + 0.1 * out;
    strokes.push_back(stroke({middle - 0.4 * along, 0.25}, {middle + 0.4 * along, 0.75}, k, width));
  }
  return strokes;
}

TEST(StrokesByDepth, ACircleIsCutBetweenItsCrossings) {
  const std::vector<DeepStroke> strokes = three_sticks(4.0);
  const auto parts = strokes_by_depth(strokes, kPicture, 0.0, 1);
  EXPECT_GT(parts.size(), 3u);
  EXPECT_LE(parts.size(), 6u);
  expect_whole(strokes, parts);
  expect_nearer_last(strokes, parts);
}

/// So wide that the overlap of two of them reaches over the next crossing.
TEST(StrokesByDepth, ACircleOfWideStrokesIsCutToo) {
  std::vector<DeepStroke> sticks = three_sticks(60.0);
  for (const std::array<std::size_t, 3>& order : {std::array<std::size_t, 3>{0, 1, 2},
                                                  {0, 2, 1},
                                                  {1, 0, 2},
                                                  {1, 2, 0},
                                                  {2, 0, 1},
                                                  {2, 1, 0}}) {
    for (const std::size_t turned : {0u, 1u, 2u}) {
      std::vector<DeepStroke> strokes;
      for (const std::size_t k : order) strokes.push_back(sticks[k]);
      std::swap(strokes[turned].from, strokes[turned].to);
      const auto parts = strokes_by_depth(strokes, kPicture, 0.0, 1);
      expect_whole(strokes, parts);
      expect_nearer_last(strokes, parts);
    }
  }
}

/// On a straight line (halo + width / 2) / sin(angle) is left out on both sides.
TEST(StrokesByDepth, AHaloCutsTheFartherLineBack) {
  for (const double degrees : {90.0, 60.0, 30.0, 15.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const Point2 along(std::cos(angle), std::sin(angle));
    const std::vector<DeepStroke> strokes{
        stroke({0.0, 0.5, 0.5}, {1.0, 0.5, 0.5}, 0, 2.0),
        stroke({Point2(0.5) - 0.45 * along, 0.75}, {Point2(0.5) + 0.45 * along, 0.75}, 1, 6.0)};
    const auto parts = strokes_by_depth(strokes, kPicture, 5.0, 1);
    ASSERT_EQ(parts.size(), 3u) << degrees;
    const double gap = (5.0 + 6.0 / 2.0) / std::sin(angle) / kPicture.pixels.x;
    EXPECT_EQ(parts[0].stroke, 0u);
    EXPECT_EQ(parts[1].stroke, 0u);
    EXPECT_EQ(parts[2].stroke, 1u);
    EXPECT_NEAR(parts[0].to, 0.5 - gap, 1e-12) << degrees;
    EXPECT_NEAR(parts[1].from, 0.5 + gap, 1e-12) << degrees;
    EXPECT_TRUE(parts[0].cuts.at_end && !parts[0].cuts.at_start);
    EXPECT_TRUE(parts[1].cuts.at_start && !parts[1].cuts.at_end);
  }
}

/// A picture that is twice as wide as high: widths and halos are in its pixels.
TEST(StrokesByDepth, PixelsOfAPictureAreSquare) {
  const std::vector<DeepStroke> strokes{stroke({0.0, 0.5, 0.5}, {1.0, 0.5, 0.5}, 0, 2.0),
                                        stroke({0.5, 0.0, 0.75}, {0.5, 1.0, 0.75}, 1, 6.0)};
  const auto parts = strokes_by_depth(strokes, {{512.0, 256.0}, 1e-9}, 5.0, 1);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_NEAR(parts[0].to, 0.5 - 8.0 / 512.0, 1e-12);
}

/// A farther polyline of short segments under a nearer one of short segments.
TEST(StrokesByDepth, AGapRunsOnOverJoints) {
  constexpr int kSegments = 64;
  std::vector<DeepStroke> strokes;
  for (std::uint32_t look = 0; look < 2; ++look) {
    for (int k = 0; k < kSegments; ++k) {
      const double s = 1.0 * k / kSegments, t = 1.0 * (k + 1) / kSegments;
      const double z = look == 0 ? 0.25 : 0.75;
      strokes.push_back(look == 0 ? DeepStroke{{s, 0.51, z}, {t, 0.51, z}, 2.0, 0, look}
                                  : DeepStroke{{0.51, s, z}, {0.51, t, z}, 6.0, 1, look});
    }
  }
  const auto parts = strokes_by_depth(strokes, kPicture, 5.0, 1);
  double drawn = 0.0, low = 0.0, high = 1.0;
  for (const PartByDepth& part : parts) {
    if (part.stroke >= kSegments) continue;
    drawn += (part.to - part.from) / kSegments;
    const double from = (part.stroke + part.from) / kSegments;
    const double to = (part.stroke + part.to) / kSegments;
    if (to < 0.51) low = std::max(low, to);
    if (from > 0.51) high = std::min(high, from);
  }
  EXPECT_NEAR(low, 0.51 - 8.0 / 256.0, 1e-9);
  EXPECT_NEAR(high, 0.51 + 8.0 / 256.0, 1e-9);
  EXPECT_NEAR(drawn, 1.0 - 16.0 / 256.0, 1e-9);
}

/// A polyline that bends sharply in depth leaves no gap beside its own joint.
TEST(StrokesByDepth, NoGapWhereOneContinuesTheOther) {
  const std::vector<DeepStroke> strokes{{{0.1, 0.5, 0.1}, {0.5, 0.5, 0.9}, 4.0, 0, 0},
                                        {{0.5, 0.5, 0.9}, {0.1, 0.52, 0.95}, 4.0, 0, 1},
                                        {{0.1, 0.52, 0.99}, {0.1, 0.9, 0.99}, 4.0, 0, 2}};
  EXPECT_EQ(strokes_by_depth(strokes, kPicture, 6.0, 1).size(), 3u);
}

/// The line between them is seen end-on: their ends meet in the picture alone.
TEST(StrokesByDepth, NoGapWhereALineSeenEndOnIsBetween) {
  std::vector<DeepStroke> strokes{{{0.1, 0.5, 0.1}, {0.5, 0.5, 0.1}, 4.0, 0, 0},
                                  {{0.5, 0.5, 0.9}, {0.5, 0.9, 0.9}, 4.0, 0, 2}};
  EXPECT_EQ(strokes_by_depth(strokes, kPicture, 6.0, 1).size(), 2u);
  EXPECT_EQ(strokes_by_depth(strokes, kPicture, 6.0, 1)[0].to, 1.0);
  strokes[1].look = 1;  // another line, which ends there
  EXPECT_LT(strokes_by_depth(strokes, kPicture, 6.0, 1)[0].to, 1.0);
}

/// Long ones that cross nothing, of one stroke each: no circles, no cuts, the same order.
TEST(StrokesByDepth, WhatDoesNotCrossStaysAsItIs) {
  std::vector<DeepStroke> strokes;
  for (std::uint32_t k = 0; k < 100; ++k) {
    const double y = 0.005 + k / 100.0;
    strokes.push_back(stroke({0.1, y, 1.0 - y}, {0.9, y, y}, k, 1.0));
  }
  const auto parts = strokes_by_depth(strokes, kPicture, 3.0, 1);
  ASSERT_EQ(parts.size(), 100u);
  for (std::uint32_t k = 0; k < 100; ++k) EXPECT_EQ(parts[k].stroke, k);
}

/// The wider pen covers the end of the other, though no axes cross.
TEST(StrokesByDepth, WidthsThatOverlapAreInOrder) {
  const std::vector<DeepStroke> strokes{stroke({0.5, 0.1, 0.75}, {0.5, 0.9, 0.75}, 0, 20.0),
                                        stroke({0.52, 0.5, 0.25}, {0.9, 0.5, 0.25}, 1, 2.0)};
  EXPECT_EQ(strokes_by_depth(strokes, kPicture, 0.0, 1).back().stroke, 0u);
}

/// One line over the other in the plane of sight, nearer on one half and farther on the other.
TEST(StrokesByDepth, LinesAlongEachOtherChangePlaces) {
  const std::vector<DeepStroke> strokes{stroke({0.1, 0.5, 0.2}, {0.9, 0.5, 0.8}, 0),
                                        stroke({0.1, 0.5, 0.8}, {0.9, 0.5, 0.2}, 1)};
  const auto parts = strokes_by_depth(strokes, kPicture, 0.0, 1);
  expect_whole(strokes, parts);
  const auto last_at = [&](double at) {
    const auto a = places_of(parts, 0, Q(at)), b = places_of(parts, 1, Q(at));
    return a.back() > b.back() ? 0 : 1;
  };
  EXPECT_EQ(last_at(0.25), 1);
  EXPECT_EQ(last_at(0.75), 0);
}

TEST(StrokesByDepth, ThreadsAndTwiceAreTheSame) {
  RandomStrokes random(13);
  const auto strokes = random.strokes(200, 0, 1.0, 4);
  const auto one = strokes_by_depth(strokes, kPicture, 2.0, 1);
  const auto three = strokes_by_depth(strokes, kPicture, 2.0, 3);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    ASSERT_EQ(one[k].stroke, three[k].stroke);
    ASSERT_EQ(one[k].from, three[k].from);
    ASSERT_EQ(one[k].to, three[k].to);
  }
}

TEST(StrokesByDepth, PartWithin) {
  const auto part = part_within({0, 0}, {10, 0}, {5, -3}, {5, 3}, 2.0);
  ASSERT_TRUE(part);
  EXPECT_NEAR(part->from, 0.3, 1e-15);
  EXPECT_NEAR(part->to, 0.7, 1e-15);
  const auto past_end = part_within({0, 0}, {10, 0}, {5, 1}, {5, 3}, 2.0);
  ASSERT_TRUE(past_end);
  EXPECT_NEAR(past_end->to, 0.5 + std::sqrt(3.0) / 10.0, 1e-15);
  EXPECT_FALSE(part_within({0, 0}, {10, 0}, {5, 2.1}, {5, 3}, 2.0));
  EXPECT_TRUE(part_within({0, 0}, {10, 0}, {2, 1}, {2, 1}, 1.0));
}

}  // namespace
}  // namespace displayfile
