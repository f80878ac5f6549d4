// Where polygons pass through each other (hidden/lines/intersection_lines.h): worked by hand.

#include "hidden/lines/intersection_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <ostream>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "displayfile/segments/display_file.h"
#include "displayfile/segments/hidden_surface_check.h"
#include "displayfile/segments/sorted_scene.h"
#include "hidden/lines/lines_in_order.h"
#include "hidden/lines/visible_lines.h"
#include "tests/intersection_truth.h"
#include "tests/sort_scenes.h"

namespace displayfile {
namespace {

using namespace test;

struct Ends {
  Point3 from, to;
  bool operator==(const Ends&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Ends& e) {
  for (const Point3& p : {e.from, e.to}) out << p.x << " " << p.y << " " << p.z << "  ";
  return out;
}

std::vector<Ends> ends_of(const ItemList& list) {
  std::vector<Ends> ends;
  for (const auto& line : intersection_lines(list.view())) {
    ends.push_back({line.start, line.end});
  }
  return ends;
}

ItemList solids(const std::vector<Loop>& loops) {
  ItemList list;
  for (const Loop& loop : loops) list.solid(loop);
  return list;
}

/// A level rectangle, and one that rises through it along y = 1/2, where it has that depth.
const Loop kLevel{{0.25, 0.25, 0.5}, {0.75, 0.25, 0.5}, {0.75, 0.75, 0.5}, {0.25, 0.75, 0.5}};
Loop rising(double x0, double x1) {
  return {{x0, 0.25, 0.25}, {x1, 0.25, 0.25}, {x1, 0.75, 0.75}, {x0, 0.75, 0.75}};
}

TEST(IntersectionLines, TwoSquaresCrossWhereBothAre) {
  const std::vector<Ends> inner{{{0.375, 0.5, 0.5}, {0.625, 0.5, 0.5}}};
  EXPECT_EQ(ends_of(solids({kLevel, rising(0.375, 0.625)})), inner);
  EXPECT_EQ(ends_of(solids({rising(0.375, 0.625), kLevel})), inner);
  const std::vector<Ends> overlap{{{0.25, 0.5, 0.5}, {0.5, 0.5, 0.5}}};
  EXPECT_EQ(ends_of(solids({kLevel, rising(0.0, 0.5)})), overlap);
  const auto lines = intersection_lines(solids({kLevel, rising(0.0, 0.5)}).view());
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].item_a, 0u);
  EXPECT_EQ(lines[0].item_b, 1u);
}

TEST(IntersectionLines, PolygonsThatOnlyTouchHaveNone) {
  EXPECT_TRUE(ends_of(solids({kLevel, rising(0.75, 1.0)})).empty());  // in a point of the line
  // An edge that lies in the other polygon, inside and on its boundary.
  const Loop upper{{0.375, 0.5, 0.5}, {0.625, 0.5, 0.5}, {0.625, 0.75, 0.75}, {0.375, 0.75, 0.75}};
  EXPECT_TRUE(ends_of(solids({kLevel, upper})).empty());
  Loop at_edge = upper;
  for (Point3& p : at_edge) p.y += 0.25;
  EXPECT_TRUE(ends_of(solids({kLevel, at_edge})).empty());
  // The edge that two share passes through the level one: it is a side already.
  const Loop lower{{0.375, 0.5, 0.5}, {0.375, 0.25, 0.25}, {0.625, 0.25, 0.25}, {0.625, 0.5, 0.5}};
  EXPECT_TRUE(ends_of(solids({kLevel, upper, lower})).empty());
  // A vertex in it; and one plane.
  EXPECT_TRUE(
      ends_of(solids({kLevel, {{0.5, 0.5, 0.5}, {0.6, 0.5, 0.9}, {0.5, 0.6, 0.9}}})).empty());
  EXPECT_TRUE(ends_of(solids({kLevel, kLevel})).empty());
  EXPECT_TRUE(
      ends_of(solids({kLevel, {{0.5, 0.5, 0.5}, {1.0, 0.5, 0.5}, {0.5, 1.0, 0.5}}})).empty());
}

TEST(IntersectionLines, OnlySolidPolygonsThatCoverSomethingHaveThem) {
  ItemList list;
  list.solid(kLevel);
  list.hollow(rising(0.375, 0.625));
  list.line({0.5, 0.5, 0.0}, {0.5, 0.6, 1.0});
  list.solid({{0.5, 0.25, 0.0}, {0.5, 0.75, 0.0}, {0.5, 0.75, 1.0}, {0.5, 0.25, 1.0}});  // edge-on
  EXPECT_TRUE(ends_of(list).empty());
}

TEST(IntersectionLines, AConcavePolygonHasTwoPartsOfOneLine) {
  const Loop comb{{0.25, 0.25, 0.5},
                  {0.75, 0.25, 0.5},
                  {0.75, 0.75, 0.5},
                  {0.5, 0.375, 0.5},
                  {0.25, 0.75, 0.5}};
  const std::vector<Ends> two{{{0.25, 0.5, 0.5}, {0.4166666666666667, 0.5, 0.5}},
                              {{0.5833333333333334, 0.5, 0.5}, {0.75, 0.5, 0.5}}};
  EXPECT_EQ(ends_of(solids({comb, rising(0.0, 1.0)})), two);
  EXPECT_EQ(ends_of(solids({rising(0.0, 1.0), comb})), two);
  // The notch only touches the line.
  Loop shallow = comb;
  shallow[3].y = 0.5;
  EXPECT_EQ(ends_of(solids({shallow, rising(0.0, 1.0)})),
            (std::vector<Ends>{{{0.25, 0.5, 0.5}, {0.75, 0.5, 0.5}}}));
}

TEST(IntersectionLines, SelfCrossingPolygonsAreInsideByEvenOdd) {
  const Loop bow_tie{{0.25, 0.25, 0.5}, {0.75, 0.75, 0.5}, {0.75, 0.25, 0.5}, {0.25, 0.75, 0.5}};
  Loop across = rising(0.0, 1.0);
  for (Point3& p : across) p.z += 0.125;  // the line is at y = 3/8
  EXPECT_EQ(ends_of(solids({bow_tie, across})),
            (std::vector<Ends>{{{0.25, 0.375, 0.5}, {0.375, 0.375, 0.5}},
                               {{0.625, 0.375, 0.5}, {0.75, 0.375, 0.5}}}));
  Loop twice = kLevel;  // gone round twice it covers nothing
  twice.insert(twice.end(), kLevel.begin(), kLevel.end());
  EXPECT_TRUE(ends_of(solids({twice, rising(0.0, 1.0)})).empty());
}

TEST(IntersectionLines, PolygonsThatAreNotFlatAreTakenInTheirSupportPlanes) {
  Loop bent = kLevel;
  bent[3].z = 0.9;  // p, q, r are the first, third and second: it counts as level
  EXPECT_EQ(ends_of(solids({bent, rising(0.375, 0.625)})),
            (std::vector<Ends>{{{0.375, 0.5, 0.5}, {0.625, 0.5, 0.5}}}));
}

/// The faces of a box, each corner by `at`.
template <class At>
void add_box(ItemList& list, const At& at) {
  constexpr std::array<std::array<int, 4>, 6> kFaces = {
      {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}};
  for (const auto& face : kFaces) {
    Loop loop;
    for (const int k : face) loop.push_back(at(k & 1, k >> 1 & 1, k >> 2 & 1));
    list.solid(loop);
  }
}
/// Sheared so that no face is edge-on.
Point3 shown(double x, double y, double z) {
  return {0.25 + 0.25 * x + 0.125 * z, 0.25 + 0.25 * y + 0.0625 * z, 0.25 + 0.125 * (z - x - y)};
}

using Place = std::tuple<double, double, double>;
Place place(const Point3& p) { return {p.x, p.y, p.z}; }

/// The number of loops that the lines make, end to end; -1 if they do not close.
int loops(const std::vector<Ends>& lines) {
  std::map<Place, std::vector<Place>> next;
  for (const auto& [from, to] : lines) {
    next[place(from)].push_back(place(to));
    next[place(to)].push_back(place(from));
  }
  int count = 0;
  std::set<Place> seen;
  for (const auto& [start, others] : next) {
    if (others.size() != 2) return -1;
    if (!seen.insert(start).second) continue;
    ++count;
    std::vector<Place> waiting(others);
    while (!waiting.empty()) {
      const Place p = waiting.back();
      waiting.pop_back();
      if (seen.insert(p).second) waiting.insert(waiting.end(), next[p].begin(), next[p].end());
    }
  }
  return count;
}

TEST(IntersectionLines, TwoCubesCornerInCornerMakeAHexagon) {
  ItemList list;
  add_box(list, [](double x, double y, double z) { return shown(x, y, z); });
  add_box(list, [](double x, double y, double z) { return shown(x + 0.3, y + 0.4, z + 0.7); });
  const std::vector<Ends> lines = ends_of(list);
  EXPECT_EQ(lines.size(), 6u);
  EXPECT_EQ(loops(lines), 1);
}

TEST(IntersectionLines, ABeamThroughACubeMakesTwoSquares) {
  ItemList list;
  add_box(list, [](double x, double y, double z) { return shown(x, y, z); });
  add_box(list, [](double x, double y, double z) {
    return shown(0.3 + x / 3.0, 0.3 + y / 3.0, 2.0 * z - 0.7);
  });
  const std::vector<Ends> lines = ends_of(list);
  EXPECT_EQ(lines.size(), 8u);
  EXPECT_EQ(loops(lines), 2);
}

/// A ring of triangles around a circle, a closed mesh without corners in common with another.
void add_torus(ItemList& list, const Point3& middle, int way, int n) {
  const double pi = std::numbers::pi;
  const auto at = [&](int i, int j) {
    const double u = 2.0 * pi * (i % n) / n, v = 2.0 * pi * (j % n) / n;
    const double r = 0.2 + 0.07 * std::cos(v);
    const Point3 ring{r * std::cos(u), r * std::sin(u), 0.07 * std::sin(v)};
    const Point3 turned = way == 0 ? ring : Point3{ring.x, ring.z, ring.y};
    const Point3 tilted{turned.x, 0.8 * turned.y - 0.6 * turned.z, 0.6 * turned.y + 0.8 * turned.z};
    return middle + tilted;
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      list.solid({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      list.solid({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
}

TEST(IntersectionLines, TwoToriMakeClosedOutlinesAndOneMakesNone) {
  ItemList list;
  add_torus(list, {0.45, 0.5, 0.5}, 0, 24);
  EXPECT_TRUE(ends_of(list).empty());
  add_torus(list, {0.5, 0.5, 0.5}, 1, 24);
  const std::vector<Ends> lines = ends_of(list);
  EXPECT_GT(lines.size(), 50u);
  EXPECT_GT(loops(lines), 0);
}

/// Caps and walls of more than three sides: rounding takes their vertices off their planes.
TEST(IntersectionLines, FacesOfOneSolidHaveNone) {
  constexpr int kSides = 12;
  for (int tilt = 1; tilt < 60; ++tilt) {
    const double s = std::sin(0.1 * tilt), c = std::cos(0.1 * tilt);
    const auto at = [&](int k, double z) {
      const double u = 2.0 * std::numbers::pi * (k % kSides) / kSides;
      const double x = 0.3 * std::cos(u), y = 0.3 * std::sin(u);
      return Point3(0.5 + c * x - s * z, 0.5 + 0.8 * y - 0.6 * (s * x + c * z),
                    0.5 + 0.6 * y + 0.8 * (s * x + c * z));
    };
    ItemList list;
    Loop top, bottom;
    for (int k = 0; k < kSides; ++k) {
      top.push_back(at(k, 0.2));
      bottom.push_back(at(kSides - k, -0.2));
      list.solid({at(k, -0.2), at(k + 1, -0.2), at(k + 1, 0.2), at(k, 0.2)});
    }
    list.solid(top);
    list.solid(bottom);
    EXPECT_TRUE(ends_of(list).empty()) << tilt;
  }
}

// ---- Their visible parts ------------------------------------------------------------------------

using Parts = std::vector<std::pair<double, double>>;

/// The visible parts of the only intersection line; the same by each method.
Parts seen(const ItemList& list) {
  const auto lines = intersection_lines(list.view());
  EXPECT_EQ(lines.size(), 1u);
  Parts parts;
  for (const HiddenMethod method :
       {HiddenMethod::roberts, HiddenMethod::appel, HiddenMethod::franklin}) {
    Parts found;
    for (const auto& piece :
         visible_lines(list.view(), {}, {.method = method}, lines).intersections) {
      found.emplace_back(piece.from, piece.to);
    }
    if (method == HiddenMethod::roberts) parts = found;
    EXPECT_EQ(found, parts) << name_of(method);
  }
  return parts;
}

TEST(IntersectionLines, AreHiddenLikeLines) {
  ItemList list = solids({kLevel, rising(0.375, 0.625)});
  EXPECT_EQ(seen(list), (Parts{{0.0, 1.0}}));
  ItemList half = list;
  half.solid(square(0.5, 0.0, 1.0, 1.0, 0.9));
  EXPECT_EQ(seen(half), (Parts{{0.0, 0.5}}));
  ItemList wholly = list;
  wholly.solid(square(0.0, 0.0, 1.0, 1.0, 0.9));
  EXPECT_EQ(seen(wholly), Parts{});
  ItemList behind = list;
  behind.solid(square(0.0, 0.0, 1.0, 1.0, 0.1));
  EXPECT_EQ(seen(behind), (Parts{{0.0, 1.0}}));
  ItemList outline = list;  // right behind an edge
  outline.solid(square(0.0, 0.5, 1.0, 1.0, 0.9));
  EXPECT_EQ(seen(outline), (Parts{{0.0, 1.0}}));
  outline.solid(square(0.0, 0.0, 1.0, 0.5, 0.9));  // that two share
  EXPECT_EQ(seen(outline), Parts{});
}

TEST(IntersectionLines, TheExactLineIsLookedAtAndNotTheRoundedOne) {
  // At depth 1/5 all along, which is less than the double 0.2.
  ItemList list = solids({{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, {0.0, 1.0, 1.0}},
                          {{0.0, 0.0, 1.0}, {1.0, 0.0, 1.0}, {1.0, 0.5, -1.0}, {0.0, 0.5, -1.0}}});
  list.solid(square(0.25, 0.0, 0.75, 1.0, 0.2));
  const auto lines = intersection_lines(list.view());
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines[0].start, Point3(0.0, 0.2, 0.2));
  for (const HiddenMethod method : {HiddenMethod::roberts, HiddenMethod::franklin}) {
    const std::vector<VisibleIntersection> right{{0, 0.0, 0.25}, {0, 0.75, 1.0}};
    const std::span first(lines.data(), 1);
    EXPECT_EQ(visible_lines(list.view(), {}, {.method = method}, first).intersections, right);
  }
}

TEST(IntersectionLines, NothingThroughThemHidesThem) {
  ItemList list = solids({kLevel, rising(0.375, 0.625)});
  // Coplanar with one, whole and in halves that have an edge there.
  ItemList coplanar = list;
  coplanar.hollow(kLevel);
  EXPECT_EQ(seen(coplanar), (Parts{{0.0, 1.0}}));
  const auto lines = [](const ItemList& all) {
    const auto found = intersection_lines(all.view());
    return visible_lines(all.view(), {}, {.method = HiddenMethod::franklin}, found)
        .intersections.size();
  };
  coplanar.solid(square(0.0, 0.0, 1.0, 1.0, 0.5));
  EXPECT_EQ(lines(coplanar), 2u);  // with each level one
  // A third plane through the same line.
  ItemList third = list;
  third.solid({{0.375, 0.25, 0.75}, {0.625, 0.25, 0.75}, {0.625, 0.75, 0.25}, {0.375, 0.75, 0.25}});
  EXPECT_EQ(lines(third), 3u);
}

TEST(IntersectionLines, InOrderTheyArePiecesOfTheLaterPolygonBesideThoseOfSides) {
  ItemList list = solids({kLevel, rising(0.375, 0.625)});
  list.solid(square(0.5, 0.0, 1.0, 1.0, 0.9));  // hides half
  const auto pieces = [&](HiddenMethod method, bool intersections) {
    SurfacePlan options;
    options.intersections = intersections;
    return lines_in_order(list.view(), {}, find_lines(list.view(), {}, options.by(method)),
                          HiddenLines::none);
  };
  for (const HiddenMethod method :
       {HiddenMethod::roberts, HiddenMethod::appel, HiddenMethod::franklin}) {
    const SortedPieces without = pieces(method, false), with = pieces(method, true);
    ASSERT_EQ(with.pieces.size(), without.pieces.size() + 1);
    const auto is_intersection = [&](const SortedPiece& p) { return with.is_intersection(p); };
    ASSERT_EQ(std::ranges::count_if(with.pieces, is_intersection), 1);
    const SortedPiece piece = *std::ranges::find_if(with.pieces, is_intersection);
    EXPECT_EQ(piece.item, 1u);
    EXPECT_EQ(with.pick_item(piece), 1u);
    EXPECT_EQ(with.points[piece.first], Point3(0.375, 0.5, 0.5));
    EXPECT_EQ(with.points[piece.first + 1], Point3(0.5, 0.5, 0.5));
    for (const SortedPiece& p : without.pieces) EXPECT_FALSE(without.is_intersection(p));
  }
}

TEST(IntersectionLines, AreDrawnInTheStyleAndUnderTheIdentifierOfTheLaterPolygon) {
  DisplayFile file;
  Segment& segment = file.create(1);
  segment.set_style(FillStyle{});
  const std::array<Loop, 2> loops{kLevel, rising(0.375, 0.625)};
  for (int k = 0; k < 2; ++k) {
    segment.set_style(LineStyle{.width = 1.0 + k});
    segment.set_pick(k == 0 ? 9 : 4);
    segment.enter_polygon(loops[static_cast<std::size_t>(k)], std::vector<std::uint8_t>(4, 1));
  }
  struct Visitor {
    std::ostringstream text{};
    void fill(const FillStyle&) {}
    void line_style(const LineStyle& style) { text << "width " << style.width << "; "; }
    void pick(std::int32_t n) { text << "pick " << n << "; "; }
    void move(const Point3& p) { text << "move " << p.x << " " << p.y << " " << p.z << "; "; }
    void line(const Point3& p) { text << "line " << p.x << " " << p.y << " " << p.z << "; "; }
    void polygon(std::span<const Point3>, std::span<const std::int32_t>) {}
  } visitor;
  const Segment* const segments[] = {&segment};
  hidden_surface_check(segments, {.method = HiddenMethod::franklin, .intersections = true})
      ->walk(visitor);
  const std::string text = visitor.text.str(), last = "width 2; pick 4; ";
  const std::string line = "move 0.375 0.5 0.5; line 0.625 0.5 0.5; ";
  EXPECT_TRUE(text.ends_with(line)) << text;
  EXPECT_EQ(text.find(line), text.size() - line.size());
  EXPECT_NE(text.find(last), std::string::npos) << text;
}

TEST(IntersectionLines, ScaledByTwoAndMirroredTheyAreTheSame) {
  for (const SortFamily& family : sort_families()) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      Source source(seed);
      const ItemList list = family.make(source);
      ItemList twice = list, mirrored = list;
      for (Point3& p : twice.points) p *= 2.0;
      for (Point3& p : mirrored.points) p.x = -p.x;
      const auto changed = [](const ItemList& all, const Point3& factor) {
        std::vector<std::string> text;
        const auto lines = intersection_lines(all.view());
        for (const auto& line : lines) {
          std::array<Point3, 2> ends{line.from.near * factor, line.to.near * factor};
          if (place(ends[1]) < place(ends[0])) std::swap(ends[0], ends[1]);
          std::ostringstream out;
          out.precision(17);
          out << line.item_a << " " << line.item_b;
          for (const Point3& p : ends) out << " " << p.x + 0.0 << " " << p.y << " " << p.z;
          text.push_back(out.str());
        }
        std::ranges::sort(text);
        return text;
      };
      const auto right = changed(list, {1.0, 1.0, 1.0});
      ASSERT_EQ(changed(twice, {0.5, 0.5, 0.5}), right) << family.name << " " << seed;
      ASSERT_EQ(changed(mirrored, {-1.0, 1.0, 1.0}), right) << family.name << " " << seed;
      const auto pieces = [](const ItemList& all) {
        const auto lines = intersection_lines(all.view());
        return visible_lines(all.view(), {}, {.method = HiddenMethod::franklin}, lines)
            .intersections;
      };
      ASSERT_EQ(pieces(twice), pieces(list)) << family.name << " " << seed;
    }
  }
}

}  // namespace
}  // namespace displayfile
