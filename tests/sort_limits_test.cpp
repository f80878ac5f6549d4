// The object-space sorts at their limits: nothing, degenerate, very many, coordinates of any size,
// and on several threads.

#include "hidden/sort/hidden_surface_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>

#include "clip/base/error.h"
#include "tests/error_of.h"
#include "tests/every_way.h"
#include "tests/from_environment.h"

namespace displayfile {
namespace {

using namespace test;

/// The largest scenes are that much larger with DISPLAYFILE_LARGER=10, or any other number.
int larger(int size) { return size * std::max(1, from_environment("DISPLAYFILE_LARGER", 1)); }

// ---- Bad input and scale ------------------------------------------------------------------------

TEST_P(EveryWay, NothingAtAll) {
  const SortedPieces pieces = sorted({}, GetParam());
  EXPECT_TRUE(pieces.pieces.empty());
  EXPECT_EQ(pieces.cuts, 0u);
}

TEST(SortLimits, MorePiecesThanAllowedNameTheMap) {
  ItemList list;
  for (int k = 0; k < 8; ++k) {
    const double u = 0.1 * k;
    list.solid({{0, 0, u}, {1, 0, 1 - u}, {1, 1, u}});
    list.solid({{0, 1, 1 - u}, {1, 0.1 * u, u}, {0.5 * u, 0, 1 - u}});
  }
  for (const HiddenMethod method : {HiddenMethod::bsp, HiddenMethod::depth_sort}) {
    SurfacePlan options;
    const std::size_t pieces = sort_hidden_surfaces(list.view(), options.by(method)).pieces.size();
    ASSERT_GT(pieces, list.items.size() + 4);
    options.most_pieces = list.items.size() + 2;
    const std::string error =
        error_of([&] { sort_hidden_surfaces(list.view(), options.by(method)); });
    EXPECT_NE(error.find("more than 18 pieces: expected hidden-surface method map"), error.npos)
        << error;
    options.most_pieces = 1;  // polygons that are not cut are allowed
    ItemList apart;
    apart.solid({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    apart.solid({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}});
    EXPECT_EQ(sort_hidden_surfaces(apart.view(), options.by(method)).pieces.size(), 2u);
  }
}

TEST_P(EveryWay, AllDegenerate) {
  ItemList list;
  const Point3 p{0.5, 0.25, 0.125}, q{0.75, 0.5, 1};
  for (const auto kind : {ItemList::Kind::solid, ItemList::Kind::hollow}) {
    for (const Loop& loop :
         {Loop{}, Loop{p}, Loop{p, q}, Loop{p, p, p}, Loop{p, q, p}, Loop{p, q, 0.5 * (p + q)},
          Loop{p, p, q, q, p}, Loop{{0, 0, 0}, {0, 0, 1}, {1, 1, 1}, {1, 1, 0}}}) {
      list.add(kind, loop);
      list.add(kind, loop, std::vector<std::uint8_t>(loop.size(), 0));
    }
  }
  list.line(p, p);
  const SortJudge judge(list, sorted(list, GetParam()));
  EXPECT_EQ(judge.items(), "");
  EXPECT_EQ(judge.outlines(), "");
  list.solid({{0, 0, 0.5}, {1, 0, 0.5}, {0.5, 1, 0.75}});
  const SortJudge with_one(list, sorted(list, GetParam()));
  EXPECT_EQ(with_one.items(), "");
  EXPECT_EQ(with_one.outlines(), "");
  EXPECT_EQ(with_one.lines_at(0.3), "");
}

TEST_P(EveryWay, ManyCoincident) {
  const int n = larger(100000) / (kSlower * kSlower);
  ItemList list;
  for (int k = 0; k < n; ++k) list.solid({{0, 0, 0.25}, {1, 0, 0.5}, {0.5, 1, 0.25}});
  const SortedPieces pieces = sorted(list, GetParam());
  EXPECT_EQ(pieces.cuts, 0u);
  ASSERT_EQ(pieces.pieces.size(), static_cast<std::size_t>(n));
  for (std::uint32_t k = 0; k < pieces.pieces.size(); ++k) {
    ASSERT_EQ(pieces.pieces[k].item, k);
    ASSERT_EQ(pieces.pieces[k].first, SortedPiece::kWhole);
  }
}

TEST_P(EveryWay, ADeepStackOfSheets) {
  const bool chain = GetParam().is_chain();
  const int n = (chain ? 4000 : larger(200000)) / (kSlower * (chain ? 1 : kSlower));
  ItemList list;
  for (int k = 0; k < n; ++k) {
    const double z = static_cast<double>(std::int64_t{k} * 7919 % n) * 0x1p-20;
    list.solid({{0, 0, z}, {1, 0, z}, {0.5, 1, z}});
  }
  const SortedPieces pieces = sorted(list, GetParam());
  EXPECT_EQ(pieces.cuts, 0u);
  ASSERT_EQ(pieces.pieces.size(), static_cast<std::size_t>(n));
  double z = -1.0;
  for (const SortedPiece& piece : pieces.pieces) {
    const double next = list.points_of(piece.item)[0].z;
    ASSERT_GT(next, z);
    z = next;
  }
}

TEST_P(EveryWay, AChainAsDeepAsItsPolygonsAreMany) {  // entered in order: nothing to balance
  const bool chain = GetParam().is_chain();
  const int n = (chain ? 4000 : larger(50000)) / (kSlower * (chain ? 1 : kSlower));
  ItemList list;
  for (int k = 0; k < n; ++k) {
    const double z = k * 0x1p-20, x = 1e-7 * k;
    list.solid({{x, 0, z}, {x + 0.5, 0, z}, {x + 0.25, 1, z}});
  }
  const SortedPieces pieces = sorted(list, GetParam());
  ASSERT_EQ(pieces.pieces.size(), static_cast<std::size_t>(n));
  for (std::uint32_t k = 0; k < pieces.pieces.size(); ++k) ASSERT_EQ(pieces.pieces[k].item, k);
  if (chain) {
    EXPECT_EQ(pieces.depth, static_cast<std::uint32_t>(n));
  }
}

/// Teeth between x = 0 and 1, in the plane.
Loop comb(int teeth, const Slope& slope, double y0, double y1) {
  Loop loop;
  const double step = (y1 - y0) / (2.0 * teeth);
  for (int k = 0; k < teeth; ++k) {
    const double y = y0 + 2.0 * k * step;
    loop.push_back(slope.at(0.9, y));
    loop.push_back(slope.at(0.9, y + step));
    loop.push_back(slope.at(0.1, y + step));
    loop.push_back(slope.at(0.1, y + 2.0 * step));
  }
  loop.push_back(slope.at(0.0, y1));
  loop.push_back(slope.at(0.0, y0));
  return loop;
}

TEST_P(EveryWay, PolygonsOfManySides) {
  const int teeth = larger(25000) / kSlower;
  ItemList list;
  list.solid(comb(teeth, {0.0, 1.0, 0.0}, 0.0, 1.0));
  list.solid(comb(teeth, {0.5, 0.0, 0.0}, 0.001, 0.999));
  list.solid({{0.2, 0.2, 0.1}, {0.8, 0.2, 0.9}, {0.5, 0.8, 0.5}});
  const SortedPieces pieces = sorted(list, GetParam());
  const SortJudge judge(list, pieces);
  EXPECT_GE(pieces.cuts, 1u);
  EXPECT_EQ(judge.items(), "");
  EXPECT_EQ(judge.areas(1e-9), "");
  EXPECT_EQ(judge.outlines(1e-6), "");
  Source s(1);
  for (int k = 0; k < 20; ++k) ASSERT_EQ(judge.order_at(any_sample(s)), "");
}

/// The scene with each coordinate multiplied by a power of two, sorted; and put back.
SortedPieces sorted_at_scale(const ItemList& list, const Way& way, int xy, int z) {
  const auto scaled_by = [](Loop& points, int x_y, int of_z) {
    for (Point3& p : points) {
      p = {std::ldexp(p.x, x_y), std::ldexp(p.y, x_y), std::ldexp(p.z, of_z)};
    }
  };
  ItemList there = list;
  scaled_by(there.points, xy, z);
  SortedPieces pieces = sorted(there, way);
  scaled_by(pieces.points, -xy, -z);
  return pieces;
}

TEST_P(EveryWay, CoordinatesOfAnySize) {
  for (const SortFamily& family : sort_families()) {
    for (int k = 0; k < 15 / std::min(kSlower, 5); ++k) {
      Source s(static_cast<std::uint64_t>(500 + k));
      ItemList list = family.make(s);
      // z of few digits, so that it stays exact among the smallest doubles.
      for (Point3& p : list.points) p.z = std::round(64.0 * p.z);
      for (const auto& [xy, z] :
           {std::pair{298, 290}, {0, 290}, {-200, 0}, {0, -1074}, {298, -1074}}) {
        const SortedPieces pieces = sorted_at_scale(list, GetParam(), xy, z);
        const SortJudge judge(list, pieces);
        ASSERT_EQ(judge.items(), "") << family.name << " at 2^" << xy << "\n" << list.text();
        Source places(1);
        for (int m = 0; m < 10; ++m) {
          ASSERT_EQ(judge.order_at(any_sample(places)), "")
              << family.name << " at 2^" << xy << ", 2^" << z << "\n"
              << list.text();
        }
      }
    }
  }
}

TEST(HiddenSurfaceSort, OtherMethodsAreAnError) {
  EXPECT_THROW(sort_hidden_surfaces({}, {.method = HiddenMethod::z_buffer}), Error);
  EXPECT_THROW(sort_hidden_surfaces({}, {.method = HiddenMethod::none}), Error);
}

// ---- Threads ------------------------------------------------------------------------------------

void expect_same(const SortedPieces& a, const SortedPieces& b) {
  ASSERT_EQ(a.pieces.size(), b.pieces.size());
  for (std::size_t i = 0; i < a.pieces.size(); ++i) {
    ASSERT_EQ(a.pieces[i].item, b.pieces[i].item) << i;
    ASSERT_EQ(a.pieces[i].first, b.pieces[i].first) << i;
    ASSERT_EQ(a.pieces[i].sides, b.pieces[i].sides) << i;
  }
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.visible, b.visible);
  EXPECT_EQ(a.cuts, b.cuts);
  EXPECT_EQ(a.depth, b.depth);
}

/// Small triangles, bars and lines all over, a few of them through others.
ItemList scattered(int n) {
  Source s(3);
  ItemList list;
  for (int k = 0; k < n; ++k) {
    const Point3 at = in_cube(s);
    const auto near = [&] { return at + 0.03 * in_cube(s); };
    const Point3 a = near(), b = near(), c = near();
    if (k % 7 == 0) {
      list.line(a, b);
    } else {
      list.solid({a, b, c});
    }
  }
  add_ring_of_bars(list, 12);
  return list;
}

TEST_P(EveryWay, ThreadsDoNotChangeTheResult) {
  const ItemList list = scattered(12000 / kSlower);
  for (const bool exact : {true, false}) {
    const Precision precision{.exact = exact};
    expect_same(sorted(list, GetParam(), precision, 1), sorted(list, GetParam(), precision, 4));
  }
}

TEST_P(EveryWay, ThousandsOfItemsInOrder) {
  const ItemList list = scattered(12000 / kSlower);
  const SortedPieces pieces = sorted(list, GetParam());
  const SortJudge judge(list, pieces);
  EXPECT_EQ(judge.items(), "");
  EXPECT_EQ(judge.areas(1e-12), "");
  EXPECT_EQ(judge.outlines(), "");
  Source s(9);
  for (int k = 0; k < 60; ++k) ASSERT_EQ(judge.order_at(any_sample(s)), "");
}

}  // namespace
}  // namespace displayfile
