// Painting a sorted display file shows what the definition says, also where a cut was rounded and
// where polygons touch: the pictures are the oracle's, to the last pixel.

#include "interp/raster/undecided_centres.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

#include "interp/raster/software.h"
#include "interp/truth/truth.h"
#include "tests/order_of_entry.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

using test::Dice;
using test::Vertices;

/// A polygon, or a piece of one.
struct Fill {
  Vertices vertices;
  int pick = 0;
};
using Fills = std::vector<Fill>;

Colour colour_of(int pick) { return {pick % 5 / 4.0, pick / 5 % 5 / 4.0, pick / 25 % 5 / 4.0}; }

template <class Instructions>
void enter(Instructions& instructions, const Fills& fills) {
  instructions.set_style(LineStyle{LineStyle::Kind::none});
  for (const Fill& fill : fills) {
    instructions.set_style(FillStyle{FillStyle::Kind::solid, colour_of(fill.pick)});
    instructions.set_pick(fill.pick);
    instructions.enter_polygon(fill.vertices, std::vector<std::uint8_t>(fill.vertices.size(), 1));
  }
}

void enter_segment(DisplayFile& file, int name, const Fills& entered, const Fills& back_to_front) {
  Segment& segment = file.create(name);
  enter(segment, entered);
  Instructions sorted;
  enter(sorted, back_to_front);
  segment.close();
  segment.set_sorted(in_order_of_entry(std::move(sorted)));
}

DisplayFile file_of(const Fills& entered, const Fills& back_to_front) {
  DisplayFile file;
  enter_segment(file, 1, entered, back_to_front);
  return file;
}

Picture paint(const DisplayFile& file, int width, int height, bool sorted = true, int threads = 1) {
  const RasterRequest request{
      .width = width, .height = height, .sorted = sorted, .ids = true, .threads = threads};
  return draw_with_software(file, request);
}

std::size_t different(const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b) {
  std::size_t n = 0;
  for (std::size_t k = 0; k < a.size(); ++k) n += a[k] != b[k] ? 1 : 0;
  return n;
}

std::size_t heedless_errors(const DisplayFile& file, int width, int height) {
  return different(paint(file, width, height, false).ids, truth(file, width, height, false).ids);
}

/// What is wrong with the painting, for 1, 2 and 3 threads; empty if nothing.
std::string wrong(const DisplayFile& file, int width, int height,
                  const std::vector<std::int32_t>& expected) {
  std::optional<std::size_t> undecided;
  for (const int threads : {1, 2, 3}) {
    const Picture painted = paint(file, width, height, true, threads);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const std::size_t row = k / static_cast<std::size_t>(width);
      const std::size_t column = k % static_cast<std::size_t>(width);
      const std::uint32_t colour = expected[k] < 0 ? 0xFFFFFFFF : pixel_of(colour_of(expected[k]));
      if (painted.ids[k] == expected[k] && painted.pixels[k] == colour) continue;
      return fmt::format("{} threads: row {} from the top, column {}: painted {}, truth {}",
                         threads, row, column, painted.ids[k], expected[k]);
    }
    if (undecided && undecided != painted.undecided_centres) return "threads change the count";
    undecided = painted.undecided_centres;
  }
  return {};
}

std::string wrong(const DisplayFile& file, int width, int height) {
  return wrong(file, width, height, truth(file, width, height, false).ids);
}

// ---- Grids, exactly ----------------------------------------------------------------------------

/// A point of a grid of kUnits to 1; pixel centres of a 16 x 16 picture are its odd multiples of 2.
constexpr std::int64_t kUnits = 64;
constexpr int kSize = 16;
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

/// Half of the convex polygon: what is left of the line from a to b, or on it. Each coordinate of
/// a cut is one quotient of whole numbers, so it is rounded once.
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

const Fill kBackdrop{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 0};

// ---- Polygons that touch -----------------------------------------------------------------------

/// A sheet, and a flap whose edge lies on it, on a column, a row or a diagonal of centres; the
/// flap is in front of the sheet or behind it.
struct Fold {
  Vertices sheet, flap;
};
Fold fold(int axis, double rise) {
  const double c = 17.0 / 32, z = 0.5;
  Fold f{{{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}}, {}};
  switch (axis) {
    case 0:
      f.flap = {{c, 0.125, z}, {1, 0.125, z + rise}, {1, 0.875, z + rise}, {c, 0.875, z}};
      break;
    case 1:
      f.flap = {{0.125, c, z}, {0.875, c, z}, {0.875, 0, z + rise}, {0.125, 0, z + rise}};
      break;
    default: f.flap = {{0, 0, z}, {1, 0, z + rise}, {1, 1, z}};
  }
  return f;
}

TEST(UndecidedCentres, AFoldThroughCentresShowsThePolygonEnteredLater) {
  std::size_t wrong_if_heedless = 0;
  for (const int axis : {0, 1, 2}) {
    for (const double rise : {-0.25, 0.25}) {
      for (const bool sheet_first : {false, true}) {
        const auto [sheet, flap] = fold(axis, rise);
        const Fill first{sheet_first ? sheet : flap, 0}, second{sheet_first ? flap : sheet, 1};
        const bool in_order = (rise > 0) == sheet_first;
        const Fills back_to_front = in_order ? Fills{first, second} : Fills{second, first};
        const DisplayFile file = file_of({first, second}, back_to_front);
        EXPECT_EQ(wrong(file, kSize, kSize), "") << axis << ' ' << rise << ' ' << sheet_first;
        wrong_if_heedless += heedless_errors(file, kSize, kSize);
      }
    }
  }
  EXPECT_GT(wrong_if_heedless, 0u);
}

TEST(UndecidedCentres, TwoPolygonsWithACommonSideInBothOrders) {
  const double c = 17.0 / 32;
  for (const double far : {0.25, 0.75}) {  // a ridge and a valley
    const Vertices left = {{0, 0, far}, {c, 0, 0.5}, {c, 1, 0.5}, {0, 1, far}};
    const Vertices right = {{c, 0, 0.5}, {1, 0, far}, {1, 1, far}, {c, 1, 0.5}};
    for (const bool swapped : {false, true}) {
      for (const bool painted_swapped : {false, true}) {
        Fills entered = {{left, 0}, {right, 1}};
        if (swapped) std::swap(entered[0], entered[1]);
        Fills painted = entered;
        if (painted_swapped) std::swap(painted[0], painted[1]);
        EXPECT_EQ(wrong(file_of(entered, painted), kSize, kSize), "");
      }
    }
  }
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

/// Expects no wrong centre of sheets that are cut and painted in this order. Returns how many a
/// painter gets wrong that does not heed them.
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
    // How far a point is from the axis x = c, y = c or x = y, in units of the grid.
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

TEST(UndecidedCentres, ManyCoincidentPolygonsShowTheLast) {
  const Vertices diagonal = {{0, 0, 0.5}, {1, 0, 0.25}, {1, 1, 0.5}};
  Fills fills = {kBackdrop};
  for (int k = 1; k < 500; ++k) fills.push_back({diagonal, k % 100});
  EXPECT_EQ(wrong(file_of(fills, fills), 64, 64), "");
}

TEST(UndecidedCentres, HugeCoordinatesLeaveTheWholePictureToBeDecided) {
  const double far = 0x1p60;
  const Fill near{{{-far, -far, 0.5}, {far, -far, 0.5}, {0, far, 0.5}}, 1};
  const DisplayFile file = file_of({near, kBackdrop}, {kBackdrop, near});
  EXPECT_EQ(wrong(file, kSize, kSize), "");
  EXPECT_EQ(paint(file, kSize, kSize).undecided_centres, 256u);
}

// ---- Segments ----------------------------------------------------------------------------------

/// Each was sorted by itself: the later one is seen although it is behind.
TEST(UndecidedCentres, ALaterSegmentCoversAnEarlierOne) {
  const auto [sheet, flap] = fold(2, -0.25);
  const Fill near{{{0.25, 0.25, 1}, {0.75, 0.25, 1}, {0.75, 0.75, 1}, {0.25, 0.75, 1}}, 0};
  DisplayFile file;
  enter_segment(file, 1, {near}, {near});
  enter_segment(file, 2, {{sheet, 1}, {flap, 2}}, {{flap, 2}, {sheet, 1}});
  file.segment(1).visible = false;
  std::vector<std::int32_t> expected = truth(file, kSize, kSize, false).ids;
  file.segment(1).visible = true;
  EXPECT_EQ(wrong(file, kSize, kSize, expected), "");

  DisplayFile other_way;
  enter_segment(other_way, 1, {{sheet, 1}, {flap, 2}}, {{flap, 2}, {sheet, 1}});
  enter_segment(other_way, 2, {near}, {near});
  const auto of_near = truth(file_of({near}, {near}), kSize, kSize, false).ids;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (of_near[k] >= 0) expected[k] = of_near[k];
  }
  EXPECT_EQ(wrong(other_way, kSize, kSize, expected), "");
}

/// A segment that was not sorted is painted as entered, over what is noted before and after.
TEST(UndecidedCentres, ASegmentThatWasNotSortedIsPaintedInOrder) {
  const auto [sheet, flap] = fold(2, -0.25);
  const Vertices square = {{0.25, 0.25, 1}, {0.75, 0.25, 1}, {0.75, 0.75, 1}, {0.25, 0.75, 1}};
  Vertices behind = square;
  for (Point3& v : behind) v.z = 0;
  DisplayFile file;
  enter_segment(file, 1, {{sheet, 1}, {flap, 2}}, {{flap, 2}, {sheet, 1}});
  enter(file.create(2), Fills{{square, 3}, {behind, 4}});
  std::vector<std::int32_t> expected =
      truth(file_of({{sheet, 1}, {flap, 2}}, {}), kSize, kSize, false).ids;
  const auto of_square = truth(file_of({{behind, 4}}, {}), kSize, kSize, false).ids;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (of_square[k] >= 0) expected[k] = of_square[k];
  }
  EXPECT_EQ(wrong(file, kSize, kSize, expected), "");
}

/// The sorted pieces are moved, and rounded anew, with the segment.
TEST(UndecidedCentres, ASegmentMovedAfterItWasSorted) {
  const double z = 0.5;
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    Dice dice(seed);
    const double lean = std::ldexp(1.0, -dice.from(2, 48));
    const auto [sheet, flap] = fold(dice.from(0, 2), dice.one_in(2) ? lean : -lean);
    const bool in_front = flap[1].z > z || flap[2].z > z;
    const Fill a{sheet, 0}, b{flap, 1};
    DisplayFile file = file_of({a, b}, in_front ? Fills{a, b} : Fills{b, a});
    test::scenes::turned_and_moved(dice, file.segment(1).image);
    ASSERT_EQ(wrong(file, kSize, kSize), "") << seed;
  }
}

// ---- Lines, depth, cost ------------------------------------------------------------------------

TEST(UndecidedCentres, ALinePaintedOverAFillStays) {
  const auto [sheet, flap] = fold(2, 0.25);
  DisplayFile file;
  Segment& segment = file.create(1);
  enter(segment, Fills{{flap, 2}, {sheet, 1}});
  Instructions sorted;
  enter(sorted, Fills{{sheet, 1}});
  sorted.set_style(LineStyle{LineStyle::Kind::solid, {1, 0, 0}});
  sorted.set_pick(2);
  sorted.enter_polygon(flap, std::vector<std::uint8_t>{1, 0, 0});  // the diagonal
  segment.close();
  segment.set_sorted(in_order_of_entry(std::move(sorted)));
  const Picture painted = paint(file, kSize, kSize);
  EXPECT_EQ(painted.ids, truth(file, kSize, kSize, false).ids);
  for (std::size_t k = 0; k < kSize; ++k) {
    const std::size_t at = (kSize - 1 - k) * kSize + k;
    EXPECT_EQ(painted.ids[at], 1);
    EXPECT_EQ(painted.pixels[at], pixel_of({1, 0, 0}));
  }
}

TEST(UndecidedCentres, DepthIsThatOfThePolygonsAsEntered) {
  const auto [sheet, flap] = fold(1, 0.25);
  const Fill a{sheet, 0}, b{flap, 1};
  const DisplayFile file = file_of({b, a}, {a, b});
  RasterRequest request{.width = kSize,
                        .height = kSize,
                        .method = HiddenMethod::z_buffer,
                        .ids = true,
                        .depth = true};
  const Picture expected = draw_with_software(file, request);
  request.method = HiddenMethod::none;
  request.sorted = true;
  const Picture painted = draw_with_software(file, request);
  EXPECT_EQ(painted.depth, expected.depth);
  EXPECT_EQ(painted.ids, expected.ids);
  EXPECT_LT(painted.undecided_centres, 100u);
}

TEST(UndecidedCentres, NothingIsNotedAwayFromTheCentres) {
  Dice dice(7);
  Fills fills;
  for (int k = 0; k < 100; ++k) fills.push_back({test::scenes::anything(dice), k});
  const DisplayFile file = file_of(fills, fills);
  EXPECT_EQ(paint(file, 100, 100).undecided_centres, 0u);
  EXPECT_EQ(paint(file, 100, 100, false).undecided_centres, 0u);
}

// ---- What is noted -----------------------------------------------------------------------------

/// How far the centre is from the side along x and along y, whichever is more; roughly.
double distance(const Point2& a, const Point2& b, const Point2& c, const Point2& unit) {
  const Point2 u = (b - a) / unit, v = (c - a) / unit;
  const double length = u.x * u.x + u.y * u.y;
  const double t = length > 0.0 ? std::clamp((u.x * v.x + u.y * v.y) / length, 0.0, 1.0) : 0.0;
  const Point2 apart = v - t * u;
  return std::hypot(apart.x, apart.y);
}

/// All centres within the error are noted, none that is far beyond it.
TEST(UndecidedCentres, WhatIsNotedIsWhatIsClose) {
  const PictureSize size{kSize, kSize};
  ScanConverter converter;
  std::size_t close = 0;
  for (std::uint32_t seed = 0; seed < 3000; ++seed) {
    Dice dice(seed);
    const auto coordinate = [&] {
      const double on_centre = (2 * dice.from(-8, 24) + 1) / 32.0;
      switch (dice.from(0, 3)) {
        case 0: return on_centre;
        case 1: return on_centre + dice.from(-40, 40) * 0x1p-53;
        case 2: return on_centre + dice.from(-1, 1) * std::ldexp(1.0, -dice.from(5, 50));
        default: return test::scenes::step(dice, 7);
      }
    };
    const Vertices polygon = test::polygon(dice.from(3, 5), [&] {
      const double x = coordinate(), y = coordinate();
      return Point3{x, y, 0.0};
    });
    PixelSet noted(kSize, 0, kSize);
    const Point2 error = boundary_error(polygon, size);
    note_rows_of_vertices(polygon, error, size, noted);
    converter.begin(polygon, {size, 0, kSize});
    converter.watch(error);
    converter.scan([](int, int, int) {},
                   [&](int row, int first, int end) { noted.add(row, first, end); });
    const Point2 unit = error / static_cast<double>(kSize);
    for (int row = 0; row < kSize; ++row) {
      for (int column = 0; column < kSize; ++column) {
        const Point2 at((2 * column + 1) / 32.0, (2 * row + 1) / 32.0);
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
          const Point2 a(polygon[i]), b(polygon[(i + 1) % polygon.size()]);
          nearest = std::min(nearest, distance(a, b, at, unit));
        }
        if (nearest < 0.75) {
          ++close;
          ASSERT_TRUE(noted.contains(row, column)) << seed << ' ' << row << ' ' << column;
        } else if (nearest > 32.0) {
          ASSERT_FALSE(noted.contains(row, column)) << seed << ' ' << row << ' ' << column;
        }
      }
    }
  }
  EXPECT_GT(close, 3000u);
}

}  // namespace
}  // namespace displayfile
