// The pieces that a map is cut into (hidden/map/map_pieces.h): none is lost, and none is there
// twice.

#include "hidden/map/map_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "tests/map_truth.h"
#include "tests/slower.h"
#include "tests/sort_truth.h"

namespace displayfile {
namespace {

using namespace test;

double cross(const Point2& p, const Point2& q) { return p.x * q.y - p.y * q.x; }

/// Twice the visible area of each item, from the edges beside it.
std::vector<double> areas_in_map(const Primitives& items, const VisibleMap& map) {
  std::vector<double> areas(items.items.size(), 0.0);
  for (const auto& [from, to, left, right] : map.edges) {
    const double area = cross(map.points[from], map.points[to]);
    if (left != VisibleMap::kNothing) areas[left] += area;
    if (right != VisibleMap::kNothing) areas[right] -= area;
  }
  return areas;
}

std::vector<double> areas_of_pieces(const Primitives& items, const SortedPieces& sorted) {
  std::vector<double> areas(items.items.size(), 0.0);
  for (const SortedPiece& piece : sorted.pieces) {
    const bool whole = piece.first == SortedPiece::kWhole;
    const PointRow row = items.points_of(items.items[piece.item]);
    const auto at = [&](std::uint32_t k) {
      const std::uint32_t j = k % piece.sides;
      return Point2(whole ? row[j] : sorted.points[piece.first + j]);
    };
    double area = 0.0;
    for (std::uint32_t k = 0; k < piece.sides; ++k) area += cross(at(k), at(k + 1));
    areas[piece.item] += whole ? std::abs(area) : area;
  }
  return areas;
}

/// Describes the items whose pieces have another area than in the map.
std::string wrong_areas(const Primitives& items, const VisibleMap& map) {
  const std::vector<double> pieces = areas_of_pieces(items, pieces_of_map(items, map));
  const std::vector<double> seen = areas_in_map(items, map);
  std::ostringstream wrong;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (std::abs(pieces[i] - seen[i]) > 1e-11) {
      wrong << "item " << i << ": " << pieces[i] / 2 << " for " << seen[i] / 2 << "\n";
    }
  }
  return wrong.str();
}

/// Describes the points that are not painted exactly once by the item visible there.
std::string painted_wrongly(const ItemList& list, const std::vector<Point2>& points) {
  const Primitives items = list.view();
  const std::vector<DrawnPiece> pieces =
      drawn_pieces(list, pieces_of_map(items, visible_map(items, {})));
  const MapTruth truth(items);
  std::ostringstream wrong;
  for (const Point2& at : points) {
    std::vector<std::uint32_t> painted, right;
    for (const DrawnPiece& piece : pieces) {
      if (covers(piece.points, {at.x, at.y})) painted.push_back(piece.item);
    }
    const std::uint32_t seen = truth.seen_beside(scaled(at.x, 0), scaled(at.y, 0), 1, 0);
    if (seen != MapTruth::kNothing) right.push_back(seen);
    if (painted == right) continue;
    wrong << at.x << " " << at.y << ":";
    for (const std::uint32_t item : painted) wrong << " " << item;
    wrong << " painted, " << (right.empty() ? "nothing" : std::to_string(seen)) << " seen\n";
  }
  return wrong.str();
}

std::vector<Point2> places_within(const ItemList& list, int count, int seed) {
  Point2 low(1e300), high(-1e300);
  for (const Point3& p : list.points) {
    low = glm::min(low, Point2(p));
    high = glm::max(high, Point2(p));
  }
  Source s(static_cast<std::uint64_t>(seed));
  std::vector<Point2> places;
  for (int k = 0; k < count; ++k) {
    const double x = s.unit(), y = s.unit();
    places.push_back(low + Point2(x, y) * (high - low));
  }
  return places;
}

TEST(MapPieces, AreWhatIsSeenInEveryFamily) {
  for_each_scene_of_families(200 / kSlower, [](const ItemList& list, const auto& name, int seed) {
    EXPECT_EQ(painted_wrongly(list, places_within(list, 12, seed)), "")
        << name << ", seed " << seed;
  });
}

/// Two parts of one polygon and a hole in it meet at one point. One part is so thin there that its
/// sides have one direction when rounded.
TEST(MapPieces, FollowSidesThatRoundingPutsOnEachOther) {
  ItemList list;
  list.solid({{-0.25, -0.25, 1}, {1, 1.25, -0.5}, {-0.5, -0.5, 0.25}});
  list.solid({{1, 0.25, 1},
              {0.75, std::nextafter(0.75, 0.0), -0.5},
              {-0.5, -0.5, -0.5},
              {0.25, 1, 0.25},
              {1, -0.5, -0.5},
              {-0.5, -0.5, -0.5},
              {-0.5, -0.5, -0.5}});
  std::vector<Point2> places = places_within(list, 200, 1);
  places.emplace_back(0.03125, 0.09375);
  EXPECT_EQ(painted_wrongly(list, places), "");
}

TEST(MapPieces, HaveTheAreaOfWhatIsSeenInEveryFamily) {
  for_each_scene_of_families(300 / kSlower, [](const ItemList& list, const auto& name, int seed) {
    EXPECT_EQ(wrong_areas(list.view(), visible_map(list.view(), {})), "")
        << name << ", seed " << seed;
  });
}

/// Adds a closed line that has the item on its left.
void add_loop(VisibleMap& map, const std::vector<Point2>& loop) {
  const auto first = static_cast<std::uint32_t>(map.points.size());
  const auto count = static_cast<std::uint32_t>(loop.size());
  map.points.insert(map.points.end(), loop.begin(), loop.end());
  for (std::uint32_t k = 0; k < count; ++k) {
    map.edges.push_back({first + k, first + (k + 1) % count, 0, VisibleMap::kNothing});
  }
}

/// A corner of a hole that lies on the outline, and that rounding has put beyond it.
TEST(MapPieces, AHoleIsJoinedWhicheverOfItsCornersRoundingPutOutside) {
  const Point2 beyond(0.3, std::nextafter(0.3 / 3.0, 0.0) - 1e-17);
  ASSERT_LT(cross({3.0, 1.0}, beyond), 0.0);
  ItemList list;
  list.solid({{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}});
  for (std::size_t corner = 0; corner < 3; ++corner) {
    std::vector<Point2> hole{beyond, {0.4, 1.0}, {1.0, 1.0}};  // clockwise
    std::rotate(hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(corner), hole.end());
    VisibleMap map;
    map.whole = {0};
    add_loop(map, {{0, 0}, {3, 1}, {3, 3}, {0, 3}});
    add_loop(map, hole);
    add_loop(map, {{0, -3}, {3, -3}, {0.3, 0.05}});  // another part, which it nearly touches
    EXPECT_EQ(wrong_areas(list.view(), map), "") << corner;
    EXPECT_EQ(pieces_of_map(list.view(), map).pieces.size(), 2u) << corner;
  }
}

}  // namespace
}  // namespace displayfile
