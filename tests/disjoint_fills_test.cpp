// Pieces that tile a picture: rounded once, merged, with each shared side in one trap, under the
// mask of their union (interp/vector/seams.md).

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "interp/vector/disjoint_fills.h"
#include "interp/vector/path_data.h"
#include "interp/vector/pdf_device.h"
#include "interp/vector/svg_device.h"
#include "interp/vector/tents.h"
#include "interp/vector/traps.h"
#include "tests/error_of.h"
#include "tests/without_keys.h"

namespace displayfile {
namespace {

using namespace test;

using Loop = std::vector<Point2>;
constexpr FillPaint kRedPaint{0xff0000ff}, kBluePaint{0xffff0000};

Loop square(double x, double y, double side = 1.0) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

/// Twice the area, of loops by the even-odd rule that do not overlap except for holes within them.
double area(const LatticeLoops& loops) {
  double outer = 0.0;
  std::vector<double> all;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    double twice = 0.0;
    LatticePoint from = loops.loop(k).back();
    for (const LatticePoint& to : loops.loop(k)) {
      twice += static_cast<double>(from.x) * to.y - static_cast<double>(to.x) * from.y;
      from = to;
    }
    outer += std::abs(twice);
  }
  return outer;
}

std::map<LatticeSide, int> sides_of(const LatticeLoops& loops) {
  std::map<LatticeSide, int> sides;
  for_each_side(loops, [&](const LatticePoint& from, const LatticePoint& to) {
    ++sides[LatticeSide(from, to)];
  });
  return sides;
}

std::map<LatticeSide, int> sides_of(const std::vector<FigureTrap>& traps) {
  std::map<LatticeSide, int> sides;
  for (const FigureTrap& trap : traps) {
    for (std::size_t k = 0; k < trap.sides.size(); ++k) {
      const auto chain = trap.sides.chain(k);
      for (std::size_t i = 1; i < chain.size(); ++i) ++sides[LatticeSide(chain[i - 1], chain[i])];
      if (trap.sides.closed[k]) ++sides[LatticeSide(chain.back(), chain.front())];
    }
  }
  return sides;
}

TEST(DisjointFills, NeighboursOfOneColourAreOneRegionWithoutTheSideBetweenThem) {
  DisjointFills fills{{}};
  fills.add(square(0, 0), kRedPaint, 1, 0);
  fills.add(square(1, 0), kRedPaint, 1, 1);
  const Figure figure = fills.take_figure();
  ASSERT_EQ(figure.regions.size(), 1u);
  // Where the side was, the vertices are straight for both: they go.
  ASSERT_EQ(figure.regions[0].loops.size(), 1u);
  EXPECT_EQ(figure.regions[0].loops.points.size(), 4u);
  EXPECT_EQ(area(figure.regions[0].loops), 2.0 * 2 * 100 * 100);
  EXPECT_TRUE(figure.traps.empty());  // nothing is beside it
  EXPECT_TRUE(fills.empty());
}

/// A vertex in the middle of a straight side stays as long as a third side ends there.
TEST(DisjointFills, AVertexIsStraightForAllOrStays) {
  DisjointFills fills{{}};
  fills.add(Loop{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}, kRedPaint, 1, 0);
  fills.add(square(0, 1), kBluePaint, 1, 1);
  fills.add(square(1, 1), FillPaint{0xff00ff00}, 1, 2);
  const Figure figure = fills.take_figure();
  ASSERT_EQ(figure.regions.size(), 3u);
  std::size_t vertices = 0;
  for (const auto& region : figure.regions) vertices += region.loops.points.size();
  EXPECT_EQ(vertices, 5u + 4u + 4u);
  ASSERT_EQ(figure.outline.size(), 1u);
  EXPECT_EQ(figure.outline[0].points.size(), 4u);  // a mask, by itself
}

TEST(DisjointFills, APieceWithAKeyholeLosesItsBridge) {
  DisjointFills fills{{}};
  fills.add(Loop{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}},
            kRedPaint, 1, 0);
  fills.add(square(3, 3, 3), kBluePaint, 1, 1);
  const Figure figure = fills.take_figure();
  ASSERT_EQ(figure.regions.size(), 2u);
  const auto& with_hole =
      figure.regions[0].paint == kRedPaint ? figure.regions[0] : figure.regions[1];
  EXPECT_EQ(with_hole.loops.size(), 2u);
  EXPECT_EQ(with_hole.loops.points.size(), 8u);
  ASSERT_EQ(figure.outline.size(), 1u);
  EXPECT_EQ(figure.outline[0].size(), 1u);
  EXPECT_EQ(figure.outline[0].points.size(), 4u);
  EXPECT_EQ(sides_of(figure.traps).size(), 8u);
}

TEST(DisjointFills, WhatRoundingMakesThinIsLeftOutAndLeavesNoGapInTheOutline) {
  DisjointFills fills{{}};
  fills.add(square(0, 0), kRedPaint, 1, 0);
  fills.add(Loop{{1, 0}, {1.0001, 0.5}, {1, 1}}, kBluePaint, 1, 1);  // a sliver between
  fills.add(Loop{{1, 0}, {2, 0}, {2, 1}, {1, 1}, {1.0001, 0.5}}, FillPaint{7}, 1, 2);
  fills.add(Loop{{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}}, kBluePaint, 1, 3);
  const Figure figure = fills.take_figure();
  EXPECT_EQ(figure.regions.size(), 2u);
  ASSERT_EQ(figure.outline.size(), 1u);
  EXPECT_EQ(figure.outline[0].size(), 1u);
  EXPECT_EQ(area(figure.outline[0]), 2.0 * 2 * 100 * 100);
}

/// Neither its own sides nor a vertex of it are in the outline, beside a region or on the
/// background, and nothing is added to the mask for it.
TEST(DisjointFills, WhatIsInLineAfterRoundingLeavesNothingInTheOutline) {
  DisjointFills fills{{}};
  fills.add(square(0, 0), kRedPaint, 1, 0);
  fills.add(square(0, 1), kBluePaint, 1, 1);
  fills.add(Loop{{1, 0}, {2, 0}, {3, 0}}, kBluePaint, 1, 2);          // from a corner
  fills.add(Loop{{1, 1}, {3, 1}, {2, 1}, {4, 1}}, kBluePaint, 1, 3);  // there and back
  fills.add(Loop{{1, 2}, {1, 2.3}, {1, 1.5}}, kBluePaint, 1, 4);      // beside a side, and beyond
  fills.add(Loop{{6, 6}, {7, 7}, {9, 9}}, kBluePaint, 1, 5);          // alone
  const Figure figure = fills.take_figure();
  EXPECT_EQ(figure.regions.size(), 2u);
  ASSERT_EQ(figure.outline.size(), 1u);
  EXPECT_EQ(figure.outline[0].size(), 1u);
  EXPECT_EQ(figure.outline[0].points.size(), 4u);
  EXPECT_EQ(area(figure.outline[0]), 2.0 * 2 * 100 * 100);
  EXPECT_TRUE(figure.outline_tents.empty());
}

TEST(DisjointFills, NothingButWhatIsInLineIsNoFigure) {
  DisjointFills fills{{}};
  fills.add(Loop{{6, 6}, {7, 7}, {9, 9}}, kBluePaint, 1, 0);
  EXPECT_TRUE(fills.empty());
}

/// A grid of random quadrilaterals in random colours: they tile a square.
std::vector<Loop> grid(int n, unsigned seed, double cell = 5.0) {
  std::mt19937 random(seed);
  std::vector<Point2> vertices;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) {
      const auto shift = [&](int at) {
        return at == 0 || at == n
                   ? 0.0
                   : 0.4 * cell * (static_cast<double>(random()) / 4294967296.0 - 0.5);
      };
      const double dx = shift(x), dy = shift(y);
      vertices.emplace_back(cell * x + dx, cell * y + dy);
    }
  }
  std::vector<Loop> loops;
  const auto at = [&](int x, int y) { return vertices[static_cast<std::size_t>(y * (n + 1) + x)]; };
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      loops.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
      if (random() % 2 == 0) std::ranges::reverse(loops.back());  // whichever way they run
    }
  }
  return loops;
}

Figure random_figure(int n, unsigned colours, const VectorOptions& options = {}) {
  DisjointFills fills(options);
  std::mt19937 random(2);
  std::int32_t pick = 0;
  for (const Loop& loop : grid(n, 1)) {
    const auto colour = static_cast<std::uint32_t>(random() % colours);
    fills.add(loop, {colour}, pick % 2 + 1, pick);
    ++pick;
  }
  return fills.take_figure();
}

TEST(DisjointFills, EverySideOfARegionIsInOneTrapOnceInThePaintOfTheFirst) {
  for (const unsigned colours : {2u, 5u, 1000u}) {
    const Figure figure = random_figure(20, colours);
    std::map<LatticeSide, FillPaint> first;
    for (const FigureRegion& region : figure.regions) {
      for (const auto& [side, times] : sides_of(region.loops)) {
        EXPECT_EQ(times, 1);
        first.emplace(side, region.paint);
      }
    }
    const auto trapped = sides_of(figure.traps);
    EXPECT_EQ(trapped.size(), first.size());
    for (const auto& [side, times] : trapped) EXPECT_EQ(times, 1);
    for (const FigureTrap& trap : figure.traps) {
      for (const auto& [side, times] : sides_of(std::vector{trap})) {
        EXPECT_EQ(first.at(side), trap.paint);
      }
    }
  }
}

TEST(DisjointFills, TheOutlineIsThatOfTheUnion) {
  const Figure figure = random_figure(20, 5);
  ASSERT_EQ(figure.outline.size(), 1u);
  EXPECT_EQ(area(figure.outline[0]), 2.0 * 10000 * 10000);
  EXPECT_EQ(figure.outline[0].size(), 1u);
}

TEST(DisjointFills, OnlyATrappedFigureOfSeveralRegionsHasTraps) {
  VectorOptions butted;
  butted.seams = Seams::butted;
  EXPECT_TRUE(random_figure(4, 1000, butted).traps.empty());
  EXPECT_FALSE(random_figure(4, 1000).traps.empty());
}

TEST(DisjointFills, PickIdentifiersKeepPiecesApart) {
  VectorOptions options;
  options.pick_ids = true;
  const Figure figure = random_figure(6, 1, options);
  ASSERT_EQ(figure.regions.size(), 36u);
  std::vector<std::int32_t> picks;
  for (const FigureRegion& region : figure.regions) picks.push_back(region.pick);
  std::ranges::sort(picks);
  for (std::int32_t k = 0; k < 36; ++k) EXPECT_EQ(picks[static_cast<std::size_t>(k)], k);
}

/// Every vertex is moved by half a unit along an axis at most, so that the moved area is no more
/// than the precision times the length of the sides.
TEST(DisjointFills, RoundingMovesNoMoreThanThePrecisionAlongTheSides) {
  for (const double precision : {0.001, 0.01, 0.3}) {
    VectorOptions options;
    options.pick_ids = true;
    options.precision = precision;
    const Figure figure = random_figure(12, 3, options);
    const std::vector<Loop> loops = grid(12, 1);
    ASSERT_EQ(figure.regions.size(), loops.size());
    double moved = 0.0, allowed = 0.0;
    for (const FigureRegion& region : figure.regions) {
      const Loop& loop = loops[static_cast<std::size_t>(region.pick)];
      double twice = 0.0;
      Point2 from = loop.back();
      for (const Point2& to : loop) {
        twice += from.x * to.y - to.x * from.y;
        allowed += precision * glm::distance(from, to);
        from = to;
      }
      moved += std::abs(area(region.loops) * precision * precision - std::abs(twice)) / 2.0;
      for (const LatticePoint& p : region.loops.points) {
        EXPECT_TRUE(std::ranges::any_of(loop, [&](const Point2& v) {
          return std::abs(p.x * precision - v.x) <= precision * 0.5000001 &&
                 std::abs(p.y * precision - v.y) <= precision * 0.5000001;
        }));
      }
    }
    EXPECT_LE(moved, allowed);
    EXPECT_GT(moved, 0.0);
  }
}

bool is_long(const LatticeLoops& loops) { return loops.points.size() > Figure::kMostVertices; }

bool has_long_path(const Figure& figure) {
  return std::ranges::any_of(figure.regions, is_long, &FigureRegion::loops) ||
         std::ranges::any_of(figure.outline, is_long) ||
         std::ranges::any_of(figure.outline_tents, is_long) ||
         std::ranges::any_of(figure.traps, [](const FigureTrap& trap) {
           return trap.sides.points.size() > Figure::kMostVertices;
         });
}

TEST(DisjointFills, NoRegionHasMoreVerticesThanAPathMay) {
  DisjointFills fills{{}};
  const int n = 150;  // a chessboard: no sides go, 45,000 vertices of each colour
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      fills.add(square(x, y), (x + y) % 2 == 0 ? kRedPaint : kBluePaint, 1, 0);
    }
  }
  const Figure figure = fills.take_figure();
  EXPECT_FALSE(has_long_path(figure));
  EXPECT_EQ(figure.regions.size(), 4u);
  double sum = 0.0;
  for (const FigureRegion& region : figure.regions) sum += area(region.loops);
  ASSERT_EQ(figure.outline.size(), 1u);
  EXPECT_EQ(sum, area(figure.outline[0]));
  EXPECT_EQ(sum, 2.0 * n * n * 100 * 100);
}

/// One piece around n x n holes, which it has by bridges. Its loop starts and ends in a corner.
Loop plate(int n) {
  const double side = 2.0 * n + 1.0;
  Loop loop{{0, 0}, {0, side}, {side, side}, {side, 0}, {0, 0}};
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      Loop hole = square(2.0 * x + 1.0, 2.0 * y + 1.0);
      hole.push_back(hole[0]);
      loop.insert(loop.end(), hole.begin(), hole.end());
      loop.emplace_back(0, 0);
    }
  }
  loop.pop_back();  // it closes itself
  return loop;
}

TEST(DisjointFills, NoSinglePieceHasMoreVerticesThanAPathMay) {
  const int n = 100;
  for (const bool filled : {true, false}) {
    DisjointFills fills{{}};
    fills.add(plate(n), kRedPaint, 1, 0);
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        // Or the background shows through holes, and one of them is half full.
        if (filled) fills.add(square(2.0 * x + 1.0, 2.0 * y + 1.0), kBluePaint, 1, 1);
      }
    }
    if (!filled) fills.add({{{1, 1}, {2, 2}, {1, 2}}}, kBluePaint, 1, 1);
    const Figure figure = fills.take_figure();
    EXPECT_FALSE(has_long_path(figure));
    EXPECT_EQ(figure.regions.size(), filled ? 4u : 3u);
    EXPECT_EQ(figure.outline.size(), filled ? 1u : 2u);
    EXPECT_EQ(figure.outline_tents.empty(), filled);
    // The sides on which regions are: each side has two regions, except those on the outline.
    std::map<LatticeSide, int> sides, of_outline;
    for (const FigureRegion& region : figure.regions) {
      for (const auto& [side, times] : sides_of(region.loops)) sides[side] += times;
    }
    for (const LatticeLoops& part : figure.outline) {
      for (const auto& [side, times] : sides_of(part)) of_outline[side] += times;
    }
    std::erase_if(sides, [](const auto& side) { return side.second == 2; });
    std::erase_if(of_outline, [](const auto& side) { return side.second == 2; });
    EXPECT_EQ(sides, of_outline);
    for (const auto& [side, times] : sides) EXPECT_EQ(times, 1);
  }
}

TEST(DisjointFills, AMaskOfSeveralPartsHasTentsOverTheSidesBetweenThem) {
  DisjointFills fills{{}};
  fills.add(plate(100), kRedPaint, 1, 0);
  fills.add({{{1, 1}, {2, 2}, {1, 2}}}, kBluePaint, 1, 1);
  const Figure figure = fills.take_figure();
  ASSERT_EQ(figure.outline.size(), 2u);
  // Over each side between the two there is a tent on either side of it.
  const auto first = sides_of(figure.outline[0]), second = sides_of(figure.outline[1]);
  std::size_t between = 0;
  for (const auto& [side, times] : first) between += second.count(side);
  EXPECT_GT(between, 0u);
  std::size_t tents = 0;
  for (const LatticeLoops& some : figure.outline_tents) tents += some.size();
  EXPECT_EQ(tents, 2 * between);
}

TEST(DisjointFills, TentsStayWithinTheirRegionsLoops) {
  const Figure figure = random_figure(12, 1000);
  for (const FigureTents& tents : tents_of(figure.regions, 280.0)) {
    for (const LatticePoint& p : tents.triangles.points) {
      EXPECT_GE(p.x, 0);
      EXPECT_GE(p.y, 0);
      EXPECT_LE(p.x, 6000);
      EXPECT_LE(p.y, 6000);
    }
  }
}

/// A spike that a region runs along there and back is not a side that it shares with another.
TEST(DisjointFills, TentsAreOverSidesOfTwoRegions) {
  DisjointFills fills{{}};
  fills.add(Loop{{0, 0}, {2, 0}, {3, 0}, {4, 0}, {2, 0.0001}, {0, 2}}, kRedPaint, 1, 0);
  fills.add(Loop{{0, 0}, {2, 0}, {2, -1}, {0, -1}}, kBluePaint, 1, 1);
  const Figure figure = fills.take_figure();
  ASSERT_EQ(figure.regions.size(), 2u);
  const std::vector<FigureTents> tents = tents_of(figure.regions, 50.0);
  ASSERT_EQ(tents.size(), 1u);
  ASSERT_EQ(tents[0].triangles.size(), 2u);  // on either side of the one that they share
  for (const LatticePoint& p : tents[0].triangles.points) EXPECT_LE(p.x, 200);
}

TEST(PathData, IsRelativeAndShort) {
  LatticeLoops loops;
  loops.add(std::array{LatticePoint{10, 20}, LatticePoint{40, 20}, LatticePoint{40, -7}});
  loops.add(std::array{LatticePoint{41, 21}, LatticePoint{43, 22}, LatticePoint{44, 90}});
  std::string data;
  append_loops(data, loops);
  EXPECT_EQ(data, "m10 20h30v-27zm31 1 2 1 1 68z");
}

std::size_t times(const std::string& text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// Two squares of other colours, in two segments, and a third in the first's colour.
void draw_squares(VectorDevice& device) {
  const LineStyle none{LineStyle::Kind::none};
  const std::vector<std::int32_t> sides(4, op::move);
  const std::array colours{Colour(1, 0, 0), Colour(0, 0, 1), Colour(1, 0, 0)};
  device.begin_disjoint_fills();
  for (int k = 0; k < 3; ++k) {
    device.begin_segment(k == 0 ? 4 : 7);
    const FillStyle fill{FillStyle::Kind::solid, colours[static_cast<std::size_t>(k)]};
    const double x = 0.1 + 0.2 * k, next = 0.1 + 0.2 * (k + 1);
    const std::vector<Point3> vertices{{x, .1, .5}, {next, .1, .5}, {next, .3, .5}, {x, .3, .5}};
    device.fill({vertices, sides, fill, none, 10 + k});
    device.end_segment();
  }
  device.end_disjoint_fills();
}

std::string svg_of_squares(const VectorOptions& options) {
  SvgDevice device(100, 100, {}, options);
  draw_squares(device);
  std::ostringstream out;
  device.finish(out);
  return without_keys(out.str());
}

TEST(SvgFigure, IsOneGroupUnderOneMask) {
  const std::string svg = svg_of_squares({});
  EXPECT_EQ(times(svg, "<mask "), 1u) << svg;
  EXPECT_EQ(times(svg, "transform=\"scale(0.01)\" mask=\"url(#figure-1)\""), 1u) << svg;
  EXPECT_EQ(times(svg, "id=\"segment-4\""), 1u) << svg;
  EXPECT_EQ(times(svg, "id=\"segment-7\""), 1u) << svg;
  EXPECT_EQ(times(svg, "data-pick"), 0u);
  EXPECT_EQ(times(svg, "<g"), times(svg, "</g>"));
}

/// A browser that draws elements named by <use> sees no class outside of that: traps would be
/// filled.
TEST(SvgFigure, TrapsHaveNoFillWhereTheyAreDrawnAgain) {
  const std::string svg = svg_of_squares({});
  EXPECT_EQ(times(svg, "<g id=\"traps-1\" class=\"sides\">"), 1u) << svg;
  EXPECT_EQ(times(svg, "<use xlink:href=\"#traps-1\""), 4u) << svg;
  EXPECT_EQ(times(svg, ".sides path{fill:none}"), 1u) << svg;
}

TEST(SvgFigure, ButtedHasNeitherTrapsNorMask) {
  VectorOptions options;
  options.seams = Seams::butted;
  const std::string svg = svg_of_squares(options);
  EXPECT_EQ(times(svg, "mask"), 0u) << svg;
  EXPECT_EQ(times(svg, "<use"), 0u) << svg;
  EXPECT_EQ(times(svg, "<path"), 3u) << svg;
  EXPECT_LT(svg.size(), svg_of_squares({}).size());
}

TEST(SvgFigure, PickIdentifiersAreDataAndTitles) {
  VectorOptions options;
  options.pick_ids = true;
  const std::string svg = svg_of_squares(options);
  for (const char* pick : {"10", "11", "12"}) {
    EXPECT_EQ(times(svg, std::string("data-pick=\"") + pick + "\""), 1u) << svg;
    EXPECT_EQ(times(svg, std::string("<title>") + pick + "</title>"), 1u) << svg;
  }
}

TEST(SvgFigure, APrecisionIsTheUnitOfCoordinates) {
  VectorOptions options;
  options.precision = 0.5;
  EXPECT_EQ(times(svg_of_squares(options), "transform=\"scale(0.5)\""), 1u);
}

/// Two disjoint triangles, thinner than a unit: the mask is empty.
TEST(SvgFigure, PiecesThatAreRoundedAlikeHaveNoOutline) {
  VectorOptions options;
  options.precision = 1.0;
  SvgDevice device(20, 20, {}, options);
  device.begin_disjoint_fills();
  for (const double y : {0.51, 0.52}) {
    const std::vector<Point3> vertices{{0, y, .5}, {.5, y + .02, .5}, {1, y + .025, .5}};
    const std::vector<std::int32_t> sides(3, op::move);
    const FillStyle fill{FillStyle::Kind::solid, Colour(y, 0, 0)};
    device.fill({vertices, sides, fill, {LineStyle::Kind::none}, 0});
  }
  device.end_disjoint_fills();
  std::ostringstream out;
  device.finish(out);
  EXPECT_EQ(times(without_keys(out.str()), "<path class=\"whole\" d=\"\"/>"), 1u) << out.str();
}

TEST(SvgFigure, NothingMakesNoGroup) {
  SvgDevice device(10, 10);
  device.begin_disjoint_fills();
  device.end_disjoint_fills();
  std::ostringstream out;
  device.finish(out);
  EXPECT_EQ(times(out.str(), "figure"), 0u);
}

TEST(CairoFigure, PdfHasASoftMaskAndNoImage) {
  std::ostringstream out;
  PdfDevice device(out, 100, 100);
  draw_squares(device);
  device.finish();
  EXPECT_EQ(times(out.str(), "/SMask "), 1u);
  EXPECT_EQ(times(out.str(), "/Subtype /Image"), 0u);
}

TEST(CairoFigure, EpsIsVectorsAndTheSameEachTime) {
  const auto eps = [] {
    std::ostringstream out;
    PdfDevice device(out, 100, 100, {}, {}, PageFormat::eps);
    draw_squares(device);
    device.finish();
    return out.str();
  };
  const std::string once = eps();
  EXPECT_TRUE(once.starts_with("%!PS-Adobe-3.0 EPSF-3.0"));
  EXPECT_EQ(times(once, "CreationDate"), 0u);
  EXPECT_EQ(times(once, "/ImageType"), 0u);
  EXPECT_EQ(once, eps());
}

/// As viewers read them that round, and that take the whole part (MuPDF).
TEST(CairoFigure, EveryLevelOfAColourIsWrittenSoThatItIsReadAsItself) {
  for (std::uint32_t level = 0; level < 256; ++level) {
    std::ostringstream out;
    PdfDevice device(out, 100, 100, {}, {}, PageFormat::eps);
    device.begin_segment(1);
    device.begin_disjoint_fills();
    const std::vector<Point3> vertices{{0.1, 0.1, 0}, {0.9, 0.1, 0}, {0.5, 0.9, 0}};
    const std::vector<std::int32_t> sides(3, 0);
    const FillStyle fill{FillStyle::Kind::solid, Colour(level / 255.0)};
    device.fill({vertices, sides, fill, {LineStyle::Kind::none}, 0});
    device.end_disjoint_fills();
    device.end_segment();
    device.finish();
    std::istringstream words(out.str());
    std::string before, word, written;  // the last that is set, after the background's
    while (words >> word) {
      if (word == "g") written = before;
      before = word;
    }
    ASSERT_FALSE(written.empty());
    const double read = std::stod(written) * 255.0;
    EXPECT_EQ(std::floor(read), level) << written;
    EXPECT_EQ(std::lround(read), static_cast<long>(level)) << written;
  }
}

TEST(VectorOptions, APrecisionOutOfItsRangeIsRefused) {
  for (const double precision : {0.0, -1.0, 0.0005, 1.5}) {
    VectorOptions options;
    options.precision = precision;
    expect_error([&] { SvgDevice(10, 10, {}, options); }, "expected 0.001 to 1 pixels");
  }
}

}  // namespace
}  // namespace displayfile
