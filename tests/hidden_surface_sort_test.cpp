// The object-space sorts (hidden/sort/hidden_surface_sort.h), judged by rationals at sample points,
// and their numbers of cuts on cases solved by hand.

#include "hidden/sort/hidden_surface_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "tests/every_way.h"

namespace displayfile {
namespace {

using namespace test;

// ---- Random scenes ------------------------------------------------------------------------------

INSTANTIATE_TEST_SUITE_P(Sorts, EveryWay, testing::ValuesIn(ways()), [](const auto& param) {
  std::string name = param.param.name;
  std::erase_if(name, [](char c) { return c == ' ' || c == ','; });
  return name;
});

TEST_P(EveryWay, DrawsWhatIsSeenLastAndLosesNothing) {
  constexpr int kScenes = 150 / kSlower, kSamples = 25;
  for (const SortFamily& family : sort_families()) {
    for (int k = 0; k < kScenes; ++k) {
      const auto seed = static_cast<std::uint64_t>(k);
      Source s(seed);
      const ItemList list = family.make(s);
      const auto wrong = [&](const ItemList& part) {
        return judged(part, GetParam(), seed, kSamples);
      };
      if (wrong(list).empty()) continue;
      const ItemList least =
          shrunken(list, [&](const ItemList& part) { return !wrong(part).empty(); });
      ADD_FAILURE() << family.name << ", seed " << k << ": " << wrong(least) << "\n"
                    << least.text();
      break;
    }
  }
}

TEST_P(EveryWay, CutsThatNeedNoRoundingKeepTheAreaExactly) {
  for (int k = 0; k < 300 / kSlower; ++k) {
    Source s(static_cast<std::uint64_t>(k));
    const ItemList list = families::dyadic(s);
    const SortedPieces pieces = sorted(list, GetParam());
    ASSERT_EQ(SortJudge(list, pieces).areas(0.0), "") << k << "\n" << list.text();
  }
}

TEST_P(EveryWay, TheMethodIsPutToTheTest) {  // the scenes above do need cuts
  std::uint64_t cuts = 0;
  for (int k = 0; k < 20; ++k) {
    Source s(static_cast<std::uint64_t>(k));
    cuts += sorted(families::triangles(s), GetParam()).cuts;
  }
  EXPECT_GT(cuts, 20u);
}

/// The plain form makes the same tree as the fast one without a choice of root.
TEST(PlainBsp, SortsAsTheFastOneDoesWithTheTextbooksRoot) {
  for_each_scene_of_families(
      200 / kSlower, [](const ItemList& list, const std::string& family, int seed) {
        for (const Precision& precision : {Precision{}, Precision{.exact = false}}) {
          const SortedPieces plain = sorted(list, {"plain", HiddenMethod::plain_bsp}, precision);
          const SortedPieces fast =
              sorted(list, {"fast", HiddenMethod::bsp, RootChoice::last}, precision);
          const auto same = [](const SortedPiece& a, const SortedPiece& b) {
            return a.item == b.item && a.first == b.first && a.sides == b.sides;
          };
          ASSERT_TRUE(std::ranges::equal(plain.pieces, fast.pieces, same)) << family << " " << seed;
          ASSERT_EQ(plain.points, fast.points) << family << " " << seed;
          ASSERT_EQ(plain.visible, fast.visible) << family << " " << seed;
          ASSERT_EQ(plain.cuts, fast.cuts) << family << " " << seed;
          ASSERT_EQ(plain.comparisons, fast.comparisons) << family << " " << seed;
        }
      });
}

// ---- Numbers of cuts ----------------------------------------------------------------------------

const Way& depth_sort() { return ways().back(); }

TEST(DepthSortCuts, NoneInTwoStacks) {
  Source s(1);
  ItemList list;
  std::vector<int> heights(40);
  std::iota(heights.begin(), heights.end(), 0);
  for (std::size_t i = heights.size(); i > 1; --i) {
    std::swap(heights[i - 1], heights[static_cast<std::size_t>(s.below(static_cast<int>(i)))]);
  }
  for (const int h : heights) {
    const double z = h / 64.0, left = h % 2 == 0 ? 0.0 : 0.5;
    list.solid({{left, 0, z}, {left + 0.4, 0, z + 0.001}, {left + 0.4, 1, z}, {left, 1, z}});
  }
  EXPECT_EQ(sorted(list, depth_sort()).cuts, 0u);
  EXPECT_EQ(judged(list, depth_sort(), 1, 40), "");
}

void add_sphere(ItemList& list, const Point3& centre, double radius, int n) {
  const auto at = [&](int i, int j) {
    const double u = std::numbers::pi * i / n, v = 2.0 * std::numbers::pi * j / n;
    return centre + radius * Point3{std::sin(u) * std::cos(v) * 0.8 + std::cos(u) * 0.6,
                                    std::sin(u) * std::sin(v),
                                    std::cos(u) * 0.8 - std::sin(u) * std::cos(v) * 0.6};
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (i > 0) list.solid({at(i, j), at(i + 1, j), at(i, j + 1)});
      if (i < n - 1) list.solid({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
}

TEST(DepthSortCuts, NoneInConvexBodies) {
  ItemList list;
  add_sphere(list, {0.4, 0.5, 0.3}, 0.25, 12);
  add_sphere(list, {0.5, 0.5, 0.8}, 0.2, 10);
  add_sphere(list, {0.6, 0.4, 0.55}, 0.02, 5);
  EXPECT_EQ(sorted(list, depth_sort()).cuts, 0u);
  EXPECT_EQ(judged(list, depth_sort(), 1, 40), "");
}

TEST(DepthSortCuts, OneForTwoThatCross) {
  ItemList list;
  list.solid({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 1}});
  list.solid({{0, 0.1, 0.5}, {1, 0.2, 0.6}, {0.5, 1.1, 0}});
  EXPECT_EQ(sorted(list, depth_sort()).cuts, 1u);
  EXPECT_EQ(judged(list, depth_sort(), 1, 100), "");
}

TEST(DepthSortCuts, NoneForOneThatCrossesThePlaneOnlyBesideTheOther) {
  for (const double side : {0.25, 0.375}) {  // before the crossing, and up to it
    ItemList list;
    list.solid({{0, 0, 0.5}, {side, 0, 0.5}, {side, 0.5, 0.5}, {0, 0.5, 0.5}});
    list.solid(
        {{0.125, 0.125, 0.625}, {1, 0.125, 0.1875}, {1, 0.25, 0.1875}, {0.125, 0.25, 0.625}});
    EXPECT_EQ(sorted(list, depth_sort()).cuts, 0u) << side;
    list.solid({{0.25, 0, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0.5}, {0.25, 0.5, 0.5}});
    EXPECT_EQ(sorted(list, depth_sort()).cuts, 1u) << side;
  }
}

TEST(DepthSortCuts, OneForACycleOfThree) {
  for (const bool over : {true, false}) {
    ItemList list;
    add_ring_of_bars(list, 3, 0.1, over);
    EXPECT_EQ(sorted(list, depth_sort()).cuts, 1u);
    EXPECT_EQ(judged(list, depth_sort(), 1, 200), "");
  }
}

TEST(DepthSortCuts, FewForLongerCycles) {
  for (int n = 4; n <= 40; ++n) {
    ItemList list;
    add_ring_of_bars(list, n, 0.3);
    const SortedPieces pieces = sorted(list, depth_sort());
    EXPECT_GE(pieces.cuts, 1u) << n;
    EXPECT_LE(pieces.cuts, 2u) << n;
  }
}

// ---- Ties and kinds -----------------------------------------------------------------------------

TEST_P(EveryWay, OfCoplanarOnesTheLaterEnteredComesLater) {
  ItemList list;
  for (int k = 0; k < 30; ++k)
    list.solid({{0, 0, 0.25}, {1, 0, 0.5}, {k % 2 * 0.5, 1, 0.25 + k % 2 * 0.125}});
  const SortedPieces pieces = sorted(list, GetParam());
  ASSERT_EQ(pieces.pieces.size(), 30u);
  for (std::uint32_t k = 0; k < 30; ++k) EXPECT_EQ(pieces.pieces[k].item, k);
}

TEST_P(EveryWay, ALineInAPolygonsPlaneComesAfterIt) {
  for (const bool first : {false, true}) {
    ItemList list;
    if (first) list.line({0.1, 0.1, 0.5}, {0.9, 0.8, 0.5});
    list.solid({{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}});
    if (!first) list.line({0.1, 0.1, 0.5}, {0.9, 0.8, 0.5});
    list.solid({{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}});
    const SortedPieces pieces = sorted(list, GetParam());
    ASSERT_EQ(pieces.pieces.size(), 3u);
    EXPECT_EQ(pieces.pieces.back().item, first ? 0u : 1u);
  }
}

TEST_P(EveryWay, ALineWhereTwoPolygonsMeetComesAfterBoth) {
  for (int order = 0; order < 6; ++order) {  // in every order of entry
    std::vector<int> entered = {0, 1, 2};
    for (int k = 0; k < order; ++k) std::ranges::next_permutation(entered);
    ItemList list;
    for (const int k : entered) {
      if (k == 0) list.solid({{0, 0, 0}, {1, 0, 1}, {1, 1, 1}, {0, 1, 0}});
      if (k == 1) list.solid({{0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}});
      if (k == 2) list.line({0.5, 0.25, 0.5}, {0.5, 0.75, 0.5});
    }
    const SortedPieces pieces = sorted(list, GetParam());
    EXPECT_EQ(SortJudge(list, pieces).lines_at(0.3), "") << "order " << order;
  }
}

TEST_P(EveryWay, ALineAtTheFootOfAWallComesAfterTheWall) {
  ItemList list;
  list.line({0.1, 0.5, 0.5}, {0.9, 0.5, 0.5});
  list.solid({{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}});  // the floor
  list.solid({{0, 0.5, 0.5}, {1, 0.5, 0.5}, {1, 0.75, 0.75}, {0, 0.75, 0.75}});
  EXPECT_EQ(SortJudge(list, sorted(list, GetParam())).lines_at(0.4), "");
}

// ---- Roundoff -----------------------------------------------------------------------------------

TEST_P(EveryWay, RoundoffLosesNothing) {
  for (const SortFamily& family : sort_families()) {
    for (int k = 0; k < 40 / std::min(kSlower, 5); ++k) {
      for (const double roundoff : {0.0, 1e-12, 1e-9, 1e-3}) {
        Source s(static_cast<std::uint64_t>(k));
        const ItemList list = family.make(s);
        const Precision precision{.exact = false, .roundoff = roundoff};
        const SortedPieces pieces = sorted(list, GetParam(), precision);
        const SortJudge judge(list, pieces);
        ASSERT_EQ(judge.items(), "") << family.name << ", seed " << k << "\n" << list.text();
        // With ROUNDOFF 0 a polygon that is in a plane up to rounding is cut anywhere.
        if (!family.flat || roundoff == 0.0) continue;
        ASSERT_EQ(judge.areas(1e-9 + 20.0 * roundoff), "")
            << family.name << ", seed " << k << ", ROUNDOFF " << roundoff << "\n"
            << list.text();
        ASSERT_EQ(judge.outlines(1e-9 + 20.0 * roundoff), "")
            << family.name << ", seed " << k << ", ROUNDOFF " << roundoff << "\n"
            << list.text();
      }
    }
  }
}

TEST_P(EveryWay, RoundoffIsRightWhereNothingIsClose) {
  for (int k = 0; k < 60 / kSlower; ++k) {
    Source s(static_cast<std::uint64_t>(k));
    ItemList list;
    for (int n = s.between(3, 12); n > 0; --n) {
      const Slope slope{static_cast<double>(n) + 0.1 * s.unit(), 0.2 * s.unit(), 0.2 * s.unit()};
      list.solid(s.below(2) == 0 ? star_shaped(s, slope, 7) : convex(s, slope, 4));
    }
    const SortedPieces pieces = sorted(list, GetParam(), {.exact = false});
    const SortJudge judge(list, pieces);
    for (int m = 0; m < 20; ++m) {
      ASSERT_EQ(judge.order_at(any_sample(s), 1e-6), "") << k << "\n" << list.text();
    }
  }
}

}  // namespace
}  // namespace displayfile
