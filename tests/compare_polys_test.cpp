// COMPARE-POLYS (hidden/sort/sort_polygons.h) on cases solved by hand: the side of a plane, and the
// halves of polygons that it cuts.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

#include "hidden/sort/sort_polygons.h"
#include "tests/sort_truth.h"

namespace displayfile {
namespace {

using namespace test;

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
      sides.push_back({p.x, p.y, side.visible != 0});
    }
    return sides.size() == 2 ? sides : normal(sides);
  }

  ItemList list_;
  Primitives items_;
  std::optional<SortTables<Policy>> scene_;
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

}  // namespace
}  // namespace displayfile
