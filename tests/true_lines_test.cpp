// The oracle of lines against scenes worked out by hand and against brute force in rationals; and
// changes that must not affect an answer do not.

#include "interp/truth/true_lines.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "programs/scenes/hard_cases.h"
#include "programs/scenes/random_scenes.h"
#include "tests/brute_force_lines.h"
#include "tests/error_of.h"
#include "tests/line_drawings.h"
#include "tests/slower.h"
#include "tests/truth_scenes.h"
#include "tests/without_entered.h"

namespace displayfile {
namespace {

using namespace test;

/// The visible parts of a line, by the oracle, which must equal those by brute force.
Parts seen(const Drawing& drawing, LineId line) {
  const LineItems items(drawing.file());
  const auto found = true_lines(items, std::vector{line});
  if (found.empty()) return {};
  const auto naive = test::BruteForceLines(items, 1000).visible(found[0].sharers);
  Parts expected;
  for (const auto& [from, to] : naive) expected.push_back({from, to});
  EXPECT_EQ(found[0].visible, expected);
  return found[0].visible;
}

/// The parts of a line from (0, y, z) to (1, y, z) that are visible behind polygons.
Parts behind(const std::vector<Vertices>& polygons, double y, double z = 0.0, double z_end = 0.0) {
  Drawing drawing;
  drawing.line({0, y, z}, {1, y, z_end});
  for (const Vertices& vertices : polygons) drawing.polygon(vertices);
  return seen(drawing, {0, 1});
}

const Parts kAll{{0.0, 1.0}}, kNone{};

// ---- By hand -------------------------------------------------------------------------------

TEST(TrueLines, ASquareHidesTheMiddleOfALineBehindIt) {
  EXPECT_EQ(behind({square(0.5)}, 0.5), (Parts{{0, 0.25}, {0.75, 1}}));
  EXPECT_EQ(behind({rectangle(0.25, 0, 2, 1, 0.5)}, 0.5), (Parts{{0, 0.25}}));
  EXPECT_EQ(behind({rectangle(-1, 0, 0.25, 1, 0.5)}, 0.5), (Parts{{0.25, 1}}));
  EXPECT_EQ(behind({rectangle(-1, 0, 2, 1, 0.5)}, 0.5), kNone);
}

TEST(TrueLines, ALineBeforeOrBesideASquareIsSeen) {
  EXPECT_EQ(behind({square(-0.5)}, 0.5), kAll);
  EXPECT_EQ(behind({square(0.5)}, 0.8), kAll);
  EXPECT_EQ(behind({rectangle(1, 0, 2, 1, 0.5)}, 0.5), kAll);  // which only touches its end
}

TEST(TrueLines, ALineThatPiercesASquareIsHiddenBehindIt) {
  EXPECT_EQ(behind({square(0.5)}, 0.5, 0.0, 1.0), (Parts{{0, 0.25}, {0.5, 1}}));
  EXPECT_EQ(behind({square(0.5)}, 0.5, 1.0, 0.0), (Parts{{0, 0.5}, {0.75, 1}}));
}

TEST(TrueLines, ALineThatTouchesAPlaneFromBehindIsHidden) {
  EXPECT_EQ(behind({rectangle(0, 0, 1, 1, 0.5)}, 0.5, 0.0, 0.5), kNone);
  EXPECT_EQ(behind({rectangle(0, 0, 1, 1, 0.5)}, 0.5, 1.0, 0.5), kAll);
}

TEST(TrueLines, ALineBehindTheEdgeThatTwoSquaresShareIsHidden) {
  const Vertices below = rectangle(0, 0, 1, 0.5, 0.5), above = rectangle(0, 0.5, 1, 1, 0.5);
  EXPECT_EQ(behind({below, above}, 0.5), kNone);
  EXPECT_EQ(behind({below, rectangle(0, 0.5, 1, 1, 0.25)}, 0.5), kNone);
  EXPECT_EQ(behind({below, rectangle(0.25, 0.5, 0.75, 1, 0.25)}, 0.5),
            (Parts{{0, 0.25}, {0.75, 1}}));
  EXPECT_EQ(behind({below, rectangle(0, 0.5, 1, 1, 0)}, 0.5), kAll);   // as near as the line
  EXPECT_EQ(behind({below, rectangle(0, 0.5, 1, 1, -1)}, 0.5), kAll);  // behind it
}

TEST(TrueLines, ALineBehindAnOutlineIsSeen) {
  EXPECT_EQ(behind({square(0.5)}, 0.25), kAll);
  EXPECT_EQ(behind({square(0.5)}, 0.75), kAll);
  EXPECT_EQ(behind({square(0.5), square(0.75)}, 0.75), kAll);
}

TEST(TrueLines, ASideOnTheOutlineOfANearerSquareIsSeen) {
  Drawing drawing;
  drawing.polygon(rectangle(0, 0.25, 1, 1, 0)).polygon(square(0.5));
  EXPECT_EQ(seen(drawing, {0, 1}), kAll);  // from (0, 0.25) to (1, 0.25)
  EXPECT_EQ(seen(drawing, {0, 2}), kAll);
}

TEST(TrueLines, CoplanarIsSeen) {
  EXPECT_EQ(behind({square(0)}, 0.5), kAll);
  // A tilted plane that contains the line, and the sides of polygons in it.
  const auto lifted = [](Vertices v) {
    for (Point3& p : v) p.z = 0.5 * p.x + 0.25 * p.y;
    return v;
  };
  Drawing drawing;
  drawing.polygon(lifted(square(0))).polygon(lifted(rectangle(0, 0, 1, 0.5, 0)));
  drawing.line({0, 0.5, 0.125}, {1, 0.5, 0.625});
  for (const LineId line : LineItems(drawing.file()).all_lines()) {
    EXPECT_EQ(seen(drawing, line), kAll);
  }
}

TEST(TrueLines, AnEdgeOnPolygonHidesNothing) {
  EXPECT_EQ(behind({{{0, 0.5, 1}, {1, 0.5, 1}, {1, 0.5, 2}, {0, 0.5, 2}}}, 0.5), kAll);
  EXPECT_EQ(behind({{{0.5, 0, 1}, {0.5, 1, 1}, {0.5, 1, 2}}}, 0.5), kAll);
  // Edge-on only as rounded; and only exactly (tests/truth_test.cpp).
  EXPECT_EQ(behind({{{0x1p-60, 0, 1}, {1, 1, 1}, {0.25, 0.25, 1}}}, 0.25), kAll);
  const double p = -0x1.f3f5f786b8a40p-2, q = 0x1.d6c126d0047a0p-3, r = 0x1.812d0ba1fa748p-3;
  EXPECT_EQ(behind({{{p, 3 * p, 1},
                     {q, 3 * q, 2},
                     {r, 3 * r, 1},
                     {0x1.669e6b68d4351p-4, 0x1.0cf6d08e9f27cp-2, 1}}},
                   0.375),
            kAll);
}

TEST(TrueLines, ASideOfAnEdgeOnPolygonHasTheDepthOfItsEnds) {
  Drawing drawing;
  drawing.polygon({{0, 0.5, 0}, {1, 0.5, 0}, {1, 0.5, 1}, {0, 0.5, 1}}).polygon(square(0.5));
  EXPECT_EQ(seen(drawing, {0, 1}), (Parts{{0, 0.25}, {0.75, 1}}));
  EXPECT_EQ(seen(drawing, {0, 2}), kNone);  // a point in the projection has no length
  EXPECT_EQ(seen(drawing, {0, 3}), kAll);
  Drawing slanted;
  slanted.polygon({{0, 0.5, 0}, {0.5, 0.5, 7}, {1, 0.5, 1}}).polygon(square(0.5));
  EXPECT_EQ(seen(slanted, {0, 0}), (Parts{{0, 0.5}, {0.75, 1}}));  // from (1, 0.5) to (0, 0.5)
}

TEST(TrueLines, SelfCrossingPolygonsCoverEvenOdd) {
  const Vertices bow_tie = {{0, 0, 1}, {1, 1, 1}, {1, 0, 1}, {0, 1, 1}};
  EXPECT_EQ(behind({bow_tie}, 0.25), (Parts{{0.25, 0.75}}));
  EXPECT_EQ(behind({bow_tie}, 0.5), kNone);
  Vertices pentagram = {{8, 16, 16}, {13, 0, 16}, {0, 10, 16}, {16, 10, 16}, {3, 0, 16}};
  for (Point3& v : pentagram) v /= 16.0;
  EXPECT_EQ(behind({pentagram}, 5.0 / 16),
            (Parts{{0, 4.5625 / 16}, {6.5 / 16, 9.5 / 16}, {11.4375 / 16, 1}}));
  Vertices twice = square(1);
  twice.insert(twice.end(), twice.begin(), twice.begin() + 4);
  EXPECT_EQ(behind({twice}, 0.5), kAll);
}

TEST(TrueLines, ConcavePolygons) {
  const Vertices valley = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0.5, 0.25, 1}, {0, 1, 1}};
  EXPECT_EQ(behind({valley}, 0.5), (Parts{{1.0 / 3, 2.0 / 3}}));
  EXPECT_EQ(behind({valley}, 0.25), kNone);  // through the vertex
  // A notch whose floor lies along the line parts left from right there.
  const Vertices notch = {{0, 0, 1},      {1, 0, 1},      {1, 1, 1},    {0.75, 1, 1},
                          {0.75, 0.5, 1}, {0.25, 0.5, 1}, {0.25, 1, 1}, {0, 1, 1}};
  EXPECT_EQ(behind({notch}, 0.5), (Parts{{0.25, 0.75}}));
}

TEST(TrueLines, RepeatedVerticesChangeNothing) {
  Vertices repeated;
  for (const Point3& p : square(0.5)) repeated.insert(repeated.end(), 3, p);
  EXPECT_EQ(behind({repeated}, 0.5), (Parts{{0, 0.25}, {0.75, 1}}));
  EXPECT_EQ(behind({repeated}, 0.25), kAll);
  Vertices spike = square(0.5);  // there and back along the line
  spike.insert(spike.begin() + 2, {{0.75, 0.5, 0.5}, {1, 0.5, 0.5}, {0.75, 0.5, 0.5}});
  EXPECT_EQ(behind({spike}, 0.5), (Parts{{0, 0.25}, {0.75, 1}}));
}

TEST(TrueLines, TouchingCubesSeenAlongAnAxis) {
  Drawing drawing;  // of each the front and the back; its sides are edge-on
  drawing.polygon(rectangle(0, 0, 0.5, 1, 1)).polygon(rectangle(0, 0, 0.5, 1, 0));
  drawing.polygon(rectangle(0.5, 0, 1, 1, 1)).polygon(rectangle(0.5, 0, 1, 1, 0));
  drawing.polygon({{0.5, 0, 0}, {0.5, 1, 0}, {0.5, 1, 1}, {0.5, 0, 1}});
  EXPECT_EQ(seen(drawing, {0, 2}), kAll);   // the front edge that the cubes share
  EXPECT_EQ(seen(drawing, {1, 2}), kNone);  // the back one, right behind it
  EXPECT_EQ(seen(drawing, {4, 2}), kNone);  // a point
  EXPECT_EQ(seen(drawing, {1, 0}), kAll);   // behind the outline
  const auto lines =
      true_lines(LineItems(drawing.file()), std::vector<LineId>{{4, 1}, {3, 0}, {2, 0}});
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].sharers, (std::vector<LineId>{{0, 2}, {2, 0}, {4, 3}}));
  EXPECT_EQ(lines[1].sharers, (std::vector<LineId>{{1, 2}, {3, 0}, {4, 1}}));
}

TEST(TrueLines, CyclicOverlapOfThree) {
  const auto eighths = [](Vertices v) {
    for (Point3& p : v) p /= 8.0;
    return v;
  };
  Drawing drawing;  // the second before the first, the third before the second, the first before it
  drawing.polygon(eighths({{0, 1, 0}, {8, 1, 8}, {8, 2, 8}, {0, 2, 0}}));
  drawing.polygon(eighths({{6, 0, 10}, {6, 8, 2}, {7, 8, 2}, {7, 0, 10}}));
  drawing.polygon(eighths({{0, 1, -12}, {1, 0, -12}, {8, 7, 16}, {7, 8, 16}}));
  EXPECT_EQ(seen(drawing, {0, 1}), (Parts{{0, 0.75}, {0.875, 1}}));
  EXPECT_EQ(seen(drawing, {1, 1}), (Parts{{0, 0.625}, {0.875, 1}}));
  EXPECT_EQ(seen(drawing, {2, 2}), (Parts{{0, 1.0 / 7}, {2.0 / 7, 1}}));
}

TEST(TrueLines, ASharedSideIsSeenWhereItIsSeenForOne) {
  // The first polygon's last vertex counts as moved on to its plane, z = 0; the second's plane goes
  // through both ends of the side.
  Drawing drawing;
  drawing.polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5}});
  drawing.polygon({{0, 1, 0.5}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0.5}});
  drawing.polygon(rectangle(-1, 0.5, 2, 3, 0.25));
  EXPECT_EQ(seen(drawing, {0, 3}), (Parts{{0.5, 1}}));  // from (1, 1) to (0, 1)
  EXPECT_EQ(seen(drawing, {1, 1}), (Parts{{0.5, 1}}));  // along the first sharer
  const auto lines = true_lines(LineItems(drawing.file()), std::vector<LineId>{{1, 1}});
  EXPECT_EQ(lines[0].sharers, (std::vector<LineId>{{0, 3}, {1, 1}}));
}

TEST(TrueLines, NearlyCoplanarIsToldApart) {
  EXPECT_EQ(behind({square(0.5)}, 0.5, 0.5 - 1e-15, 0.5 - 1e-15), (Parts{{0, 0.25}, {0.75, 1}}));
  EXPECT_EQ(behind({square(0.5)}, 0.5, 0.5 + 1e-15, 0.5 + 1e-15), kAll);
  EXPECT_EQ(behind({square(0.5)}, 0.5, 0.5 - 0x1p-50, 0.5 + 0x1p-50), (Parts{{0, 0.25}, {0.5, 1}}));
  // Two squares that share an edge up to an ulp: the line is between them, or right of both.
  const double ulp = std::nextafter(0.5, 1.0);
  EXPECT_EQ(behind({rectangle(0, 0, 1, 0.5, 1), rectangle(0, ulp, 1, 1, 1)}, ulp), kAll);
  EXPECT_EQ(behind({rectangle(0, 0, 1, ulp, 1), rectangle(0, 0.5, 1, 1, 1)}, 0.5), kNone);
}

// ---- Which lines ---------------------------------------------------------------------------

TEST(LineItems, AreThoseThatShowInOrderOfEntry) {
  DisplayFile file;
  Segment& first = file.create(5);
  first.set_style(FillStyle{FillStyle::Kind::hollow});
  first.set_style(LineStyle{LineStyle::Kind::none});
  enter(first, square(1));                 // nothing is seen of it
  first.enter_line({0, 0, 0}, {1, 1, 0});  // nor of this
  first.set_style(LineStyle{});
  enter(first, square(2));                       // 0
  first.enter_line({0.25, 0.75, 2}, {1, 1, 3});  // 1, from where the polygon ends
  first.enter_line({1, 1, 3}, {1, 0, 3});        // 2
  file.create(1).visible = false;
  enter(file.segment(1), square(4));
  Segment& last = file.create(3);
  last.image.translation = {0.5, 0.0};
  last.set_style(FillStyle{});
  last.set_style(LineStyle{LineStyle::Kind::none});
  enter(last, square(5));  // 3
  last.set_style(LineStyle{LineStyle::Kind::dashed});
  last.enter_polygon(square(6), std::vector<std::uint8_t>{1, 0, 0, 1});  // 4

  const LineItems items(file);
  ASSERT_EQ(items.size(), 5u);
  using Kind = LineItems::Kind;
  EXPECT_EQ(items.kind(0), Kind::hollow);
  EXPECT_EQ(items.kind(1), Kind::line);
  EXPECT_EQ(items.kind(3), Kind::solid);
  EXPECT_EQ(items.from({0, 0}), Point3(0.25, 0.75, 2));
  EXPECT_EQ(items.to({0, 0}), Point3(0.25, 0.25, 2));
  EXPECT_EQ(items.from({1, 1}), Point3(0.25, 0.75, 2));
  EXPECT_EQ(items.to({1, 1}), Point3(1, 1, 3));
  EXPECT_EQ(items.from({2, 1}), Point3(1, 1, 3));
  EXPECT_EQ(items.to({4, 1}), Point3(1.25, 0.25, 6));
  const std::vector<LineId> drawn = {{0, 0}, {0, 1}, {0, 2}, {0, 3},
                                     {1, 1}, {2, 1}, {4, 0}, {4, 3}};
  EXPECT_EQ(items.drawn_lines(), drawn);
  EXPECT_EQ(items.all_lines().size(), 14u);
}

TEST(LineItems, WhatTheyRefuse) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    test::expect_error(
        [&] {
          LineItems(file_of({{{0, 0, 0}, {1, 0, bad}, {0, 1, 0}}}));
        },
        "segment 1");
  }
  Drawing drawing;
  drawing.polygon(square(0)).line({0, 0, 0}, {1, 1, 0});
  const LineItems items(drawing.file());
  for (const LineId line : std::vector<LineId>{{0, 4}, {1, 0}, {1, 2}, {2, 0}}) {
    test::expect_error([&] { true_lines(items, std::vector{line}); }, "expected an item");
  }
  const auto truth = true_lines(items, items.all_lines());
  for (const LinePiece& piece : std::vector<LinePiece>{
           {{1, 0}, 0, 1}, {{1, 1}, 0.5, 0.5}, {{1, 1}, -0.1, 1}, {{1, 1}, 0, 1.5}}) {
    test::expect_error([&] { compare_lines(items, truth, std::vector{piece}); }, "a piece of line");
    test::expect_error([&] { judge_lines(items, items.all_lines(), std::vector{piece}, 3, 1); },
                       "a piece of line");
  }
}

// ---- Properties ------------------------------------------------------------------------------

template <class Change>
std::vector<Vertices> changed(std::vector<Vertices> items, Change&& change) {
  for (Vertices& vertices : items) {
    for (Point3& p : vertices) change(p);
  }
  return items;
}

Parts naive_parts(const test::BruteForceLines& naive, std::span<const LineId> sharers) {
  Parts parts;
  for (const auto& [from, to] : naive.visible(sharers)) parts.push_back({from, to});
  return parts;
}

void expect_brute_force(const LineItems& items, int places) {
  const test::BruteForceLines naive(items, places);
  for (const TrueLine& line : true_lines(items, items.all_lines())) {
    SCOPED_TRACE(fmt::format("line ({}, {})", line.sharers[0].item, line.sharers[0].corner));
    ASSERT_EQ(line.visible, naive_parts(naive, line.sharers));
  }
}

TEST(TrueLines, OnACoarseGridTheyAreThoseOfBruteForce) {
  std::size_t pieces = 0, whole = 0;
  for (std::uint32_t seed = 0; seed < 400 / test::kSlower; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const DisplayFile file = drawn(on_coarse_grid(seed));
    const LineItems items(file);
    expect_brute_force(items, 500);
    if (testing::Test::HasFatalFailure()) return;
    const auto lines = true_lines(items, items.all_lines());
    pieces += visible_pieces(lines).size();
    whole +=
        static_cast<std::size_t>(std::ranges::count(lines, Parts{{0.0, 1.0}}, &TrueLine::visible));
  }
  EXPECT_GT(pieces, whole + 500u / test::kSlower);  // many lines are hidden in part
}

class TrueLinesOfFamily : public testing::TestWithParam<test::SceneFamily> {};

TEST_P(TrueLinesOfFamily, AreThoseOfBruteForceInRationals) {
  for (std::uint32_t seed = 0; seed < 60 / test::kSlower; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const DisplayFile file = test::scene(GetParam(), seed, 2 + static_cast<int>(seed % 3));
    expect_brute_force(LineItems(file), 6000);
    if (HasFatalFailure()) return;
  }
}

std::string name_of_family(const testing::TestParamInfo<test::SceneFamily>& info) {
  std::string name;
  for (char c : info.param.name) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}
INSTANTIATE_TEST_SUITE_P(All, TrueLinesOfFamily, testing::ValuesIn(test::scene_families()),
                         name_of_family);

TEST(TrueLines, OfRandomDegenerateScenesAreThoseOfBruteForce) {
  for (std::uint32_t seed = 0; seed < 60 / test::kSlower; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const GraphicsSystem system = entered(random_degenerate_scene(seed));
    expect_brute_force(LineItems(system.display_file()), 1000);
    if (HasFatalFailure()) return;
  }
}

/// Small ones by brute force, and all by samples.
TEST(TrueLines, OfHardCases) {
  constexpr std::size_t kFewLines = 50, kFewPolygons = test::kSlower > 1 ? 6 : 16;
  for (const HardCase& hard : hard_cases()) {
    for (const double severity : hard.severities) {
      SCOPED_TRACE(fmt::format("{} {}", hard.name, severity));
      const GraphicsSystem system =
          entered(hard.make(std::min(hard.size, kFewPolygons), severity, 1));
      const DisplayFile file = hard.judged_from == JudgedFrom::entered
                                   ? system.display_file()
                                   : test::without_entered(system.display_file());
      const LineItems items(file);
      const auto lines = items.all_lines();
      if (lines.size() <= kFewLines / test::kSlower) expect_brute_force(items, 3000);
      if (HasFatalFailure()) return;
      const auto pieces = visible_pieces(true_lines(items, lines));
      ASSERT_TRUE(judge_lines(items, lines, pieces, 20, 1).wrong.empty());
    }
  }
}

constexpr std::uint32_t kRandomScenes = 2000 / test::kSlower;

std::vector<LinePiece> pieces_of(const std::vector<Vertices>& scene, int threads = 1) {
  const DisplayFile file = drawn(scene);
  const LineItems items(file);
  return visible_pieces(true_lines(items, items.all_lines(), threads));
}

TEST(TrueLines, ScalingByTwoAndMirroringChangeNothing) {
  for (std::uint32_t seed = 0; seed < kRandomScenes; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const auto scene = on_coarse_grid(seed);
    const auto pieces = pieces_of(scene);
    const auto pieces_after = [&](void (*change)(Point3&)) {
      return pieces_of(changed(scene, change));
    };
    ASSERT_EQ(pieces, pieces_after([](Point3& p) { p *= 2.0; }));
    ASSERT_EQ(pieces, pieces_after([](Point3& p) { p.z *= 0.5; }));
    ASSERT_EQ(pieces, pieces_after([](Point3& p) { p.x = 1.0 - p.x; }));
    ASSERT_EQ(pieces, pieces_after([](Point3& p) { p.y = -p.y; }));
    ASSERT_EQ(pieces, pieces_after([](Point3& p) { std::swap(p.x, p.y); }));
  }
}

TEST(TrueLines, ThreadsChangeNothing) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    ASSERT_EQ(pieces_of(on_coarse_grid(seed)), pieces_of(on_coarse_grid(seed), 3));
  }
}

TEST(TrueLines, TheOrderOfEntryChangesNothing) {
  for (std::uint32_t seed = 0; seed < kRandomScenes; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const auto scene = on_coarse_grid(seed);
    std::vector<std::uint32_t> order(scene.size());
    std::iota(order.begin(), order.end(), 0u);
    Dice dice(seed);
    for (std::size_t k = order.size(); k > 1; --k) {
      std::swap(order[k - 1],
                order[static_cast<std::size_t>(dice.from(0, static_cast<int>(k) - 1))]);
    }
    std::vector<Vertices> other;
    for (const std::uint32_t item : order) other.push_back(scene[item]);
    const DisplayFile file = drawn(scene), other_file = drawn(other);
    const LineItems items(file), other_items(other_file);
    const auto truth = true_lines(items, items.all_lines());
    auto pieces = visible_pieces(true_lines(other_items, other_items.all_lines()));
    for (LinePiece& piece : pieces) piece.line.item = order[piece.line.item];
    const LineErrors errors = compare_lines(items, truth, pieces);
    ASSERT_EQ(errors.missing, 0.0);
    ASSERT_EQ(errors.extra, 0.0);
  }
}

/// Many small triangles and long lines: the index of cells leaves no polygon out.
TEST(TrueLines, OfManyPolygonsAreThoseOfAllOfThem) {
  Dice dice(3);
  std::vector<Vertices> triangles, lines;
  for (int k = 0; k < 200 / test::kSlower; ++k) {
    const double x = 3.0 * dice.part() - 1.0, y = 3.0 * dice.part() - 1.0, z = dice.part();
    triangles.push_back(test::polygon(3, [&] {
      const double u = x + 0.2 * dice.part(), v = y + 0.2 * dice.part();
      return Point3{u, v, z + 0.1 * dice.part()};
    }));
  }
  triangles.push_back(test::polygon(3, [&] {
    return Point3{1e6 * dice.part(), 1e6 * dice.part(), 0.5};
  }));
  for (int k = 0; k < 6; ++k) {
    lines.push_back({{-1, 3.0 * dice.part() - 1.0, 0}, {2, 3.0 * dice.part() - 1.0, 0.5}});
  }
  lines.push_back({{-1, -1, 0}, {1e120, 1e120, 0}});
  std::vector<Vertices> all = lines;
  all.insert(all.end(), triangles.begin(), triangles.end());
  const DisplayFile file = drawn(all);
  const LineItems items(file);
  const test::BruteForceLines naive(items, 600);
  for (std::uint32_t k = 0; k < lines.size(); ++k) {
    const auto found = true_lines(items, std::vector<LineId>{{k, 1}});
    EXPECT_EQ(found[0].visible, naive_parts(naive, found[0].sharers));
    EXPECT_GE(found[0].visible.size(), 2u / test::kSlower);
  }
}

}  // namespace
}  // namespace displayfile
