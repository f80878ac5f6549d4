// Strokes of a pen: none twice, joined, in order.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <vector>

#include "clip/base/work_budget.h"
#include "interp/vector/pens/dashes.h"
#include "interp/vector/pens/pen_order.h"
#include "interp/vector/pens/point_tree.h"
#include "interp/vector/pens/stroke_chains.h"
#include "interp/vector/pens/unique_strokes.h"

namespace displayfile {
namespace {

double length_of(const Stroke& s) {
  return std::sqrt(static_cast<double>(squared_distance(s.from, s.to)));
}
double length_of_all(const std::vector<Stroke>& strokes) {
  double sum = 0.0;
  for (const Stroke& s : strokes) sum += length_of(s);
  return sum;
}
double length_of_all(const std::vector<PenPath>& paths) {
  double sum = 0.0;
  for (const PenPath& path : paths) sum += length_of(path);
  return sum;
}

double distance(double x, double y, const Stroke& s) {
  const double dx = s.to.x - s.from.x, dy = s.to.y - s.from.y;
  const double px = x - s.from.x, py = y - s.from.y;
  const double squared = dx * dx + dy * dy;
  const double t = squared > 0.0 ? std::clamp((px * dx + py * dy) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(px - t * dx, py - t * dy);
}

/// The largest distance of a point of a stroke from the drawn strokes.
double farthest(const std::vector<Stroke>& strokes, const std::vector<Stroke>& drawn) {
  double most = 0.0;
  for (const Stroke& s : strokes) {
    for (int k = 0; k <= 64; ++k) {
      const double t = k / 64.0;
      const double x = s.from.x + t * (s.to.x - s.from.x);
      const double y = s.from.y + t * (s.to.y - s.from.y);
      double least = std::numeric_limits<double>::infinity();
      for (const Stroke& d : drawn) least = std::min(least, distance(x, y, d));
      most = std::max(most, least);
    }
  }
  return most;
}

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  std::int32_t from(std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(random_() % static_cast<unsigned>(high - low + 1));
  }
  double unit() { return static_cast<double>(random_()) / 4294967296.0; }

 private:
  std::mt19937 random_;
};

/// The drawn length of lines whose points are all whole units is exactly that of their union.
TEST(UniqueStrokes, OfWholeUnitsAreTheUnion) {
  constexpr int kLines = 9, kPlaces = 60, kStep = 50;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Dice dice(seed);
    std::vector<Stroke> strokes;
    std::map<std::tuple<int, int>, std::set<int>> covered;  // of a direction's line, its places
    for (int k = 0; k < 150; ++k) {
      const int direction = dice.from(0, 3), line = kStep * dice.from(0, kLines);
      int from = dice.from(0, kPlaces), to = dice.from(0, kPlaces);
      if (from == to) continue;
      const auto at = [&](int place) -> SheetPoint {
        const int p = kStep * place;
        switch (direction) {
          case 0: return {p, line};
          case 1: return {line, p};
          case 2: return {p, 7000 + p + line};
          default: return {p, 20000 - 2 * p + line};
        }
      };
      strokes.push_back({at(from), at(to)});
      for (int p = std::min(from, to); p < std::max(from, to); ++p) {
        covered[{direction, line}].insert(p);
      }
    }
    double length = 0.0;
    const double of_step[] = {1.0, 1.0, std::sqrt(2.0), std::sqrt(5.0)};
    for (const auto& [line, places] : covered) {
      length += kStep * of_step[std::get<0>(line)] * static_cast<double>(places.size());
    }
    const std::vector<Stroke> unique = unique_strokes(strokes);
    EXPECT_NEAR(length_of_all(unique), length, 1e-6) << seed;
    EXPECT_NEAR(length_of_all(stroke_chains(unique)), length, 1e-6) << seed;
    EXPECT_LT(farthest(strokes, unique), 1e-9) << seed;
  }
}

/// Pieces of lines in any direction, whose ends are rounded: the remaining strokes cover them
/// within the tolerance for lying on a stroke, and are no longer than their union except for that.
TEST(UniqueStrokes, OfRoundedLinesAreTheUnionButForRounding) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Dice dice(seed);
    std::vector<Stroke> strokes;
    double length = 0.0;
    for (int line = 0; line < 5; ++line) {
      const double angle = 3.14 * dice.unit(), x0 = 1e5 * dice.unit(), y0 = 1e5 * dice.unit();
      std::vector<std::pair<double, double>> parts;
      for (int k = 0; k < 12; ++k) {
        const double from = 5e4 * dice.unit(), to = from + 2e4 * dice.unit() * dice.unit();
        parts.emplace_back(from, to);
        const auto at = [&](double u) {
          return SheetPoint{static_cast<std::int32_t>(std::lround(x0 + u * std::cos(angle))),
                            static_cast<std::int32_t>(std::lround(y0 + u * std::sin(angle)))};
        };
        strokes.push_back({at(from), at(to)});
      }
      std::ranges::sort(parts);
      double end = -1.0;
      for (const auto& [from, to] : parts) {
        length += std::max(0.0, to - std::max(from, end));
        end = std::max(end, to);
      }
    }
    const std::vector<Stroke> unique = unique_strokes(strokes);
    EXPECT_NEAR(length_of_all(unique), length, 3.0 * static_cast<double>(strokes.size())) << seed;
    EXPECT_LE(farthest(strokes, unique), kOnStroke + 1e-9) << seed;
    for (std::size_t i = 0; i < unique.size(); ++i) {  // the middle of none lies on another
      const Stroke& s = unique[i];
      if (length_of(s) < 10.0) continue;
      for (std::size_t j = 0; j < unique.size(); ++j) {
        const auto turn = static_cast<double>(cross(s.from, s.to, unique[j].from, unique[j].to));
        if (i == j || std::abs(turn) > 0.05 * length_of(s) * length_of(unique[j])) continue;
        EXPECT_GT(distance((s.from.x + s.to.x) / 2.0, (s.from.y + s.to.y) / 2.0, unique[j]), 0.9)
            << seed << " " << i << " " << j;
      }
    }
  }
}

TEST(UniqueStrokes, WhatMeetsOrCrossesStays) {
  std::vector<Stroke> strokes;
  const SheetPoint middle{50'000, 50'000};
  for (int k = 0; k < 720; ++k) {  // half a degree apart: 8.7 units at the near ends
    const double angle = k * 3.14159265358979 / 360.0;
    const auto at = [&](double r) {
      return SheetPoint{static_cast<std::int32_t>(std::lround(middle.x + r * std::cos(angle))),
                        static_cast<std::int32_t>(std::lround(middle.y + r * std::sin(angle)))};
    };
    strokes.push_back({middle, at(30'000.0)});
  }
  EXPECT_EQ(unique_strokes(strokes).size(), strokes.size());
  strokes = {{{0, 0}, {1000, 1000}}, {{0, 1000}, {1000, 0}}, {{0, 1002}, {1000, 2}}};
  // 1.41 apart is on it, except for an end beyond its end; 2.1 apart is not.
  EXPECT_LE(length_of_all(unique_strokes(strokes)), 2.0 * std::sqrt(2e6) + 2.0);
  strokes[2] = {{0, 1003}, {1000, 3}};
  EXPECT_EQ(unique_strokes(strokes).size(), 3u);
  strokes = {{{0, 0}, {1000, 0}}, {{0, 2}, {1000, 2}}, {{1000, 0}, {2000, 0}}};
  EXPECT_EQ(unique_strokes(strokes).size(), 3u);
}

TEST(UniqueStrokes, ThereAndBackAndDots) {
  EXPECT_TRUE(unique_strokes({}).empty());
  EXPECT_EQ(unique_strokes({{{0, 0}, {9, 9}}, {{9, 9}, {0, 0}}, {{0, 0}, {9, 9}}}).size(), 1u);
  const std::vector<Stroke> dots{{{5, 5}, {5, 5}}, {{5, 5}, {5, 5}}, {{500, 500}, {500, 500}}};
  EXPECT_EQ(unique_strokes(dots).size(), 2u);
  EXPECT_EQ(unique_strokes({{{0, 0}, {100, 0}}, {{50, 1}, {50, 1}}, {{50, 3}, {50, 3}}}).size(),
            2u);
}

/// A stack of strokes, each within reach of the next, is not all on the first.
TEST(UniqueStrokes, DoNotDriftFromStrokeToStroke) {
  std::vector<Stroke> strokes;
  for (int k = 0; k < 100; ++k) strokes.push_back({{k, k}, {10'000 - k, k}});
  const std::vector<Stroke> unique = unique_strokes(strokes);
  EXPECT_LE(farthest(strokes, unique), kOnStroke);
  EXPECT_GE(unique.size(), 50u);
}

// ---- Chains ------------------------------------------------------------------------------

/// Sides of the squares of a board.
std::vector<Stroke> board(int columns, int rows) {
  std::vector<Stroke> strokes;
  for (int x = 0; x <= columns; ++x) {
    for (int y = 0; y <= rows; ++y) {
      // Bent, so that no two sides lie on a line.
      const auto at = [](int i, int j) {
        return SheetPoint{1000 * i + 37 * j * j, 1000 * j + 53 * i * i};
      };
      if (x < columns) strokes.push_back({at(x, y), at(x + 1, y)});
      if (y < rows) strokes.push_back({at(x, y), at(x, y + 1)});
    }
  }
  return strokes;
}

std::multiset<Stroke> sides_of(const std::vector<PenPath>& paths) {
  std::multiset<Stroke> sides;
  const auto add = [&](const SheetPoint& a, const SheetPoint& b) {
    sides.insert(a < b ? Stroke{a, b} : Stroke{b, a});
  };
  for (const PenPath& path : paths) {
    const auto& p = path.points;
    for (std::size_t i = 1; i < p.size(); ++i) add(p[i - 1], p[i]);
    if (path.closed) add(p.back(), p.front());
    if (p.size() == 1) add(p[0], p[0]);
  }
  return sides;
}

TEST(StrokeChains, AreAsFewAsThereCanBe) {
  for (const auto& [columns, rows] : {std::pair{1, 1}, {2, 1}, {2, 2}, {5, 3}, {9, 9}}) {
    const std::vector<Stroke> strokes = board(columns, rows);
    std::map<SheetPoint, int> ends;
    for (const Stroke& s : strokes) {
      ++ends[s.from];
      ++ends[s.to];
    }
    const auto odd = std::ranges::count_if(ends, [](const auto& e) { return e.second % 2 == 1; });
    const std::vector<PenPath> paths = stroke_chains(strokes);
    EXPECT_EQ(static_cast<long>(paths.size()), std::max(1L, static_cast<long>(odd / 2)))
        << columns << " x " << rows;
    std::multiset<Stroke> all;
    for (const Stroke& s : strokes) all.insert(s.from < s.to ? s : Stroke{s.to, s.from});
    EXPECT_EQ(sides_of(paths), all);
  }
}

/// Loops that go straight on where they cross are one path.
TEST(StrokeChains, LoopsThatTouchAreOnePath) {
  std::vector<Stroke> strokes;
  const auto loop = [&](const std::vector<SheetPoint>& p) {
    for (std::size_t i = 0; i < p.size(); ++i) strokes.push_back({p[i], p[(i + 1) % p.size()]});
  };
  loop({{0, 0}, {1000, 0}, {1000, 1000}});
  loop({{1000, 1000}, {3000, 1500}, {2000, 2500}});
  loop({{3000, 1500}, {5000, 100}, {5000, 3000}});
  std::vector<PenPath> paths = stroke_chains(strokes);
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_TRUE(paths[0].closed);
  EXPECT_EQ(paths[0].points.size(), 9u);
  strokes.push_back({{5000, 3000}, {6000, 6000}});  // a tail: drawn with them
  paths = stroke_chains(strokes);
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_FALSE(paths[0].closed);
  EXPECT_EQ(sides_of(paths).size(), 10u);
}

TEST(StrokeChains, StrokesOnOneLineBecomeOne) {
  const std::vector<PenPath> paths = stroke_chains(std::vector<Stroke>{{{0, 0}, {100, 33}},
                                                                       {{100, 33}, {200, 67}},
                                                                       {{300, 100}, {200, 67}},
                                                                       {{300, 100}, {300, 900}}});
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(paths[0].points, (std::vector<SheetPoint>{{0, 0}, {300, 100}, {300, 900}}));
  // Around a square that begins within a side.
  const std::vector<PenPath> square = stroke_chains(std::vector<Stroke>{{{50, 0}, {100, 0}},
                                                                        {{100, 0}, {100, 100}},
                                                                        {{100, 100}, {0, 100}},
                                                                        {{0, 100}, {0, 0}},
                                                                        {{0, 0}, {50, 0}}});
  ASSERT_EQ(square.size(), 1u);
  EXPECT_TRUE(square[0].closed);
  EXPECT_EQ(square[0].points.size(), 4u);
}

/// A curve of short strokes is not straightened away: every point stays within reach.
TEST(StrokeChains, LeftOutPointsAreWithinReach) {
  std::vector<Stroke> strokes;
  std::vector<SheetPoint> points;
  for (int k = 0; k <= 3000; ++k) {
    const double a = k * 0.002;
    points.push_back({static_cast<std::int32_t>(std::lround(50'000 * std::cos(a))),
                      static_cast<std::int32_t>(std::lround(50'000 * std::sin(a)))});
  }
  for (std::size_t k = 1; k < points.size(); ++k) strokes.push_back({points[k - 1], points[k]});
  const std::vector<PenPath> paths = stroke_chains(strokes);
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_LT(paths[0].points.size(), points.size());
  std::vector<Stroke> drawn;
  for (std::size_t i = 1; i < paths[0].points.size(); ++i) {
    drawn.push_back({paths[0].points[i - 1], paths[0].points[i]});
  }
  EXPECT_LE(farthest(strokes, drawn), kOnStroke + 1e-9);
}

TEST(Dashes, GoOnAroundCorners) {
  const PenPath path{{{0, 0}, {1000, 0}, {1000, 1000}}, false};
  const std::vector<Stroke> cut = dashes({path}, 300.0, 200.0);
  EXPECT_EQ(cut, (std::vector<Stroke>{{{0, 0}, {300, 0}},
                                      {{500, 0}, {800, 0}},
                                      {{1000, 0}, {1000, 300}},
                                      {{1000, 500}, {1000, 800}}}));
  EXPECT_EQ(dashes({path}, 1.0, 1.0).size(), 2u);    // finer than a pen draws: whole
  EXPECT_EQ(dashes({path}, 300.0, 0.0).size(), 2u);  // no gaps
  const PenPath loop{{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}}, true};
  EXPECT_NEAR(length_of_all(dashes({loop}, 300.0, 100.0)), 3000.0, 1e-9);
}

TEST(Dashes, ADotIsDrawn) {
  const Stroke dot{{7, 9}, {7, 9}};
  EXPECT_EQ(dashes({{{{7, 9}}, false}}, 300.0, 200.0), (std::vector<Stroke>{dot}));
  EXPECT_EQ(dashes({{{{7, 9}}, false}}, 300.0, 0.0), (std::vector<Stroke>{dot}));
}

/// The rest of a dash at a corner may be shorter than the precision of the coordinates there.
TEST(Dashes, EndOnPathsOfManyCorners) {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::int32_t> coordinate(-1000000, 1000000);
  std::vector<PenPath> paths(20);
  double length = 0.0;
  for (PenPath& path : paths) {
    path.points.push_back({coordinate(random), coordinate(random)});
    for (int i = 0; i < 200; ++i) {
      path.points.push_back({coordinate(random), coordinate(random)});
      const auto squared =
          squared_distance(path.points[path.points.size() - 2], path.points.back());
      length += std::sqrt(static_cast<double>(squared));
    }
  }
  for (const double dash : {211.66666666666666, 1e3 / 3.0, 4321.1}) {
    const double drawn = length_of_all(dashes(paths, dash, dash / 1.5));
    EXPECT_NEAR(drawn / length, 0.6, 0.01);
  }
}

// ---- Order -------------------------------------------------------------------------------

TEST(PointTree, FindsTheNearestLeft) {
  Dice dice(7);
  std::vector<SheetPoint> points;
  for (int k = 0; k < 500; ++k)
    points.push_back({dice.from(0, 60), dice.from(0, 60)});  // equal ones
  PointTree tree(points);
  std::vector<bool> removed(points.size(), false);
  std::vector<std::uint32_t> found;
  for (std::size_t left = points.size(); left > 0; --left) {
    const SheetPoint to{dice.from(-10, 70), dice.from(-10, 70)};
    std::vector<std::pair<std::int64_t, std::uint32_t>> all;
    for (std::uint32_t k = 0; k < points.size(); ++k) {
      if (!removed[k]) all.emplace_back(squared_distance(to, points[k]), k);
    }
    std::ranges::sort(all);
    const std::uint32_t nearest = tree.nearest(to);
    ASSERT_EQ(nearest, all[0].second);
    tree.nearest(to, 5, found);
    ASSERT_EQ(found.size(), std::min<std::size_t>(5, left));
    for (std::size_t k = 0; k < found.size(); ++k) ASSERT_EQ(found[k], all[k].second);
    tree.remove(nearest);
    tree.remove(nearest);
    removed[nearest] = true;
  }
  EXPECT_EQ(tree.nearest({0, 0}), PointTree::kNone);
  EXPECT_EQ(PointTree(std::vector<SheetPoint>{}).nearest({0, 0}), PointTree::kNone);
}

std::vector<PenPath> strewn(unsigned seed, int n, bool with_loops) {
  Dice dice(seed);
  std::vector<PenPath> paths;
  for (int k = 0; k < n; ++k) {
    const SheetPoint p{dice.from(0, 200'000), dice.from(0, 200'000)};
    const auto near = [&] {
      return SheetPoint{p.x + dice.from(1, 5000), p.y + dice.from(1, 5000)};
    };
    const int kind = with_loops ? dice.from(0, 3) : 1;
    if (kind == 0) {
      paths.push_back({{p, near(), near(), near()}, true});
    } else if (kind == 3) {
      paths.push_back({{p}, false});
    } else {
      paths.push_back({{p, near()}, false});
    }
  }
  return paths;
}

/// Each path once, in one of its directions; none changed. And not longer than by nearest ends.
TEST(PenOrder, IsAPermutationWithDirections) {
  for (const int n : {0, 1, 2, 3, 4, 5, 17, 400}) {
    for (unsigned seed = 1; seed <= (n < 10 ? 50u : 4u); ++seed) {
      for (const bool with_loops : {false, true}) {
        const std::vector<PenPath> paths = strewn(seed, n, with_loops);
        std::vector<PenPath> ordered = paths;
        order_for_pen(ordered);
        ASSERT_EQ(ordered.size(), paths.size());
        EXPECT_EQ(sides_of(ordered), sides_of(paths));
        std::multiset<std::size_t> sizes, sizes_ordered;
        for (const PenPath& p : paths) sizes.insert(p.points.size() + (p.closed ? 100 : 0));
        for (const PenPath& p : ordered)
          sizes_ordered.insert(p.points.size() + (p.closed ? 100 : 0));
        EXPECT_EQ(sizes, sizes_ordered);
        EXPECT_LE(travel(ordered), travel(paths) + 1e-6);
        std::vector<PenPath> again = paths;
        order_for_pen(again);
        EXPECT_EQ(travel(again), travel(ordered));
      }
    }
  }
}

/// Where paths are few, every order and direction can be tried.
TEST(PenOrder, OfFewPathsIsNearTheBest) {
  double ours = 0.0, best = 0.0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const std::vector<PenPath> paths = strewn(seed, 6, false);
    std::vector<PenPath> ordered = paths;
    order_for_pen(ordered);
    std::vector<std::size_t> order{0, 1, 2, 3, 4, 5};
    double least = std::numeric_limits<double>::infinity();
    do {
      for (unsigned turned = 0; turned < 64; ++turned) {
        double sum = 0.0;
        for (std::size_t k = 1; k < order.size(); ++k) {
          const bool a = (turned >> order[k - 1]) & 1u, b = (turned >> order[k]) & 1u;
          sum += std::sqrt(static_cast<double>(squared_distance(
              paths[order[k - 1]].points[a ? 0 : 1], paths[order[k]].points[b ? 1 : 0])));
        }
        least = std::min(least, sum);
      }
    } while (std::next_permutation(order.begin(), order.end()));
    EXPECT_GE(travel(ordered), least - 1e-6);
    ours += travel(ordered);
    best += least;
  }
  EXPECT_LE(ours, 1.03 * best);
}

/// In a row of strokes the pen goes along the row, from either end, however they are given.
TEST(PenOrder, FollowsARow) {
  std::vector<PenPath> paths;
  for (int k = 0; k < 200; ++k) {
    const int place = k * 77 % 200;
    const SheetPoint a{1000 * place, 0}, b{1000 * place + 900, 0};
    paths.push_back({k % 2 == 0 ? std::vector{a, b} : std::vector{b, a}, false});
  }
  order_for_pen(paths);
  EXPECT_NEAR(travel(paths), 199 * 100.0, 1e-6);
}

/// All cross in one place.
TEST(UniqueStrokes, AskTheBudget) {
  std::vector<Stroke> strokes;
  strokes.reserve(400);
  for (int k = 0; k < 400; ++k) strokes.push_back({{-100'000, -500 * k}, {100'000, 500 * k}});
  WorkBudget budget;
  const BudgetInForce in_force(budget);
  EXPECT_EQ(unique_strokes(strokes).size(), strokes.size());
  budget.stop();
  EXPECT_THROW(unique_strokes(strokes), LimitReached);
}

}  // namespace
}  // namespace displayfile
