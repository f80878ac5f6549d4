// Painting a sorted display file agrees with the definition, also where polygons touch: the
// pictures are the oracle's, to the last pixel.

#include "interp/raster/undecided_centres.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "displayfile/segments/hidden_surface_check.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "interp/truth/truth.h"
#include "tests/painted_fills.h"

namespace displayfile {
namespace {

using namespace test;

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

struct EnteredFold {
  Fills fills;  // in order of entry, with their places in it as pick identifiers
  double rise;
  bool sheet_first;
  std::string name;
};
std::vector<EnteredFold> folds_in_both_orders() {
  std::vector<EnteredFold> folds;
  for (const int axis : {0, 1, 2}) {
    for (const double rise : {-0.25, 0.25}) {
      const auto [sheet, flap] = fold(axis, rise);
      const auto name = fmt::format("axis {}, rise {}", axis, rise);
      folds.push_back({{{sheet, 0}, {flap, 1}}, rise, true, name + ", sheet first"});
      folds.push_back({{{flap, 0}, {sheet, 1}}, rise, false, name + ", flap first"});
    }
  }
  return folds;
}

TEST(UndecidedCentres, AFoldThroughCentresShowsThePolygonEnteredLater) {
  std::size_t wrong_if_heedless = 0;
  for (const auto& [fills, rise, sheet_first, name] : folds_in_both_orders()) {
    const bool in_order = (rise > 0) == sheet_first;
    const DisplayFile file = file_of(fills, in_order ? fills : Fills{fills[1], fills[0]});
    EXPECT_EQ(wrong(file, kSize, kSize), "") << name;
    wrong_if_heedless += heedless_errors(file, kSize, kSize);
  }
  EXPECT_GT(wrong_if_heedless, 0u);
}

/// A flap behind the sheet is no piece of the map, and is seen on its edge if it was entered later.
TEST(UndecidedCentres, WhatAMapLeavesOutIsSeenWhereItTouchesAndWasEnteredLater) {
  std::size_t seen = 0;
  for (const auto& [fills, rise, sheet_first, name] : folds_in_both_orders()) {
    const int pick_of_flap = sheet_first ? 1 : 0;
    for (const bool together : {false, true}) {
      DisplayFile file;
      Segment& segment = file.create(1);
      enter(segment, fills);
      segment.close();
      if (together) {
        file.set_sorted(
            hidden_surface_check(file.visible_segments(), {.method = HiddenMethod::map}));
      } else {
        segment.set_sorted(
            hidden_surface_check(segment.entered(), {}, {.method = HiddenMethod::map}));
      }
      EXPECT_EQ(wrong(file, kSize, kSize), "") << name;
      if (rise > 0.0) continue;
      seen +=
          static_cast<std::size_t>(std::ranges::count(paint(file, kSize, kSize).ids, pick_of_flap));
    }
  }
  EXPECT_GT(seen, 0u);
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

/// A segment that was not sorted is painted as entered, over centres noted before and after.
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
                        .surfaces = {.method = HiddenMethod::z_buffer},
                        .ids = true,
                        .depth = true};
  const Picture expected = draw_with_software(file, request);
  request.surfaces.method = HiddenMethod::none;
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

// ---- Noted centres -----------------------------------------------------------------------------

/// The larger of the centre's distances from the side along x and along y, roughly.
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
