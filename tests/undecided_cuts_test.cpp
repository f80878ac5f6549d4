// Painting a sorted display file agrees with the definition, also where a cut was rounded: the
// pictures are the oracle's, to the last pixel.

#include "interp/raster/undecided_centres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "tests/painted_fills.h"

namespace displayfile {
namespace {

using namespace test;

// ---- Grids, exactly ----------------------------------------------------------------------------

/// A point of a grid of kUnits to 1; pixel centres of a 16 x 16 picture are its odd multiples of 2.
constexpr std::int64_t kUnits = 64;
struct GridPoint {
  std::int64_t x, y;
};
double on_grid(std::int64_t a) { return static_cast<double>(a) / kUnits; }
GridPoint centre(int column, int row) { return {4 * column + 2, 4 * row + 2}; }

GridPoint any_centre(Dice& dice, int low, int high) {
  const int row = dice.from(low, high), column = dice.from(low, high);  // arguments have no order
  return centre(column, row);
}

using GridPolygon = std::vector<GridPoint>;

/// z = height + right x + up y, all multiples of powers of two: exact on the grid.
struct GridPlane {
  double height, right, up;
  Point3 at(double x, double y) const { return {x, y, height + right * x + up * y}; }
  Vertices through(const GridPolygon& polygon) const {
    Vertices vertices;
    for (const GridPoint& p : polygon) vertices.push_back(at(on_grid(p.x), on_grid(p.y)));
    return vertices;
  }
};

/// Half of the convex polygon: the part to the left of the line from a to b, or on it. Each
/// coordinate of a cut is one quotient of whole numbers, so it is rounded once.
Vertices left_of(const GridPolygon& polygon, const GridPlane& plane, const GridPoint& a,
                 const GridPoint& b) {
  const auto side = [&](const GridPoint& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  };
  Vertices piece;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const GridPoint& p = polygon[i];
    const GridPoint& q = polygon[(i + 1) % polygon.size()];
    const std::int64_t from = side(p), to = side(q);
    if (from >= 0) piece.push_back(plane.at(on_grid(p.x), on_grid(p.y)));
    if ((from > 0 && to < 0) || (from < 0 && to > 0)) {
      const auto cut = [&](std::int64_t u, std::int64_t v) {
        return static_cast<double>(u * (from - to) + (v - u) * from) /
               static_cast<double>((from - to) * kUnits);
      };
      piece.push_back(plane.at(cut(p.x, q.x), cut(p.y, q.y)));
    }
  }
  return piece;
}

/// Both halves, where there are two; else the polygon itself.
std::vector<Vertices> cut_in_two(const GridPolygon& polygon, const GridPlane& plane,
                                 const GridPoint& a, const GridPoint& b) {
  std::vector<Vertices> pieces = {left_of(polygon, plane, a, b), left_of(polygon, plane, b, a)};
  std::erase_if(pieces, [](const Vertices& piece) { return piece.size() < 3; });
  return pieces.size() == 2 ? pieces : std::vector<Vertices>{plane.through(polygon)};
}

// ---- Cuts that were rounded --------------------------------------------------------------------

TEST(UndecidedCentres, ATriangleCutThroughCentresAnUlpAside) {
  std::size_t wrong_if_heedless = 0;
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    Dice dice(seed);
    const GridPolygon triangle = {{dice.from(0, 64), dice.from(0, 64)},
                                  {dice.from(0, 64), dice.from(0, 64)},
                                  {dice.from(0, 64), dice.from(0, 64)}};
    const GridPlane plane{0.5, 0.25, -0.125};
    const GridPoint a = any_centre(dice, 0, 15), b = any_centre(dice, 0, 15);
    if (a.x == b.x && a.y == b.y) continue;
    const Fill whole{plane.through(triangle), 1};
    Fills painted = {kBackdrop};
    for (Vertices& piece : cut_in_two(triangle, plane, a, b)) {
      for (Point3& v : piece) {
        const bool original = std::ranges::find(whole.vertices, v) != whole.vertices.end();
        if (original) continue;
        v.x = std::nextafter(v.x, dice.from(-1, 1) * 2.0);
        v.y = std::nextafter(v.y, dice.from(-1, 1) * 2.0);
      }
      painted.push_back({piece, 1});
    }
    const DisplayFile file = file_of({kBackdrop, whole}, painted);
    ASSERT_EQ(wrong(file, kSize, kSize), "") << seed;
    wrong_if_heedless += heedless_errors(file, kSize, kSize);
  }
  EXPECT_GT(wrong_if_heedless, 30u);
}

TEST(UndecidedCentres, LevelAndNearlyLevelCutsInARowOfCentres) {
  const double c = 9.0 / 32;
  const Vertices whole = {{0.125, 0, 0.5}, {0.875, 0, 0.5}, {0.875, 1, 0.5}, {0.125, 1, 0.5}};
  std::size_t wrong_if_heedless = 0;
  for (const int left : {-1, 0, 1}) {
    for (const int right : {-1, 0, 1}) {
      for (const int right_of_upper : {-1, 0, 1}) {
        const auto moved = [&](int by) { return std::nextafter(c, by == 0 ? c : 2.0 * by); };
        Vertices lower = whole, upper = whole;
        lower[3].y = upper[0].y = moved(left);
        lower[2].y = moved(right);
        upper[1].y = moved(right_of_upper);
        const DisplayFile file =
            file_of({kBackdrop, {whole, 1}}, {kBackdrop, {lower, 1}, {upper, 1}});
        EXPECT_EQ(wrong(file, kSize, kSize), "") << left << ' ' << right << ' ' << right_of_upper;
        wrong_if_heedless += heedless_errors(file, kSize, kSize);
      }
    }
  }
  EXPECT_GT(wrong_if_heedless, 0u);
}

/// A strip of one row of centres is lost: its two sides were rounded to the same.
TEST(UndecidedCentres, APieceRoundedToNoAreaCountsAsCovering) {
  const double c = 9.0 / 32;
  const Vertices strip = {{0.125, std::nextafter(c, 0.0), 0.5},
                          {0.875, std::nextafter(c, 0.0), 0.5},
                          {0.875, c, 0.5},
                          {0.125, c, 0.5}};
  Vertices flat = strip;
  for (Point3& v : flat) v.y = std::nextafter(c, 0.0);
  const DisplayFile file = file_of({kBackdrop, {strip, 1}}, {kBackdrop, {flat, 1}});
  EXPECT_EQ(wrong(file, kSize, kSize), "");
  EXPECT_EQ(heedless_errors(file, kSize, kSize), 12u);
}

TEST(UndecidedCentres, SliversAlongLinesOfCentres) {
  std::size_t wrong_if_heedless = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    Dice dice(seed);
    const auto ulps = [&](double v) {
      for (int k = dice.from(0, 2); k > 0; --k) v = std::nextafter(v, dice.one_in(2) ? 2.0 : -2.0);
      return v;
    };
    Fills entered = {kBackdrop}, painted = {kBackdrop};
    for (int k = 1; k < 4; ++k) {
      const GridPoint a = any_centre(dice, -4, 20);
      const GridPoint b = any_centre(dice, -4, 20);
      const double z = k / 4.0;
      Vertices sliver = {{on_grid(a.x), on_grid(a.y), z}, {on_grid(b.x), on_grid(b.y), z}};
      sliver.push_back(0.5 * (sliver[0] + sliver[1]));
      for (Point3& v : sliver) v = {ulps(v.x), ulps(v.y), z};
      entered.push_back({sliver, k});
      for (Point3& v : sliver) v = {ulps(v.x), ulps(v.y), z};
      painted.push_back({sliver, k});
    }
    const DisplayFile file = file_of(entered, painted);
    ASSERT_EQ(wrong(file, kSize, kSize), "") << seed;
    wrong_if_heedless += heedless_errors(file, kSize, kSize);
  }
  EXPECT_GT(wrong_if_heedless, 0u);
}

// ---- Random scenes in a known order ------------------------------------------------------------

GridPolygon random_triangle(Dice& dice) {
  const auto point = [&] { return GridPoint{2 * dice.from(-8, 40), 2 * dice.from(-8, 40)}; };
  return {point(), point(), point()};
}

/// The pieces of a polygon, cut along a line of centres more often than not.
void paint_cut(Dice& dice, const GridPolygon& polygon, const GridPlane& plane, int pick,
               Fills& painted) {
  const GridPoint a = any_centre(dice, 0, 15);
  GridPoint b = any_centre(dice, 0, 15);
  if (a.x == b.x && a.y == b.y) b.x += 4;
  if (dice.one_in(3)) {
    painted.push_back({plane.through(polygon), pick});
    return;
  }
  for (Vertices& piece : cut_in_two(polygon, plane, a, b)) painted.push_back({piece, pick});
}

/// Which polygon is entered k-th.
std::vector<int> shuffled(Dice& dice, int n) {
  std::vector<int> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  for (int k = n - 1; k > 0; --k) {
    std::swap(order[static_cast<std::size_t>(k)], order[static_cast<std::size_t>(dice.from(0, k))]);
  }
  return order;
}

struct Sheet {
  GridPolygon polygon;
  GridPlane plane;
  int pick;
  double nearness;
  int side = 0;  ///< of a line that all meet
};

/// Expects no wrong centre of sheets that are cut and painted in this order. Returns the number
/// that a painter without undecided centres gets wrong.
std::size_t expect_right_though_cut(Dice& dice, const std::vector<Sheet>& sheets,
                                    const Fills& entered) {
  Fills painted;
  for (const Sheet& s : sheets) paint_cut(dice, s.polygon, s.plane, s.pick, painted);
  const DisplayFile file = file_of(entered, painted);
  EXPECT_EQ(wrong(file, kSize, kSize), "");
  return heedless_errors(file, kSize, kSize);
}

TEST(UndecidedCentres, StacksOfParallelSheetsCutThroughCentres) {
  std::size_t wrong_if_heedless = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    Dice dice(seed);
    const int n = 2 + static_cast<int>(seed % 9);
    std::vector<Sheet> sheets;
    Fills entered;
    for (int k = 0; k < n; ++k) {
      const GridPolygon polygon = random_triangle(dice);
      const double height = dice.from(0, 3) / 8.0;
      const GridPlane plane{height, 0.5, -0.25};
      sheets.push_back({polygon, plane, k, height});
      entered.push_back({plane.through(polygon), k});
    }
    std::ranges::stable_sort(sheets, {}, &Sheet::nearness);
    wrong_if_heedless += expect_right_though_cut(dice, sheets, entered);
    ASSERT_FALSE(HasFailure()) << seed;
  }
  EXPECT_GT(wrong_if_heedless, 30u);
}

/// Half-sheets that meet in one line of centres, each at its own slope: on either side of the
/// line the slopes are the order, and on it all are equally near.
TEST(UndecidedCentres, FansAboutALineOfCentres) {
  std::size_t wrong_if_heedless = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    Dice dice(seed);
    const int axis = dice.from(0, 2), n = 2 + static_cast<int>(seed % 7);
    const std::int64_t c = centre(dice.from(2, 13), 0).x;
    // The distance of a point from the axis x = c, y = c or x = y, in units of the grid.
    const auto aside = [&](const GridPoint& p) {
      return axis == 0 ? p.x - c : axis == 1 ? p.y - c : p.x - p.y;
    };
    const auto plane = [&](double slope) {
      const double middle = 0.5 - slope * on_grid(c);
      return axis == 0   ? GridPlane{middle, slope, 0}
             : axis == 1 ? GridPlane{middle, 0, slope}
                         : GridPlane{0.5, slope, -slope};
    };
    const auto on_axis = [&] {
      const std::int64_t along = 2 * dice.from(-2, 34);
      return axis == 0   ? GridPoint{c, along}
             : axis == 1 ? GridPoint{along, c}
                         : GridPoint{along, along};
    };
    std::vector<Sheet> sheets;
    Fills entered;
    for (const int k : shuffled(dice, n)) {
      GridPolygon polygon = {on_axis(), on_axis(), {2 * dice.from(0, 32), 2 * dice.from(0, 32)}};
      const std::int64_t distance = aside(polygon[2]);
      if (distance == 0 || aside(polygon[0]) != 0) continue;
      const double slope = dice.from(-4, 4) / 4.0;
      const int side = distance > 0 ? 1 : -1;
      sheets.push_back({polygon, plane(slope), k, side * slope, side});
      entered.push_back({plane(slope).through(polygon), k});
    }
    std::ranges::stable_sort(sheets, {}, &Sheet::nearness);
    if (dice.one_in(2)) std::ranges::stable_sort(sheets, {}, &Sheet::side);
    wrong_if_heedless += expect_right_though_cut(dice, sheets, entered);
    ASSERT_FALSE(HasFailure()) << seed;
  }
  EXPECT_GT(wrong_if_heedless, 30u);
}

}  // namespace
}  // namespace displayfile
