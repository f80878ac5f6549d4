// Hatching: inside the fills, as dense as they are dark, in lines that continue from piece to
// piece.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "clip/geometry/unit.h"
#include "interp/vector/pens/hatched_fills.h"
#include "interp/vector/pens/hatching.h"

namespace displayfile {
namespace {

constexpr Rectangle kSheet{0.0, 200.0, 0.0, 200.0};

using Polygon = std::vector<Point2>;

void add(HatchLines& lines, const Polygon& polygon, double darkness) {
  lines.add(polygon, std::vector<double>(polygon.size(), darkness));
}
Polygon box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

double length(const Stroke& s) {
  return std::sqrt(static_cast<double>(squared_distance(s.from, s.to))) / kUnitsOfMillimetre;
}
double length(const std::vector<Stroke>& strokes) {
  double sum = 0.0;
  for (const Stroke& s : strokes) sum += length(s);
  return sum;
}

std::vector<Stroke> hatched(const Polygon& polygon, double darkness, double spacing, double angle) {
  HatchLines lines(spacing, angle, kSheet);
  add(lines, polygon, darkness);
  return lines.strokes(0.0);
}

/// For one fill, the length of lines times their distance is the fill's area times its darkness.
TEST(Hatching, IsAsDenseAsTheFillIsDark) {
  const Polygon star{{100, 10},  {120, 80}, {190, 100}, {120, 120},
                     {100, 190}, {80, 120}, {10, 100},  {80, 80}};
  double area = 0.0;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Point2 &a = star[i], &b = star[(i + 1) % star.size()];
    area += (a.x * b.y - a.y * b.x) / 2.0;
  }
  for (const double angle : {0.0, 30.0, 45.0, 90.0, 135.0, -20.0, 405.0}) {
    for (const double darkness : {1.0, 0.75, 0.5, 0.25, 0.125, 0.3}) {
      const double spacing = 0.2;
      const double drawn = length(hatched(star, darkness, spacing, angle)) * spacing;
      const double whole = std::round(darkness * 64.0) / 64.0;  // tones of the grid
      EXPECT_NEAR(drawn / (area * whole), 1.0, 0.03) << angle << " " << darkness;
    }
    EXPECT_TRUE(hatched(star, 0.0, 0.2, angle).empty());
    EXPECT_TRUE(hatched(star, -1.0, 0.2, angle).empty());  // brighter than the paper
    EXPECT_EQ(hatched(star, 2.0, 1.0, angle), hatched(star, 1.0, 1.0, angle));
  }
}

TEST(Hatching, LiesAtItsAngle) {
  const auto lines = [](double angle) {
    const std::vector<Stroke> strokes = hatched(box(10, 10, 90, 90), 1.0, 1.0, angle);
    EXPECT_GE(strokes.size(), 80u) << angle;
    return strokes;
  };
  for (const Stroke& s : lines(0.0)) EXPECT_EQ(s.from.y, s.to.y);
  for (const Stroke& s : lines(90.0)) EXPECT_EQ(s.from.x, s.to.x);
  for (const Stroke& s : lines(45.0)) {  // up to the right
    EXPECT_NEAR(s.to.x - s.from.x, -(s.to.y - s.from.y), 1.0);
  }
}

bool is_inside(const Polygon& polygon, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point2 &a = polygon[i], &b = polygon[j];
    if ((a.y > y) != (b.y > y) && x < (b.x - a.x) * (y - a.y) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside;
}

/// Also of polygons that cross themselves, which are filled even-odd, and outside of the sheet.
TEST(Hatching, LiesInsideOfTheFill) {
  std::mt19937 random(3);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  double whole = 0.0;
  for (int round = 0; round < 60; ++round) {
    Polygon polygon;
    for (int k = 0; k < 3 + round % 7; ++k)
      polygon.push_back({-50 + 300 * unit(), -50 + 300 * unit()});
    const std::vector<Stroke> strokes = hatched(polygon, 1.0, 3.0, 180.0 * unit());
    for (const Stroke& s : strokes) {
      for (const double t : {0.001, 0.3, 0.5, 0.999}) {
        if (length(s) < 0.01) continue;
        const double x = (s.from.x + t * (s.to.x - s.from.x)) / kUnitsOfMillimetre;
        const double y = (s.from.y + t * (s.to.y - s.from.y)) / kUnitsOfMillimetre;
        const bool inside = is_inside(polygon, x, y) || is_inside(polygon, x + 0.002, y) ||
                            is_inside(polygon, x - 0.002, y) || is_inside(polygon, x, y + 0.002) ||
                            is_inside(polygon, x, y - 0.002);
        EXPECT_TRUE(inside) << round << ": " << x << " " << y;
        EXPECT_TRUE(x >= 0.0 && x <= 200.0 && y >= 0.0 && y <= 200.0);
      }
    }
    whole += length(strokes);
  }
  EXPECT_GT(whole * 3.0, 60 * 3000.0);  // or little of the fills was hatched
}

/// Pieces of one tone that tile a figure have the lines of the figure, none of them cut.
TEST(Hatching, GoesOnFromPieceToPiece) {
  std::mt19937 random(5);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (const double angle : {0.0, 45.0, 77.0}) {
    HatchLines lines(0.7, angle, kSheet);
    std::vector<std::vector<Point2>> grid(9, std::vector<Point2>(9));
    for (int i = 0; i < 9; ++i) {
      for (int j = 0; j < 9; ++j) {
        const bool inner = i > 0 && i < 8 && j > 0 && j < 8;
        grid[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = {
            20.0 + 10 * i + (inner ? 4 * unit() : 0.0), 20.0 + 10 * j + (inner ? 4 * unit() : 0.0)};
      }
    }
    for (std::size_t i = 0; i < 8; ++i) {
      for (std::size_t j = 0; j < 8; ++j) {
        add(lines, {grid[i][j], grid[i + 1][j], grid[i + 1][j + 1]}, 0.6);
        add(lines, {grid[i][j], grid[i + 1][j + 1], grid[i][j + 1]}, 0.6);
      }
    }
    const std::vector<Stroke> pieces = lines.strokes(0.0);
    const std::vector<Stroke> whole = hatched(box(20, 20, 100, 100), 0.6, 0.7, angle);
    ASSERT_EQ(pieces.size(), whole.size()) << angle;
    for (std::size_t k = 0; k < whole.size(); ++k) {
      EXPECT_LE(squared_distance(pieces[k].from, whole[k].from), 2);
      EXPECT_LE(squared_distance(pieces[k].to, whole[k].to), 2);
    }
  }
}

/// A darker fill has all lines of a lighter one: they continue across both.
TEST(Hatching, OfADarkerFillHasTheLinesOfALighter) {
  HatchLines lines(1.0, 0.0, kSheet);
  add(lines, box(10, 10, 60, 170), 0.3);
  add(lines, box(60, 10, 110, 170), 0.8);
  std::size_t across = 0, of_the_darker = 0;
  for (const Stroke& s : lines.strokes(0.0)) {
    if (s.from.x == 10'000) {
      EXPECT_EQ(s.to.x, 110'000);
      ++across;
    } else {
      EXPECT_EQ(s.from.x, 60'000);
      ++of_the_darker;
    }
  }
  EXPECT_NEAR(static_cast<double>(across), 0.3 * 160, 3.0);
  EXPECT_NEAR(static_cast<double>(of_the_darker), 0.5 * 160, 3.0);
}

TEST(Hatching, WhatIsLaterCovers) {
  HatchLines lines(1.0, 0.0, kSheet);
  add(lines, box(0, 0, 100, 10), 1.0);
  add(lines, box(30, 0, 60, 10), 0.0);  // bright over dark: nothing is drawn there
  add(lines, box(50, 0, 70, 10), 1.0);
  const std::vector<Stroke> strokes = lines.strokes(0.0);
  EXPECT_EQ(strokes.size(), 20u);
  EXPECT_NEAR(length(strokes), 10 * (30 + 50), 1e-9);
}

/// A piece with a hole is one loop with a bridge to the hole, there and back.
TEST(Hatching, ABridgeToAHoleIsNotSeen) {
  const Polygon keyhole{{0, 0},   {100, 0}, {100, 100}, {0, 100}, {0, 50},  {30, 50},
                        {30, 70}, {70, 70}, {70, 30},   {30, 30}, {30, 50}, {0, 50}};
  const std::vector<Stroke> strokes = hatched(keyhole, 1.0, 1.0, 90.0);
  EXPECT_EQ(strokes.size(), 140u);  // 100 upright lines, of which 40 have the hole
  EXPECT_NEAR(length(strokes), 100 * 100 - 40 * 40, 1e-9);
}

/// Where intensities change along a line it ends where the fill gets too bright for it.
TEST(Hatching, FollowsALinearDarkness) {
  HatchLines lines(0.5, 0.0, kSheet);
  const Polygon square = box(0, 0, 128, 128);
  lines.add(square, std::vector<double>{0.0, 1.0, 1.0, 0.0});
  const std::vector<Stroke> strokes = lines.strokes(0.0);
  EXPECT_NEAR(length(strokes) * 0.5, 128 * 128 / 2.0, 128.0);
  EXPECT_GT(strokes.size(), 200u);
  for (const Stroke& s : strokes) EXPECT_EQ(s.to.x, 128'000);
  HatchLines halves(0.5, 0.0, kSheet);  // in two pieces: the same lines
  halves.add(Polygon{{0, 0}, {128, 0}, {128, 128}}, std::vector<double>{0.0, 1.0, 1.0});
  halves.add(Polygon{{0, 0}, {128, 128}, {0, 128}}, std::vector<double>{0.0, 1.0, 0.0});
  EXPECT_EQ(halves.strokes(0.0), strokes);
}

/// The same the other way round, and where something else covers a part of it.
TEST(Hatching, FollowsADarknessThatFallsBesideWhatCoversIt) {
  const Polygon square = box(0, 0, 128, 128);
  HatchLines lines(0.5, 0.0, kSheet), covered(0.5, 0.0, kSheet);
  for (HatchLines* of : {&lines, &covered})
    of->add(square, std::vector<double>{1.0, 0.0, 0.0, 1.0});
  add(covered, box(32, 0, 64, 128), 0.0);
  const std::vector<Stroke> strokes = lines.strokes(0.0);
  EXPECT_NEAR(length(strokes) * 0.5, 128 * 128 / 2.0, 128.0);
  std::vector<Stroke> expected;  // the remaining parts of them
  for (const Stroke& s : strokes) {
    EXPECT_EQ(s.from.x, 0);
    expected.push_back({s.from, {std::min(s.to.x, 32'000), s.to.y}});
    if (s.to.x > 64'000) expected.push_back({{64'000, s.from.y}, s.to});
  }
  EXPECT_GT(expected.size(), strokes.size());
  EXPECT_EQ(covered.strokes(0.0), expected);
}

/// A line has a part beside each that covers it, and none where nothing lies.
TEST(Hatching, GoesOnBesideWhatCoversItAndEndsAtGaps) {
  HatchLines lines(1.0, 0.0, kSheet);
  add(lines, box(0, 0, 100, 1), 1.0);
  add(lines, box(30, 0, 60, 1), 0.0);
  add(lines, box(120, 0, 130, 1), 1.0);
  add(lines, box(125, 0, 140, 1), 0.0);
  const std::vector<Stroke> expected{
      {{0, 500}, {30'000, 500}}, {{60'000, 500}, {100'000, 500}}, {{120'000, 500}, {125'000, 500}}};
  EXPECT_EQ(lines.strokes(0.0), expected);
}

/// Corners on lines: each line is as long as the fill is wide there.
TEST(Hatching, LinesThroughCornersAreWhole) {
  const Polygon diamond{{20, 10.5}, {30, 20.5}, {20, 30.5}, {10, 20.5}};
  for (const bool turned : {false, true}) {
    Polygon polygon = diamond;
    if (turned) std::ranges::reverse(polygon);
    const std::vector<Stroke> strokes = hatched(polygon, 1.0, 1.0, 0.0);
    ASSERT_EQ(strokes.size(), 19u);  // and at both ends one of no length
    for (std::size_t k = 0; k < strokes.size(); ++k) {
      const double wide = 2.0 * (10.0 - std::abs(static_cast<double>(k) - 9.0));
      EXPECT_NEAR(length(strokes[k]), wide, 1e-9) << k;
    }
  }
}

TEST(Hatching, ShortLinesAreLeftOut) {
  HatchLines lines(1.0, 45.0, kSheet);
  add(lines, box(10, 10, 20, 20), 1.0);
  const std::vector<Stroke> all = lines.strokes(0.0), some = lines.strokes(3.0);
  std::vector<Stroke> expected;
  for (const Stroke& s : all) {
    if (length(s) >= 3.0) expected.push_back(s);
  }
  EXPECT_EQ(some, expected);
  EXPECT_GT(some.size(), 8u);
  EXPECT_LT(some.size(), all.size());
}

/// Lines continue over gaps of two thousandths of a millimetre, which no pen leaves, and not of
/// three.
TEST(Hatching, ClosesGapsThatNoPenLeaves) {
  for (const auto& [gap, strokes] : {std::pair(0.0015, 20u), std::pair(0.003, 40u)}) {
    HatchLines lines(1.0, 0.0, kSheet);
    add(lines, box(10, 10, 20, 30), 1.0);
    add(lines, box(20 + gap, 10, 40, 30), 1.0);
    EXPECT_EQ(lines.strokes(0.0).size(), strokes) << gap;
  }
}

/// A curved surface in shade has one tone from some facet on: its lines continue, and are not those
/// of a large tone, which has its own spacing.
TEST(HatchedFills, AToneIntoWhichAnotherRunsIsOnItsGrid) {
  const Polygon left = box(0, 0, 60, 100), right = box(60, 0, 120, 100);
  const auto strokes = [&](double where_they_meet, double apart) {
    HatchedFills fills(Hatching{.spacing = 1.0, .angle = 0.0}, kSheet);
    Polygon shade = right;
    for (Point2& p : shade) p.x += apart;
    const double least = 0.2;
    fills.add(left, std::vector<double>{least, where_they_meet, where_they_meet, least}, true);
    fills.add(shade, std::vector<double>(4, 0.7), true);
    return fills.strokes();
  };
  const std::vector<Stroke> smooth = strokes(0.7, 0.0);
  EXPECT_LE(smooth.size(), 75u);
  for (const Stroke& s : smooth) EXPECT_EQ(std::max(s.from.x, s.to.x), 120'000);
  EXPECT_EQ(strokes(0.7 + 1e-12, 0.0).size(), smooth.size());  // up to rounding
  for (const auto& other : {strokes(0.65, 0.0), strokes(0.7, 1.0)}) {
    EXPECT_GT(other.size(), 100u);
  }
}

/// The triangles of a flat face may have normals that are rounded differently.
TEST(HatchedFills, RoundedTonesAreOne) {
  const auto strokes = [](double rounding) {
    HatchedFills fills(Hatching{.spacing = 1.0, .angle = 0.0}, kSheet);
    for (int k = 0; k < 100; ++k) {
      const double dark = 0.7 + rounding * (k % 7), y = k;
      fills.add(box(10, y, 110, y + 1), std::vector<double>{dark, dark + rounding, dark, dark},
                true);
    }
    return fills.strokes();
  };
  EXPECT_EQ(strokes(0.0), strokes(1e-6));
}

/// A flat face has even lines whatever stands beside it: equally dark facets of a curved surface in
/// shade, and facets that run from its tone into another; and so has one of the same tone
/// elsewhere.
TEST(HatchedFills, AFlatFaceIsEvenBesideWhatIsRound) {
  constexpr double kTone = 0.7, kLight = 0.2;
  Polygon plate{{0, 0}, {100, 0}};
  for (int k = 10; k >= 0; --k) plate.push_back({10.0 * k, 100.0});
  HatchedFills fills(Hatching{.spacing = 1.0, .angle = 0.0}, kSheet);
  fills.add(plate, std::vector<double>(plate.size(), kTone), true);
  fills.add(box(120, 0, 180, 100), std::vector<double>(4, kTone), true);
  for (int k = 0; k < 10; ++k) {
    const double x = 10.0 * k;
    const double right = k < 5 ? kTone : kLight, left_side = k < 6 ? kTone : kLight;
    fills.add(box(x, 100, x + 10, 180), std::vector<double>{kTone, kTone, right, left_side}, true,
              {0.01 * (k + 1), 0.0});
  }
  std::vector<std::int32_t> left, lone, round;
  for (const Stroke& s : fills.strokes()) {
    const auto x = std::min(s.from.x, s.to.x), y = s.from.y;
    (x >= 120'000 ? lone : y < 100'000 ? left : round).push_back(y);
  }
  EXPECT_EQ(left, lone);
  ASSERT_GT(left.size(), 60U);
  for (std::size_t k = 2; k < left.size(); ++k) {
    EXPECT_NEAR(left[k] - left[k - 1], left[1] - left[0], 1) << k;
  }
  for (const std::int32_t y : round) EXPECT_EQ((y - round[0]) % 1000, 0) << y;  // one grid
}

TEST(Darkness, IsBetweenPaperAndPen) {
  const Colour black(0.0), white(1.0), grey(0.25);
  EXPECT_EQ(Darkness(white, black).of(white), 0.0);
  EXPECT_EQ(Darkness(white, black).of(black), 1.0);
  EXPECT_NEAR(Darkness(white, black).of(grey), 0.75, 1e-12);
  EXPECT_NEAR(Darkness(black, white).of(grey), 0.25, 1e-12);  // a white pen on black paper
  EXPECT_EQ(Darkness(white, white).of(black), 0.0);           // it would not be seen
}

/// By the weights of ITU-R BT.709.
TEST(Darkness, CountsEachComponentByItsLuma) {
  const Darkness darkness(Colour(1.0), Colour(0.0));
  EXPECT_NEAR(darkness.of({1, 0, 0}), 1.0 - 0.2126, 1e-12);
  EXPECT_NEAR(darkness.of({0, 1, 0}), 1.0 - 0.7152, 1e-12);
  EXPECT_NEAR(darkness.of({0, 0, 1}), 1.0 - 0.0722, 1e-12);
  // The same holds for a pen and a paper with colours.
  EXPECT_NEAR(Darkness(Colour(1.0), {0, 0, 1}).of({1, 0, 0}), (1.0 - 0.2126) / (1.0 - 0.0722),
              1e-12);
  EXPECT_NEAR(Darkness({0, 1, 0}, Colour(0.0)).of({1, 0, 0}), 1.0 - 0.2126 / 0.7152, 1e-12);
}

}  // namespace
}  // namespace displayfile
