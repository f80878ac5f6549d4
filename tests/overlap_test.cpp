// The search for depth sort's pairs: extents, their index, and the test for overlap in the
// projection. Judged by rationals and by comparing all pairs.

#include "hidden/sort/overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "hidden/boxes/extents.h"
#include "tests/sort_truth.h"

namespace displayfile {
namespace {

using namespace test;

// ---- Extents ------------------------------------------------------------------------------------

TEST(Extents, FloatsAreRoundedOutward) {
  Source s(1);
  const double denormal = std::numeric_limits<double>::denorm_min();
  std::vector<double> values = {0.0,    denormal, -denormal, 1e-40, -1e-40, 1e38,
                                3.5e38, -3.5e38,  1e90,      -1e90, 1e100,  -1e100};
  for (int k = 0; k < 1000; ++k) values.push_back(std::ldexp(s.unit() - 0.5, s.between(-160, 140)));
  for (const double v : values) {
    Extent e = Extent::nothing();
    e.include(Point3{v, -v, v});
    EXPECT_LE(double{e.x_min}, v);
    EXPECT_GE(double{e.x_max}, v);
    EXPECT_LE(double{e.y_min}, -v);
    EXPECT_GE(double{e.y_max}, -v);
    EXPECT_LE(double{e.z_min}, v);
    EXPECT_GE(double{e.z_max}, v);
    // No wider than it must be.
    if (std::abs(v) < 3e38 && std::abs(v) > 1e-37) {
      EXPECT_LE(double{e.x_max} - double{e.x_min}, 0x1p-22 * std::abs(v));
    }
  }
}

TEST(Extents, ARadiusIsTakenIn) {
  Extent e = Extent::nothing();
  e.include(Point3{1.0, 2.0, 3.0}, 0.25);
  EXPECT_LE(e.x_min, 0.75f);
  EXPECT_GE(e.x_max, 1.25f);
  EXPECT_LE(e.z_min, 2.75f);
  EXPECT_GE(e.z_max, 3.25f);
  e.include(Point3{0.0}, std::numeric_limits<double>::infinity());  // nothing is known about it
  EXPECT_LE(double{e.y_min}, -1e100);
  EXPECT_GE(double{e.y_max}, 1e100);
}

TEST(Extents, NothingMeetsNothing) {
  Extent all = Extent::nothing();
  all.include(Point3{-1e30});
  all.include(Point3{1e30});
  EXPECT_FALSE(Extent::nothing().meets_in_projection(all));
  EXPECT_FALSE(all.meets_in_projection(Extent::nothing()));
  EXPECT_TRUE(all.meets_in_projection(all));
  Extent left = Extent::nothing(), right = Extent::nothing();
  left.include(Point3{0.0});
  left.include(Point3{1.0});
  right.include(Point3{1.0});
  right.include(Point3{2.0});
  EXPECT_TRUE(left.meets_in_projection(right)) << "touching";
}

using Pairs = std::multiset<std::pair<std::uint32_t, std::uint32_t>>;

Pairs all_pairs(const std::vector<Extent>& extents) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < extents.size(); ++i) {
    for (std::uint32_t j = i + 1; j < extents.size(); ++j) {
      if (extents[i].meets_in_projection(extents[j])) pairs.emplace(i, j);
    }
  }
  return pairs;
}
Pairs indexed_pairs(const std::vector<Extent>& extents, std::uint32_t parts) {
  const ExtentTree index = extent_tree(extents, 2);
  Pairs pairs;
  for (std::uint32_t k = 0; k < parts; ++k) {
    index.pairs(index.leaves() * k / parts, index.leaves() * (k + 1) / parts,
                [&](std::uint32_t p, std::uint32_t q) {
                  EXPECT_LT(p, q);
                  pairs.insert(std::minmax({index.order()[p], index.order()[q]}));
                });
  }
  return pairs;
}

TEST(ExtentTreeTest, FindsEachPairThatMeetsOnce) {
  Source s(2);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Extent> extents;
    const int grid = s.below(3) == 0 ? 6 : 1000;
    const double size = s.below(2) == 0 ? 0.05 : 0.5;
    for (int n = s.between(0, 120); n > 0; --n) {
      Extent e = Extent::nothing();
      if (s.below(12) != 0) {  // now and then one that is nothing, or everything
        const Point3 at = on_grid(s, grid, 4);
        e.include(at);
        e.include(at + size * on_grid(s, grid, 4));
        if (s.below(20) == 0) e.include(at, std::numeric_limits<double>::infinity());
      }
      extents.push_back(e);
    }
    const Pairs expected = all_pairs(extents);
    EXPECT_EQ(indexed_pairs(extents, 1), expected);
    EXPECT_EQ(indexed_pairs(extents, 3), expected);
  }
}

TEST(ExtentTreeTest, AllInOnePlace) {
  std::vector<Extent> extents(100, Extent::nothing());
  for (Extent& e : extents) e.include(Point3{0.5});
  EXPECT_EQ(indexed_pairs(extents, 1).size(), 100u * 99 / 2);
}

TEST(ExtentTreeTest, BoxesThatHoldEverythingAreNotMissed) {
  std::vector<Extent> extents(300, Extent::nothing());
  for (std::size_t i = 0; i < extents.size(); ++i) {
    extents[i].include(Point3{static_cast<double>(i), 0.0, 0.0},
                       i % 3 == 0 ? std::numeric_limits<double>::infinity() : 0.0);
  }
  EXPECT_EQ(indexed_pairs(extents, 1), all_pairs(extents));
}

/// The tree's order by its definition, with sorts in place of nth_element: the lower half first,
/// whole nodes of it, and leaves in order of entry.
void put_in_order(std::span<const FlatBox> boxes, std::span<std::uint32_t> part) {
  constexpr std::size_t kNode = 8;
  if (part.size() <= kNode) {
    std::ranges::sort(part);
    return;
  }
  const auto position = [&](std::uint32_t i, std::size_t axis) { return boxes[i].position(axis); };
  const auto spread = [&](std::size_t axis) {
    auto low = position(part[0], axis), high = low;
    for (const std::uint32_t i : part) {
      low = std::min(low, position(i, axis));
      high = std::max(high, position(i, axis));
    }
    return high - low;
  };
  const std::size_t axis = spread(1) > spread(0) ? 1 : 0;
  std::ranges::sort(part, {}, [&](std::uint32_t i) { return std::pair(position(i, axis), i); });
  const std::size_t nodes = (part.size() / 2 + kNode - 1) / kNode;
  const std::size_t half = kNode * nodes < part.size() ? kNode * nodes : part.size() / 2;
  put_in_order(boxes, part.first(half));
  put_in_order(boxes, part.subspan(half));
}

TEST(ExtentTreeTest, TheOrderIsAFunctionOfTheBoxesAlone) {
  Source s(11);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<FlatBox> boxes;
    const int grid = s.below(2) == 0 ? 6 : 1000;
    for (int count = s.between(0, s.below(20) == 0 ? 5000 : 400); count > 0; --count) {
      Extent e = Extent::nothing();
      const Point3 at = on_grid(s, grid, 4);
      e.include(at);
      e.include(at + 0.1 * on_grid(s, grid, 4));
      boxes.push_back(FlatBox::of(e));
    }
    std::vector<std::uint32_t> expected(boxes.size());
    std::iota(expected.begin(), expected.end(), 0u);
    put_in_order(boxes, expected);
    for (const int threads : {1, 2}) {
      ExtentTree tree;
      tree.build(boxes, threads);
      EXPECT_TRUE(std::ranges::equal(tree.order(), expected)) << trial;
    }
  }
}

// ---- Polygons in the projection -----------------------------------------------------------------

/// The points of some polygons as vertices, and their outlines.
template <class Policy>
class Flat {
 public:
  explicit Flat(const std::vector<Loop>& loops, const Policy& policy)
      : points_(joined(loops)), numbers_(points_.size()), table_(points_, {}, policy) {
    std::iota(numbers_.begin(), numbers_.end(), 0u);
    std::size_t first = 0;
    for (const Loop& loop : loops) {
      const std::span<const std::uint32_t> v = std::span(numbers_).subspan(first, loop.size());
      outlines_.push_back({v, v.size() == 2 ? 0 : convex_turning(table_, v)});
      first += loop.size();
    }
  }
  int turning(std::size_t i) const { return outlines_[i].turning; }
  bool overlap(std::size_t i, std::size_t j) const {
    const bool plain = overlap_in_projection(table_, outlines_[i], outlines_[j]);
    ComparedOutline a(table_, outlines_[i]), b(table_, outlines_[j]);
    a.find_hull_sides(table_);
    b.find_hull_sides(table_);
    EXPECT_EQ(overlap_in_projection(table_, a, b), plain) << "by the sides on the hull";
    return plain;
  }

 private:
  static std::vector<Point3> joined(const std::vector<Loop>& loops) {
    std::vector<Point3> all;
    for (const Loop& loop : loops) all.insert(all.end(), loop.begin(), loop.end());
    return all;
  }
  std::vector<Point3> points_;
  std::vector<std::uint32_t> numbers_;
  VertexTable<Policy> table_;
  std::vector<Outline> outlines_;
};
Flat<Exact> flat(const std::vector<Loop>& loops) { return Flat<Exact>(loops, Exact({})); }

Loop level(const std::vector<Point2>& corners) {
  Loop loop;
  for (const Point2& p : corners) loop.push_back({p.x, p.y, 0.0});
  return loop;
}
Loop reversed(Loop loop) {
  std::ranges::reverse(loop);
  return loop;
}

TEST(ConvexTurning, SolvedCases) {
  const struct {
    Loop loop;
    int turning;
  } cases[] = {
      {level({{0, 0}, {1, 0}, {0, 1}}), 1},
      {level({{0, 0}, {1, 0}, {2, 0}}), 0},  // in line
      {level({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), 1},
      {level({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}), 1},          // a corner of 180 degrees
      {level({{0, 0}, {0.5, 0}, {0.5, 0}, {1, 1}}), 0},              // repeated
      {level({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}), 0},              // concave
      {level({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), 0},                  // a bow tie
      {level({{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}}), 0},      // a pentagram
      {level({{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 0}, {1, 1}}), 0},  // twice round
      {level({{0, 0}, {1, 0}, {2, 0}, {1, 0}}), 0},                  // there and back
      {level({{0, 0}, {3, 0}, {1, 0}, {1, 2}}), 0},                  // a spike
      {level({{0, 0}, {1, 1}, {2, 2}, {1, 1}}), 0},
      {level({{1, 0}, {2, 0}, {3, 1}, {3, 2}, {2, 3}, {1, 3}, {0, 2}, {0, 1}}), 1},
  };
  for (const auto& c : cases) {
    for (std::size_t first = 0; first < c.loop.size(); ++first) {
      Loop loop = c.loop;
      std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
      EXPECT_EQ(flat({loop}).turning(0), c.turning) << loop.size() << " begun at " << first;
      EXPECT_EQ(flat({reversed(loop)}).turning(0), -c.turning) << loop.size();
    }
  }
}

/// By definition: simple, and no vertex on the wrong side of any side.
int turning_by_definition(const Loop& loop) {
  int turning = 0;
  const std::size_t n = loop.size();
  std::vector<QPoint> p;
  for (const Point3& v : loop) p.push_back(rational(v));
  for (std::size_t i = 0; i < n; ++i) {
    const QPoint &a = p[i], &b = p[(i + 1) % n];
    if (a.x == b.x && a.y == b.y) return 0;
    for (std::size_t k = 0; k < n; ++k) {
      const int t = sgn(turn(a, b, p[k]));
      if (t != 0 && turning == -t) return 0;
      if (t != 0) turning = t;
    }
  }
  // Once around: the triangles from the first vertex sum to the area without going over it twice.
  // (A polygon that goes round its hull twice, or back along a side, repeats a point.)
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = i + 1; k < n; ++k) {
      if (p[i].x == p[k].x && p[i].y == p[k].y) return 0;
    }
    const QPoint &a = p[i], &b = p[(i + 1) % n], &c = p[(i + 2) % n];
    const Q along = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
    if (turn(a, b, c) == 0 && along <= 0) return 0;
  }
  return turning;
}

TEST(ConvexTurning, AgreesWithTheDefinition) {
  Source s(4);
  int convex_ones = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    Loop loop;
    const int grid = s.between(2, 4);
    for (int n = s.between(3, 6); n > 0; --n) loop.push_back(on_grid(s, grid, 1));
    const int expected = turning_by_definition(loop);
    convex_ones += expected != 0 ? 1 : 0;
    ItemList list;
    list.solid(loop);
    ASSERT_EQ(flat({loop}).turning(0), expected) << list.text();
  }
  EXPECT_GT(convex_ones, 1000);
}

/// The part of `a` that is left of the line from p to q.
std::vector<QPoint> clipped(const std::vector<QPoint>& a, const QPoint& p, const QPoint& q) {
  std::vector<QPoint> kept;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const QPoint &from = a[k], &to = a[(k + 1) % a.size()];
    const Q at_from = turn(p, q, from), at_to = turn(p, q, to);
    if (at_from >= 0) kept.push_back(from);
    if (sgn(at_from) * sgn(at_to) < 0)
      kept.push_back(from + at_from / (at_from - at_to) * (to - from));
  }
  return kept;
}

/// True if the insides of two convex polygons meet; with `touching`, if the polygons meet at all.
bool meet_in_truth(const Loop& a, const Loop& b, int turning_of_b, bool touching) {
  std::vector<QPoint> part;
  for (const Point3& p : a) part.push_back(rational(p));
  for (std::size_t k = 0; k < b.size() && !part.empty(); ++k) {
    const QPoint from = rational(b[k]), to = rational(b[(k + 1) % b.size()]);
    part = turning_of_b > 0 ? clipped(part, from, to) : clipped(part, to, from);
  }
  return touching ? !part.empty() : twice_area(part) != 0;
}

TEST(OverlapInProjection, OfConvexPolygonsIsTheTruth) {
  Source s(5);
  std::array<int, 2> seen{};
  for (int trial = 0; trial < 6000; ++trial) {
    const bool grid = s.below(2) == 0;
    const auto polygon = [&] {
      if (!grid) return convex(s, {0.0}, s.between(3, 7));
      Loop loop;
      do {
        loop.clear();
        for (int n = s.between(3, 4); n > 0; --n) loop.push_back(on_grid(s, 5, 2));
      } while (turning_by_definition(loop) == 0);
      return loop;
    };
    const Loop a = polygon(), b = polygon();
    const Flat<Exact> both = flat({a, b});
    const bool expected = meet_in_truth(a, b, both.turning(1), false);
    ++seen[expected ? 1 : 0];
    ItemList list;
    list.solid(a);
    list.solid(b);
    ASSERT_EQ(both.overlap(0, 1), expected) << list.text();
    ASSERT_EQ(both.overlap(1, 0), expected) << list.text();
  }
  EXPECT_GT(std::min(seen[0], seen[1]), 1000);
}

TEST(OverlapInProjection, OfALineAndAConvexPolygonAlsoWhereTheyTouch) {
  Source s(6);
  std::array<int, 2> seen{};
  for (int trial = 0; trial < 6000; ++trial) {
    Loop triangle;
    do {
      triangle = {on_grid(s, 5, 2), on_grid(s, 5, 2), on_grid(s, 5, 2)};
    } while (turning_by_definition(triangle) == 0);
    const Loop line = {on_grid(s, 5, 2), on_grid(s, 5, 2)};
    const Flat<Exact> both = flat({line, triangle});
    const bool expected = meet_in_truth(line, triangle, both.turning(1), true);
    ++seen[expected ? 1 : 0];
    ItemList list;
    list.line(line[0], line[1]);
    list.solid(triangle);
    ASSERT_EQ(both.overlap(0, 1), expected) << list.text();
    ASSERT_EQ(both.overlap(1, 0), expected) << list.text();
  }
  EXPECT_GT(std::min(seen[0], seen[1]), 500);
}

TEST(OverlapInProjection, IsNeverDeniedWhereTheInsidesMeet) {
  Source s(7);
  int denied = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const auto polygon = [&] {
      Loop loop;
      const int x = s.between(0, 3), y = s.between(0, 3);
      for (int n = s.between(3, 7); n > 0; --n) {
        loop.push_back(on_grid(s, 4, 1) + Point3(0.25 * x, 0.25 * y, 0.0));
      }
      return loop;
    };
    const Loop a = polygon(), b = polygon();
    const Flat<Exact> both = flat({a, b});
    const bool overlap = both.overlap(0, 1);
    ASSERT_EQ(both.overlap(1, 0), overlap);
    if (overlap) continue;
    ++denied;
    for (int k = 0; k < 60; ++k) {
      const Sample at = {1.75 * s.unit(), 1.75 * s.unit()};
      ItemList list;
      list.solid(a);
      list.solid(b);
      ASSERT_FALSE(covers(a, at) && covers(b, at)) << list.text();
    }
  }
  EXPECT_GT(denied, 300);
}

TEST(OverlapInProjection, OfManySidesIsDeniedWhereALineSeparatesAndOnlyThere) {
  Source s(8);
  std::array<int, 2> seen{};
  for (int trial = 0; trial < 1500; ++trial) {
    const bool in_a_strip =
        s.below(2) == 0;  // each on its side of a line, which may be a side of both
    const auto polygon = [&](double side) {
      Loop loop;
      const int x = s.between(0, 6);
      for (int n = s.between(10, 40); n > 0; --n) {
        const Point3 p = on_grid(s, 8, 1);
        loop.push_back(in_a_strip ? Point3(p.x + 0.25 * x, side * (p.y + 1.0), 0.0)
                                  : p + Point3(0.25 * x, 0.25 * s.between(0, 2), 0.0));
      }
      if (in_a_strip) {  // a side along the line
        loop.push_back({3.0, 0.0, 0.0});
        loop.push_back({-3.0, 0.0, 0.0});
      }
      return loop;
    };
    const Loop a = polygon(1.0), b = polygon(-1.0);
    const Flat<Exact> both = flat({a, b});
    const bool overlap = both.overlap(0, 1);
    ASSERT_EQ(both.overlap(1, 0), overlap);
    ++seen[overlap ? 1 : 0];
    if (in_a_strip) {
      ASSERT_FALSE(overlap);
    }
    for (int k = 0; k < 40 && !overlap; ++k) {
      const Sample at = {-1.0 + 4.0 * s.unit(), -2.0 + 4.0 * s.unit()};
      ItemList list;
      list.solid(a);
      list.solid(b);
      ASSERT_FALSE(covers(a, at) && covers(b, at)) << list.text();
    }
  }
  EXPECT_GT(std::min(seen[0], seen[1]), 300);
}

TEST(OverlapInProjection, SolvedCases) {
  const Loop square = level({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Loop beside = level({{1, 0}, {2, 0}, {2, 1}, {1, 1}});
  const Loop corner = level({{1, 1}, {2, 1}, {2, 2}});
  const Loop within = level({{0.25, 0.25}, {0.5, 0.25}, {0.25, 0.5}});
  const Loop across = level({{-1, 0.25}, {2, 0.25}, {2, 0.75}, {-1, 0.75}});
  const Loop concave = level({{2, -1}, {3, -1}, {3, 2}, {2, 2}, {1.5, 0.5}});
  const Flat<Exact> all = flat({square, beside, corner, within, across, concave, reversed(square)});
  EXPECT_FALSE(all.overlap(0, 1)) << "a side in common";
  EXPECT_FALSE(all.overlap(0, 2)) << "a corner in common";
  EXPECT_TRUE(all.overlap(0, 3)) << "one inside the other";
  EXPECT_TRUE(all.overlap(3, 0));
  EXPECT_TRUE(all.overlap(0, 4)) << "no vertex of one in the other";
  EXPECT_FALSE(all.overlap(0, 5));
  EXPECT_TRUE(all.overlap(1, 5));
  EXPECT_TRUE(all.overlap(0, 6)) << "the same";
  EXPECT_FALSE(all.overlap(6, 1));
}

/// By definition, for points with small whole coordinates: a side with all of `a` on one side of
/// its line, and all of `b` on the other.
bool separated_by_definition(const Loop& a, const Loop& b) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Point3 &from = a[k == 0 ? a.size() - 1 : k - 1], &to = a[k];
    const auto signs = [&](const Loop& loop) {
      std::set<int> all;
      for (const Point3& p : loop) {
        const double turn = (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
        if (turn != 0.0) all.insert(turn > 0.0 ? 1 : -1);
      }
      return all;
    };
    if (from.x == to.x && from.y == to.y) continue;
    const std::set<int> of_a = signs(a), of_b = signs(b);
    if (of_a.size() == 1 && of_b.size() <= 1 && of_a != of_b) return true;
  }
  return false;
}

TEST(OverlapInProjection, PolygonsOfManySidesAreSeparatedByAnyOfThem) {
  Source s(12);
  int apart = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto around = [&](int corners, double x) {
      std::vector<Point2> loop;
      for (int k = 0; k < corners; ++k) {
        const double angle = 6.283185307179586 * k / corners;
        const double radius = s.below(3) == 0 ? s.between(20, 40) : 40;  // in part on its hull
        loop.emplace_back(std::round(x + radius * std::cos(angle)),
                          std::round(radius * std::sin(angle)));
      }
      return level(loop);
    };
    const Loop a = around(s.between(3, 60), 0), b = around(s.between(3, 60), s.between(60, 90));
    const Flat<Exact> both = flat({a, b});
    const bool expected = !separated_by_definition(a, b) && !separated_by_definition(b, a);
    ASSERT_EQ(both.overlap(0, 1), expected) << trial;
    ASSERT_EQ(both.overlap(1, 0), expected) << trial;
    apart += expected ? 0 : 1;
  }
  EXPECT_GT(apart, 300);
  EXPECT_LT(apart, 1900);
}

TEST(OverlapInProjection, RoundoffDecidesWhatIsNotClose) {
  const Loop square = level({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Loop beside = level({{1, 0}, {2, 0}, {2, 1}, {1, 1}});
  const Loop over = level({{0.5, 0.5}, {2, 0.5}, {2, 2}});
  const Flat<Roundoff> all({square, beside, over}, Roundoff({}, 1e-9));
  EXPECT_EQ(all.turning(0), 1);
  EXPECT_FALSE(all.overlap(0, 1));
  EXPECT_TRUE(all.overlap(0, 2));
}

}  // namespace
}  // namespace displayfile
