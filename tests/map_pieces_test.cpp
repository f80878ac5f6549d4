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

#include "tests/slower.h"
#include "tests/sort_scenes.h"

namespace displayfile {
namespace {

using namespace test;

double cross(const Point2& p, const Point2& q) { return p.x * q.y - p.y * q.x; }

/// Twice what is seen of each item, from the edges beside it.
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

/// The items whose pieces have another area than what the map shows of them, in words.
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
