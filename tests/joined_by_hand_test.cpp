// Joining of pieces that are written by hand.

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "interp/python/join_pieces.h"
#include "tests/sort_scenes.h"

namespace displayfile {
namespace {

using test::Loop;

struct Piece {
  std::int32_t pick;
  Loop corners;
};

/// The picks of the joined pieces in their order, and the number of corners of each.
std::vector<std::pair<std::int32_t, std::size_t>> joined(const std::vector<Loop>& polygons,
                                                         const std::vector<Piece>& in_order) {
  std::vector<std::uint32_t> sides;
  std::vector<Point3> points;
  for (const Loop& polygon : polygons) {
    sides.push_back(static_cast<std::uint32_t>(polygon.size()));
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  DrawnPieces pieces;
  for (const auto& [pick, corners] : in_order) {
    pieces.points.insert(pieces.points.end(), corners.begin(), corners.end());
    pieces.sides.resize(pieces.points.size(), 1);
    pieces.cuts.resize(pieces.points.size(), 0);
    const auto kind = corners.size() == 2 ? DrawnPieces::Kind::line : DrawnPieces::Kind::solid;
    pieces.end_piece({.kind = kind, .fill = {}, .line = {}, .pick = pick, .segment = 1});
  }
  python::join_pieces(sides, points, pieces);
  std::vector<std::pair<std::int32_t, std::size_t>> result;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    result.emplace_back(pieces.picks[k], pieces.first[k + 1] - pieces.first[k]);
  }
  return result;
}

Loop box(double x_min, double x_max, double y_min = 0.2, double y_max = 0.8) {
  return {{x_min, y_min, 0.5}, {x_max, y_min, 0.5}, {x_max, y_max, 0.5}, {x_min, y_max, 0.5}};
}

using Joined = std::vector<std::pair<std::int32_t, std::size_t>>;

TEST(JoinPieces, PiecesThatNothingCoversAreOnePolygonAgain) {
  const Loop whole = box(0.2, 0.8);
  EXPECT_EQ(joined({whole}, {{0, box(0.2, 0.5)}, {0, box(0.5, 0.8)}}), (Joined{{0, 4}}));
  // The piece drawn between covers neither.
  EXPECT_EQ(
      joined({whole, box(0.8, 0.9)}, {{0, box(0.2, 0.5)}, {1, box(0.8, 0.9)}, {0, box(0.5, 0.8)}}),
      (Joined{{1, 4}, {0, 4}}));
  // It covers the first, which stays where it is.
  EXPECT_EQ(
      joined({whole, box(0.3, 0.4)}, {{0, box(0.2, 0.5)}, {1, box(0.3, 0.4)}, {0, box(0.5, 0.8)}}),
      (Joined{{0, 4}, {1, 4}, {0, 4}}));
}

/// A line is drawn with a width: a polygon that only touches it would cover half of that.
TEST(JoinPieces, APieceThatALineTouchesStaysBeforeIt) {
  const Loop along_its_side{{0.2, 0.1, 0.5}, {0.2, 0.9, 0.5}};
  const Loop apart{{0.1, 0.1, 0.5}, {0.1, 0.9, 0.5}};
  const std::vector<Loop> polygons{box(0.2, 0.8)};
  EXPECT_EQ(joined(polygons, {{0, box(0.2, 0.5)}, {7, along_its_side}, {0, box(0.5, 0.8)}}),
            (Joined{{0, 4}, {7, 2}, {0, 4}}));
  EXPECT_EQ(joined(polygons, {{0, box(0.2, 0.5)}, {7, apart}, {0, box(0.5, 0.8)}}),
            (Joined{{7, 2}, {0, 4}}));
}

/// Filled even-odd, a polygon would have a hole where two pieces of it overlap.
TEST(JoinPieces, PiecesThatOverlapEachOtherAreNotOnePolygon) {
  EXPECT_EQ(joined({box(0.2, 0.8)}, {{0, box(0.2, 0.6)}, {0, box(0.4, 0.8)}}),
            (Joined{{0, 4}, {0, 4}}));
}

/// A corner that is repeated is a side of length 0, which separates nothing.
TEST(JoinPieces, ARepeatedCornerSeparatesNothing) {
  Loop first = box(0.2, 0.5);
  first.push_back(first.back());
  EXPECT_EQ(
      joined({box(0.2, 0.8), box(0.3, 0.4)}, {{0, first}, {1, box(0.3, 0.4)}, {0, box(0.5, 0.8)}}),
      (Joined{{0, 5}, {1, 4}, {0, 4}}));
}

}  // namespace
}  // namespace displayfile
