// The object-space sorts (hidden/hidden_surface_sort.h), judged by rationals at sample points, by
// exact areas, and on cases solved by hand.

#include "hidden/hidden_surface_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "clip/error.h"
#include "hidden/drawing_graph.h"
#include "hidden/sort_polygons.h"
#include "tests/sort_truth.h"

namespace displayfile {
namespace {

using namespace test;

#if defined(__SANITIZE_ADDRESS__)
constexpr int kSlower = 10;
#else
constexpr int kSlower = 1;
#endif

/// The largest scenes are that much larger with DISPLAYFILE_LARGER=10, or any other number.
int larger(int size) {
  const char* times = std::getenv("DISPLAYFILE_LARGER");
  return times == nullptr ? size : size * std::max(1, std::atoi(times));
}

// ---- Random scenes ------------------------------------------------------------------------------

/// All that must hold of an exact sort.
std::string judged(const ItemList& list, const Way& way, std::uint64_t seed, int samples) {
  const SortedPieces pieces = sorted(list, way);
  const SortJudge judge(list, pieces);
  if (std::string wrong = judge.items(); !wrong.empty()) return wrong;
  if (std::string wrong = judge.areas(1e-12); !wrong.empty()) return wrong;
  if (std::string wrong = judge.outlines(); !wrong.empty()) return wrong;
  Source s(seed);
  for (int k = 0; k < samples; ++k) {
    if (std::string wrong = judge.order_at(any_sample(s)); !wrong.empty()) return wrong;
  }
  return judge.lines_at(0.1 + 0.8 * s.unit());
}

class EveryWay : public testing::TestWithParam<Way> {};
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

TEST_P(EveryWay, TheMethodIsPutToTheTest) {  // the scenes above do ask for cuts
  std::uint64_t cuts = 0;
  for (int k = 0; k < 20; ++k) {
    Source s(static_cast<std::uint64_t>(k));
    cuts += sorted(families::triangles(s), GetParam()).cuts;
  }
  EXPECT_GT(cuts, 20u);
}

// ---- Exact areas --------------------------------------------------------------------------------

/// Exact, and keeps the definition of each vertex that it makes, in the order of their numbers.
class Recorded : public Exact {
 public:
  Recorded(const Definitions& all, std::vector<DefinedPoint>& made) : Exact(all), made_(&made) {}
  Vertex vertex(std::uint32_t point, std::uint32_t own) const {
    return made_->emplace_back(Exact::vertex(point, own));
  }
  Vertex cut(const Vertex& from, const Vertex& to, const SideLine& line, std::uint32_t own,
             std::uint32_t plane) const {
    return made_->emplace_back(Exact::cut(from, to, line, own, plane));
  }

 private:
  std::vector<DefinedPoint>* made_;
};

/// The tree's pieces as they are, not rounded.
class ExactPieces {
 public:
  ExactPieces(const ItemList& list, RootChoice root)
      : items_(list.view()), scene_(items_, Recorded({items_.points, {}}, made_)) {
    const SortOptions options{.precision = {}, .root = root};
    SortPolygons<Recorded> sorting(scene_, options);
    sorting.sort_all();
    order_.assign(sorting.order().begin(), sorting.order().end());
  }

  std::span<const PolygonTable::Index> order() const { return order_; }
  std::uint32_t item(PolygonTable::Index piece) const { return scene_.table[piece].item; }
  bool is_polygon(PolygonTable::Index piece) const { return scene_.table[piece].plane != kNoPlane; }
  std::vector<QPoint> points(PolygonTable::Index piece) const {
    std::vector<QPoint> loop;
    for (const std::uint32_t v : scene_.table.vertices(piece)) loop.push_back(point(v));
    return loop;
  }
  /// A vertex of the display file is the true one, rounded once.
  bool is_rounded_once(PolygonTable::Index piece) const {
    return std::ranges::all_of(scene_.table.vertices(piece), [&](std::uint32_t v) {
      const QPoint truth = point(v);
      const Point3 found = scene_.vertices.coordinates(v);
      const auto is_nearest = [](double x, const Q& exactly) {
        const Q off = abs(Q(x) - exactly);
        return off <= abs(Q(std::nextafter(x, 1e300)) - exactly) &&
               off <= abs(Q(std::nextafter(x, -1e300)) - exactly);
      };
      return is_nearest(found.x, truth.x) && is_nearest(found.y, truth.y) &&
             is_nearest(found.z, truth.z);
    });
  }

 private:
  QPlane plane(std::uint32_t k) const {
    const Plane& p = scene_.vertices.plane(k);
    return {rational(p.p), rational(p.q), rational(p.r)};
  }
  QPoint lifted(std::uint32_t k, std::uint32_t own) const {
    const QPoint v = rational(items_.points[k]);
    return {v.x, v.y, plane(own).z(v.x, v.y)};
  }
  QPoint point(std::uint32_t v) const {
    if (v < items_.points.size()) return rational(items_.points[v]);
    const DefinedPoint& d = made_[v - items_.points.size()];
    switch (d.kind) {
      case DefinedPoint::Kind::stored: return rational(d.near);
      case DefinedPoint::Kind::lifted: return lifted(d.a, d.own);
      case DefinedPoint::Kind::edge_cut:
        return *meet(rational(items_.points[d.a]), rational(items_.points[d.b]), plane(d.cut));
      case DefinedPoint::Kind::lifted_edge_cut:
        return *meet(lifted(d.a, d.own), lifted(d.b, d.own), plane(d.cut));
      case DefinedPoint::Kind::plane_cut: return *meet(plane(d.own), plane(d.a), plane(d.cut));
    }
    return {};
  }

  SortItems items_;
  std::vector<DefinedPoint> made_;
  SortScene<Recorded> scene_;
  std::vector<PolygonTable::Index> order_;
};

/// Signed areas are additive whatever the polygon; of one that does not cross itself, no piece
/// may turn the other way.
void expect_exact_areas(const ItemList& list, RootChoice root, bool simple) {
  const ExactPieces pieces(list, root);
  std::vector<Q> area(list.items.size());
  std::vector<bool> polygon(list.items.size());
  for (const auto piece : pieces.order()) {
    if (!pieces.is_polygon(piece)) continue;
    const std::uint32_t item = pieces.item(piece);
    const Q part = twice_area(pieces.points(piece));
    if (simple) {
      EXPECT_EQ(sgn(part), sgn(twice_area(list.points_of(item)))) << "item " << item;
    }
    EXPECT_TRUE(pieces.is_rounded_once(piece)) << "item " << item;
    area[item] += part;
    polygon[item] = true;
  }
  for (std::size_t i = 0; i < area.size(); ++i) {
    EXPECT_EQ(polygon[i], plane_by_definition(list.points_of(i)).has_value()) << "item " << i;
    if (!polygon[i]) continue;
    EXPECT_EQ(area[i], twice_area(list.points_of(i))) << "item " << i;
  }
}

TEST(SortedAreas, SumToTheirPolygonsExactly) {
  for (const SortFamily& family : sort_families()) {
    if (family.name == "lines" || family.name == "cycles") continue;
    for (int k = 0; k < 12 / std::min(kSlower, 6); ++k) {
      for (const RootChoice root : {RootChoice::last, RootChoice::sample, RootChoice::free}) {
        Source s(static_cast<std::uint64_t>(1000 + k));
        const ItemList list = family.make(s);
        expect_exact_areas(list, root, false);
        ASSERT_FALSE(HasFailure()) << family.name << ", seed " << 1000 + k << "\n" << list.text();
      }
    }
  }
}

TEST(SortedAreas, NoPieceOfASimplePolygonIsEmptyOrTurnedOver) {
  for (int k = 0; k < 60 / kSlower; ++k) {
    Source s(static_cast<std::uint64_t>(k));
    ItemList list;
    for (int n = s.between(2, 6); n > 0; --n) {
      list.solid(s.below(2) == 0 ? star_shaped(s, any_slope(s), s.between(4, 12))
                                 : convex(s, any_slope(s), s.between(3, 7)));
    }
    for (const RootChoice root : {RootChoice::last, RootChoice::sample, RootChoice::free}) {
      expect_exact_areas(list, root, true);
      ASSERT_FALSE(HasFailure()) << k << "\n" << list.text();
    }
  }
}

// ---- COMPARE-POLYS on solved cases --------------------------------------------------------------

/// A side of a half: where it ends, and whether it is drawn.
struct Side {
  double x, y;
  bool visible = true;
  friend bool operator==(const Side&, const Side&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Side& s) {
    return out << "(" << s.x << ", " << s.y << (s.visible ? ")" : ", cut)");
  }
};
using Half = std::vector<Side>;

/// The half begun at its smallest vertex, so that it can be compared.
Half normal(Half half) {
  const auto before = [](const Side& a, const Side& b) {
    return std::pair(a.x, a.y) < std::pair(b.x, b.y);
  };
  std::rotate(half.begin(), std::ranges::min_element(half, before), half.end());
  return half;
}

/// A polygon against the plane z = x - 1, whose front is where x < 1 for a polygon in z = 0.
template <class Policy>
class AgainstPlane {
 public:
  explicit AgainstPlane(const Loop& test) {
    list_.solid({{0, 0, -1}, {4, 0, 3}, {0, 4, -1}});
    if (test.size() == 2) {
      list_.line(test[0], test[1]);
    } else {
      list_.solid(test);
    }
    items_ = list_.view();
    scene_.emplace(items_, policy(Definitions{items_.points, {}}));
  }
  PlaneSide compare() { return scene_->comparing.compare(1, 0); }
  /// Front and back.
  std::pair<Half, Half> split() {
    EXPECT_EQ(compare(), PlaneSide::both);
    const auto [front, back] = scene_->comparing.split(1, 0);
    EXPECT_EQ(scene_->comparing.cuts(), 1u);
    EXPECT_FALSE(scene_->table[1].whole);
    EXPECT_TRUE((front == 1 && back == 2) || (front == 2 && back == 1));
    return {half(front), half(back)};
  }

 private:
  static Exact policy(const Definitions& all) requires std::same_as<Policy, Exact> {
    return Exact(all);
  }
  static Roundoff policy(const Definitions& all) requires std::same_as<Policy, Roundoff> {
    return Roundoff(all, 1e-9);
  }
  Half half(PolygonTable::Index entry) const {
    EXPECT_EQ(scene_->table[entry].item, 1u);
    Half sides;
    for (std::uint32_t k = 0; k < scene_->table[entry].sides; ++k) {
      const auto side = scene_->table.d[scene_->table[entry].start + k];
      const Point3 p = scene_->vertices.coordinates(side.vertex);
      sides.push_back({p.x, p.y, side.visible});
    }
    return sides.size() == 2 ? sides : normal(sides);
  }

  ItemList list_;
  SortItems items_;
  std::optional<SortScene<Policy>> scene_;
};

template <class Policy>
class ComparePolysTest : public testing::Test {
 protected:
  /// The level polygon with these corners; x = 1 is where it meets the plane.
  static Loop level(const std::vector<Point2>& corners) {
    Loop loop;
    for (const Point2& p : corners) loop.push_back({p.x, p.y, 0.0});
    return loop;
  }
  static void expect_halves(const std::vector<Point2>& corners, const Half& front,
                            const Half& back) {
    // From whichever vertex it begins, the halves are the same.
    for (std::size_t first = 0; first < corners.size(); ++first) {
      std::vector<Point2> begun = corners;
      std::rotate(begun.begin(), begun.begin() + static_cast<std::ptrdiff_t>(first), begun.end());
      const auto halves = AgainstPlane<Policy>(level(begun)).split();
      EXPECT_EQ(halves.first, normal(front)) << "begun at " << first;
      EXPECT_EQ(halves.second, normal(back)) << "begun at " << first;
    }
  }
  static PlaneSide compared(const std::vector<Point2>& corners) {
    return AgainstPlane<Policy>(level(corners)).compare();
  }
};
using Policies = testing::Types<Exact, Roundoff>;
TYPED_TEST_SUITE(ComparePolysTest, Policies);

TYPED_TEST(ComparePolysTest, OnOneSideOrTouchingIt) {
  EXPECT_EQ(this->compared({{0, 0}, {0.5, 0}, {0, 1}}), PlaneSide::front);
  EXPECT_EQ(this->compared({{2, 0}, {3, 0}, {2, 1}}), PlaneSide::back);
  // A vertex, an edge, and two vertices apart on the plane.
  EXPECT_EQ(this->compared({{0, 0}, {1, 0}, {0, 1}}), PlaneSide::front);
  EXPECT_EQ(this->compared({{1, 0}, {2, 0}, {2, 1}}), PlaneSide::back);
  EXPECT_EQ(this->compared({{0, 0}, {1, 0}, {1, 1}}), PlaneSide::front);
  EXPECT_EQ(this->compared({{2, 0}, {1, 1}, {1, 0}}), PlaneSide::back);
  EXPECT_EQ(this->compared({{0, 0}, {1, 0}, {0.5, 0.5}, {1, 1}, {0, 1}}), PlaneSide::front);
  EXPECT_EQ(this->compared({{0, 0}, {2, 0}, {0, 1}}), PlaneSide::both);
}

TYPED_TEST(ComparePolysTest, InThePlane) {
  AgainstPlane<TypeParam> in_plane({{0, 0, -1}, {1, 0, 0}, {1, 1, 0}, {0, 1, -1}});
  EXPECT_EQ(in_plane.compare(), PlaneSide::on);
  AgainstPlane<TypeParam> line({{0, 0, -1}, {3, 1, 2}});
  EXPECT_EQ(line.compare(), PlaneSide::on);
}

TYPED_TEST(ComparePolysTest, ASquareIsHalved) {
  this->expect_halves({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{0, 0}, {1, 0}, {1, 2, false}, {0, 2}},
                      {{1, 0, false}, {2, 0}, {2, 2}, {1, 2}});
}

TYPED_TEST(ComparePolysTest, CutAtAVertex) {
  this->expect_halves({{0, 0}, {1, 0}, {2, 0.5}, {1, 2}}, {{0, 0}, {1, 0}, {1, 2, false}},
                      {{1, 0, false}, {2, 0.5}, {1, 2}});
  this->expect_halves({{0, 0}, {2, 0}, {1, 1}}, {{0, 0}, {1, 0}, {1, 1, false}},
                      {{1, 0, false}, {2, 0}, {1, 1}});
}

TYPED_TEST(ComparePolysTest, AnEdgeInThePlaneIsDrawnOnce) {
  // From (1, 1) to (1, 2) the outline runs along the cut.
  const std::vector<Point2> corners = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (std::size_t first = 0; first < corners.size(); ++first) {
    std::vector<Point2> begun = corners;
    std::rotate(begun.begin(), begun.begin() + static_cast<std::ptrdiff_t>(first), begun.end());
    const auto [front, back] = AgainstPlane<TypeParam>(this->level(begun)).split();
    const auto drawn = [](const Half& half) {
      double length = 0.0;
      for (std::size_t k = 0; k < half.size(); ++k) {
        const Side& from = half[(k + half.size() - 1) % half.size()];
        if (half[k].visible) length += std::hypot(half[k].x - from.x, half[k].y - from.y);
      }
      return length;
    };
    EXPECT_EQ(drawn(front) + drawn(back), 8.0) << "begun at " << first;
    const auto area = [](const Half& half) {
      double twice = 0.0;
      for (std::size_t k = 0; k < half.size(); ++k) {
        const Side& from = half[(k + half.size() - 1) % half.size()];
        twice += from.x * half[k].y - half[k].x * from.y;
      }
      return 0.5 * twice;
    };
    EXPECT_EQ(area(front), 2.0) << "begun at " << first;
    EXPECT_EQ(area(back), 1.0) << "begun at " << first;
  }
}

TYPED_TEST(ComparePolysTest, ATouchFromEitherSideIsNoCrossing) {
  // (1, 1) touches the plane from the front, between two crossings.
  this->expect_halves({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}},
                      {{0, 0}, {1, 0}, {1, 2, false}, {0, 2}, {1, 1}},
                      {{1, 0, false}, {2, 0}, {2, 2}, {1, 2}});
  this->expect_halves({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}},
                      {{0, 0}, {1, 0}, {1, 2, false}, {0, 2}},
                      {{1, 0, false}, {2, 0}, {1, 1}, {2, 2}, {1, 2}});
}

TYPED_TEST(ComparePolysTest, ACombIsCutAtEveryTooth) {
  // Three teeth to x = 2 from a back at x = 0: each half is one polygon, whose cut sides run
  // along x = 1.
  this->expect_halves({{0, 0},
                       {2, 0},
                       {2, 1},
                       {0.5, 1},
                       {0.5, 2},
                       {2, 2},
                       {2, 3},
                       {0.5, 3},
                       {0.5, 4},
                       {2, 4},
                       {2, 5},
                       {0, 5}},
                      {{0, 0},
                       {1, 0},
                       {1, 1, false},
                       {0.5, 1},
                       {0.5, 2},
                       {1, 2},
                       {1, 3, false},
                       {0.5, 3},
                       {0.5, 4},
                       {1, 4},
                       {1, 5, false},
                       {0, 5}},
                      {{1, 0, false},
                       {2, 0},
                       {2, 1},
                       {1, 1},
                       {1, 2, false},
                       {2, 2},
                       {2, 3},
                       {1, 3},
                       {1, 4, false},
                       {2, 4},
                       {2, 5},
                       {1, 5}});
}

TYPED_TEST(ComparePolysTest, AnInvisibleSideStaysSoInBothHalves) {
  ItemList list;
  list.solid({{0, 0, -1}, {4, 0, 3}, {0, 4, -1}});
  list.add(ItemList::Kind::solid, {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {1, 0, 1, 1});
  const SortedPieces pieces = sorted(list, ways()[0]);
  const SortJudge judge(list, pieces);
  EXPECT_EQ(judge.outlines(), "");
  EXPECT_EQ(pieces.cuts, 1u);
}

TYPED_TEST(ComparePolysTest, ALineIsCutInTwoThatBothAreDrawn) {
  const auto [front, back] = AgainstPlane<TypeParam>({{0, 0, 0}, {4, 2, 0}}).split();
  EXPECT_EQ(front, (Half{{0, 0, false}, {1, 0.5}}));
  EXPECT_EQ(back.size(), 2u);
  EXPECT_EQ(back[1], (Side{4, 2}));
  EXPECT_EQ(back[0].x, 1.0);
  EXPECT_EQ(back[0].y, 0.5);
  const auto [near, far] = AgainstPlane<TypeParam>({{4, 2, 0}, {0, 0, 0}}).split();
  EXPECT_EQ(far, (Half{{4, 2, false}, {1, 0.5}}));
  EXPECT_EQ(near[1], (Side{0, 0}));
}

// ---- How many cuts ------------------------------------------------------------------------------

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

// ---- Bad input and scale ------------------------------------------------------------------------

TEST_P(EveryWay, NothingAtAll) {
  const SortedPieces pieces = sorted({}, GetParam());
  EXPECT_TRUE(pieces.pieces.empty());
  EXPECT_EQ(pieces.cuts, 0u);
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
  const bool chain = GetParam().root == RootChoice::last && GetParam().method == HiddenMethod::bsp;
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
  const bool chain = GetParam().root == RootChoice::last && GetParam().method == HiddenMethod::bsp;
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
  EXPECT_THROW(sort_hidden_surfaces({}, HiddenMethod::z_buffer, {}), Error);
  EXPECT_THROW(sort_hidden_surfaces({}, HiddenMethod::none, {}), Error);
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
        // With ROUNDOFF 0 a polygon that is in a plane but for rounding is cut anywhere.
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

// ---- Cycles of a graph --------------------------------------------------------------------------

TEST(DrawingGraphTest, CyclesAreThoseThatReachEachOther) {
  Source s(1);
  for (int trial = 0; trial < 300; ++trial) {
    const int n = s.between(1, 12), edges = s.between(0, 24);
    std::vector<std::vector<DrawingGraph::Node>> later(static_cast<std::size_t>(n));
    for (int k = 0; k < edges; ++k) {
      later[static_cast<std::size_t>(s.below(n))].push_back(
          static_cast<DrawingGraph::Node>(s.below(n)));
    }
    DrawingGraph graph;
    for (const auto& of : later) {
      graph.first.push_back(graph.later.size());
      graph.later.insert(graph.later.end(), of.begin(), of.end());
    }
    graph.first.push_back(graph.later.size());
    const auto size = static_cast<std::size_t>(n);
    std::vector<std::vector<bool>> reaches(size, std::vector<bool>(size));
    for (std::size_t i = 0; i < size; ++i) {
      reaches[i][i] = true;
      for (const auto j : later[i]) reaches[i][j] = true;
    }
    for (std::size_t via = 0; via < size; ++via) {
      for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) {
          if (reaches[i][via] && reaches[via][j]) reaches[i][j] = true;
        }
      }
    }
    const DrawingCycles cycles = find_cycles(graph);
    std::set<DrawingGraph::Node> numbers(cycles.of.begin(), cycles.of.end());
    EXPECT_EQ(numbers.size(), cycles.count);
    EXPECT_LT(*numbers.rbegin(), cycles.count);
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) {
        EXPECT_EQ(cycles.of[i] == cycles.of[j], reaches[i][j] && reaches[j][i]);
        if (reaches[i][j]) {
          EXPECT_GE(cycles.of[i], cycles.of[j]);
        }
      }
    }
  }
}

TEST(DrawingGraphTest, AChainOfAMillion) {
  constexpr DrawingGraph::Node kNodes = 1000000 / kSlower;
  DrawingGraph graph;
  for (DrawingGraph::Node i = 0; i < kNodes; ++i) {
    graph.first.push_back(i);
    graph.later.push_back(i + 1 == kNodes ? kNodes / 2 : i + 1);
  }
  graph.first.push_back(kNodes);
  const DrawingCycles cycles = find_cycles(graph);
  EXPECT_EQ(cycles.count, kNodes / 2 + 1);
  EXPECT_EQ(cycles.of[kNodes - 1], 0u);
  EXPECT_EQ(cycles.of[0], cycles.count - 1);
}

}  // namespace
}  // namespace displayfile
