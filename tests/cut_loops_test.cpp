// Long loops in parts: disjoint, their union unchanged, with the same vertices on sides that are
// shared (interp/vector/cut_loops.h).

#include "interp/vector/cut_loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <span>
#include <vector>

#include "interp/vector/lattice_loops.h"

namespace displayfile {
namespace {

/// Those that lie there an odd number of times.
std::set<LatticeSide> odd_sides(const std::vector<LatticeLoops>& all) {
  std::set<LatticeSide> odd;
  for (const LatticeLoops& loops : all) {
    for_each_side(loops, [&](const LatticePoint& from, const LatticePoint& to) {
      const LatticeSide side(from, to);
      if (!odd.erase(side)) odd.insert(side);
    });
  }
  return odd;
}

struct Box {
  LatticePoint low, high;
};
Box box_of(const LatticeLoops& loops) {
  Box box{loops.points[0], loops.points[0]};
  for (const LatticePoint& p : loops.points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

void expect_parts(const LatticeLoops& loops, std::size_t most) {
  VerticesOnSides put;
  std::vector<LatticeLoops> parts = parts_of(loops, most, put);
  for (const LatticeLoops& part : parts) EXPECT_LE(part.points.size(), most);
  // Cuts run along columns and rows, so that parts lie in rectangles of their own.
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Box a = box_of(parts[i]);
    for (std::size_t j = 0; j < i; ++j) {
      const Box b = box_of(parts[j]);
      EXPECT_TRUE(a.high.x <= b.low.x || b.high.x <= a.low.x || a.high.y <= b.low.y ||
                  b.high.y <= a.low.y);
    }
  }
  LatticeLoops with = loops;
  put_vertices(with, put);
  for (LatticeLoops& part : parts) put_vertices(part, put);
  // Common parts cancel, and the loops are unchanged otherwise.
  EXPECT_EQ(odd_sides(parts), odd_sides({with}));
}

std::vector<std::span<const LatticePoint>> each_loop(const LatticeLoops& loops) {
  std::vector<std::span<const LatticePoint>> each;
  for (std::size_t k = 0; k < loops.size(); ++k) each.push_back(loops.loop(k));
  return each;
}

LatticeLoops random_loops(std::mt19937& random, int loops, int vertices, std::int32_t size) {
  LatticeLoops all;
  for (int k = 0; k < loops; ++k) {
    std::vector<LatticePoint> loop;
    for (int i = 0; i < vertices; ++i) {
      const auto at = [&] {
        return static_cast<std::int32_t>(random() % static_cast<unsigned>(size));
      };
      const std::int32_t x = at();
      loop.push_back({x, at()});
    }
    all.add(loop);
  }
  return boundary_of(each_loop(all));
}

/// Sides that leave a vertex in one direction, one upon another, are paired in the order of their
/// lengths, however a library sorts equals: triangles that share two vertices are joined in twos.
TEST(LatticeLoops, SidesUponEachOtherArePairedByLength) {
  constexpr std::int32_t kTriangles = 20;
  std::vector<std::vector<LatticePoint>> triangles;
  for (std::int32_t k = 1; k <= kTriangles; ++k) triangles.push_back({{0, 0}, {k, 0}, {0, 1}});
  const std::vector<std::span<const LatticePoint>> spans(triangles.begin(), triangles.end());
  const LatticeLoops boundary = boundary_of(spans);
  ASSERT_EQ(boundary.size(), std::size_t{kTriangles / 2});
  for (std::size_t i = 0; i < boundary.size(); ++i) EXPECT_EQ(boundary.loop(i).size(), 4u);
}

/// By the even-odd rule; x and y in thousandths of a unit, on no vertex's row.
bool covers(const LatticeLoops& loops, std::int64_t x, std::int64_t y) {
  bool inside = false;
  for_each_side(loops, [&](const LatticePoint& from, const LatticePoint& to) {
    const auto [low, high] = std::minmax(
        from, to, [](const LatticePoint& p, const LatticePoint& q) { return p.y < q.y; });
    if (1000 * std::int64_t{low.y} > y || 1000 * std::int64_t{high.y} < y) return;
    const std::int64_t turned = (high.x - low.x) * (y - 1000 * std::int64_t{low.y}) -
                                (high.y - low.y) * (x - 1000 * std::int64_t{low.x});
    if (turned > 0) inside = !inside;
  });
  return inside;
}

/// In line, with more than a point in common.
bool lie_upon_each_other(const LatticeSide& p, const LatticeSide& q) {
  const auto beside = [&](const LatticePoint& v) {
    return (p.b.x - p.a.x) * (v.y - p.a.y) - (p.b.y - p.a.y) * (v.x - p.a.x);
  };
  return beside(q.a) == 0 && beside(q.b) == 0 && std::max(p.a, q.a) < std::min(p.b, q.b);
}

/// On the least lattices, where many sides do lie upon each other in part.
TEST(LatticeLoops, AnOutlineCoversTheSameWithoutSidesUponEachOtherOrStraightVertices) {
  std::mt19937 random(8);
  int upon_each_other = 0;
  for (int run = 0; run < 200; ++run) {
    const LatticeLoops loops = random_loops(random, 1 + run % 5, 3 + run % 7, 3 + run % 4);
    LatticeLoops outline = outline_of(each_loop(loops));
    const auto sides_upon_each_other = [](const LatticeLoops& of) {
      const std::set<LatticeSide> sides = odd_sides({of});
      EXPECT_EQ(sides.size(), of.points.size());  // each once
      int pairs = 0;
      for (const LatticeSide& p : sides) {
        for (const LatticeSide& q : sides) pairs += p < q && lie_upon_each_other(p, q) ? 1 : 0;
      }
      return pairs;
    };
    upon_each_other += sides_upon_each_other(loops);
    EXPECT_EQ(sides_upon_each_other(outline), 0);
    for (int y = 0; y < 7; ++y) {
      for (int x = 0; x < 7; ++x) {
        EXPECT_EQ(covers(outline, 1000 * x + 377, 1000 * y + 619),
                  covers(loops, 1000 * x + 377, 1000 * y + 619));
      }
    }
    const std::vector<LatticePoint> points = outline.points;
    LatticeLoops* const alone = &outline;
    drop_straight_vertices(std::span(&alone, 1));
    EXPECT_EQ(outline.points, points);
  }
  EXPECT_GT(upon_each_other, 100);
}

/// Loops that cross each other and themselves, and the smallest lattices: all worse than real
/// input.
TEST(CutLoops, PartsAreDisjointAndTogetherWhatThereWas) {
  std::mt19937 random(5);
  for (int run = 0; run < 300; ++run) {
    const auto size = static_cast<std::int32_t>(2 + random() % (run % 3 == 0 ? 6 : 5000));
    const LatticeLoops loops = random_loops(random, 1 + run % 7, 3 + run % 19, size);
    for (const std::size_t most : {8u, 20u, 50u}) expect_parts(loops, most);
  }
}

TEST(CutLoops, WhatIsShortIsLeftAsItIs) {
  LatticeLoops loops;
  loops.add(std::array{LatticePoint{0, 0}, LatticePoint{5, 0}, LatticePoint{0, 5}});
  VerticesOnSides put;
  const std::vector<LatticeLoops> parts = parts_of(loops, 8, put);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].points, loops.points);
  EXPECT_TRUE(put.empty());
}

/// A side of a neighbour is cut where it is, whichever way it is run along.
TEST(CutLoops, ACutPutsTheVertexNearestToWhereASideCrosses) {
  LatticeLoops comb;  // ten teeth: sides from (0, y) to (90, y + 3)
  std::vector<LatticePoint> loop{{0, 1000}, {-5, 0}};
  for (std::int32_t y = 0; y < 100; y += 10) {
    loop.push_back({0, y});
    loop.push_back({91, y + 3});
    loop.push_back({0, y + 5});
  }
  comb.add(loop);
  VerticesOnSides put;
  const std::vector<LatticeLoops> parts = parts_of(comb, 16, put);
  EXPECT_GE(parts.size(), 2u);
  for (const auto& [side, vertex] : put) {
    const double across = side.b.x - side.a.x, up = side.b.y - side.a.y;
    const double height = (vertex.x - side.a.x) * up - (vertex.y - side.a.y) * across;
    EXPECT_LE(std::abs(height), 0.5 * std::max(std::abs(across), std::abs(up)));
  }
}

/// Differences of 31 bits.
TEST(CutLoops, TheLargestCoordinatesAreCut) {
  const std::int32_t far = 1'000'000'000;
  std::vector<LatticePoint> loop;
  for (std::int32_t k = 0; k < 12; ++k) {
    loop.push_back({-far + k, k % 2 == 0 ? -far : far - k});
    loop.push_back({far - k, k % 3 == 0 ? far : -far + k});
  }
  LatticeLoops loops;
  loops.add(loop);
  expect_parts(boundary_of(std::array{std::span<const LatticePoint>(loops.loop(0))}), 8);
}

}  // namespace
}  // namespace displayfile
