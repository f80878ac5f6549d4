// The drawn pieces, as arrays.

#include "interp/device/output_device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "displayfile/segments/sorted_display_file.h"
#include "interp/draw/draw.h"
#include "tests/gallery.h"
#include "tests/polygon_area.h"
#include "tests/slower.h"

namespace displayfile {
namespace {

DrawnPieces pieces_by(const GraphicsSystem& system, HiddenMethod method) {
  SortedDisplayFile sorted;
  HiddenSurfaceOptions options;
  options.method = method;
  return drawn_pieces(sorted.update(system, method, options));
}

std::span<const Point3> points_of(const DrawnPieces& pieces, std::size_t k) {
  return std::span(pieces.points).subspan(pieces.first[k], pieces.first[k + 1] - pieces.first[k]);
}

using test::area;

/// A view in which world coordinates are device coordinates.
void set_device_view(GraphicsSystem& system) {
  system.set_window(0, 1, 0, 1);
  system.set_view_depth(-1, 0);
}

/// Two squares that pass through each other: one half of each is visible.
GraphicsSystem crossing_squares(LineStyle::Kind lines = LineStyle::Kind::none) {
  GraphicsSystem system;
  set_device_view(system);
  system.set_line_style({lines});
  system.open_segment(7);
  system.set_pick_id(3);
  system.set_fill_style({FillStyle::Kind::solid, {1, 0, 0}});
  system.polygon_abs_3({{0, 0, 0}, {1, 0, 1}, {1, 1, 1}, {0, 1, 0}});
  system.set_pick_id(4);
  system.set_fill_style({FillStyle::Kind::solid, {0, 0, 1}});
  system.polygon_abs_3({{0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}});
  system.close_segment();
  return system;
}

TEST(DrawnPieces, OfASortTileEachPolygon) {
  const GraphicsSystem system = crossing_squares();
  for (const HiddenMethod method : {HiddenMethod::bsp, HiddenMethod::depth_sort}) {
    const DrawnPieces pieces = pieces_by(system, method);
    ASSERT_EQ(pieces.size(), 3u);  // one is cut
    std::map<std::int32_t, double> areas;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      EXPECT_EQ(pieces.kinds[k], DrawnPieces::Kind::solid);
      EXPECT_EQ(pieces.segments[k], 7);
      EXPECT_EQ(pieces.fills[k], pieces.picks[k] == 3 ? Colour(1, 0, 0) : Colour(0, 0, 1));
      areas[pieces.picks[k]] += area(points_of(pieces, k));
    }
    EXPECT_EQ(areas, (std::map<std::int32_t, double>{{3, 1.0}, {4, 1.0}}));
  }
}

TEST(DrawnPieces, SidesThatCutsMadeAreNotDrawn) {
  const DrawnPieces pieces = pieces_by(crossing_squares(LineStyle::Kind::solid), HiddenMethod::bsp);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(std::ranges::count(pieces.sides, 0), 2);
  EXPECT_EQ(std::ranges::count(pieces.sides, 1), std::ssize(pieces.points) - 2);
  const DrawnPieces bare = pieces_by(crossing_squares(), HiddenMethod::bsp);
  EXPECT_EQ(std::ranges::count(bare.sides, 0), std::ssize(bare.points));
}

TEST(DrawnPieces, OfTheMapTileWhatIsSeen) {
  const DrawnPieces pieces = pieces_by(crossing_squares(), HiddenMethod::map);
  ASSERT_EQ(pieces.size(), 2u);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    EXPECT_EQ(area(points_of(pieces, k)), 0.5);
    for (const Point3& p : points_of(pieces, k)) {
      EXPECT_TRUE(pieces.picks[k] == 3 ? p.x >= 0.5 : p.x <= 0.5);
    }
  }
}

/// A square and a hidden one behind it, entered in either order.
GraphicsSystem square_before_another(bool nearer_first) {
  GraphicsSystem system;
  set_device_view(system);
  system.set_line_style({LineStyle::Kind::none});
  system.open_segment(1);
  for (const bool nearer : {nearer_first, !nearer_first}) {
    const double low = nearer ? 0.0 : 0.25, high = 1.0 - low, z = nearer ? 0.75 : 0.25;
    system.set_pick_id(nearer ? 1 : 2);
    system.polygon_abs_3({{low, low, z}, {high, low, z}, {high, high, z}, {low, high, z}});
  }
  system.close_segment();
  return system;
}

TEST(DrawnPieces, OfTheAutomaticMethodAreTheVisibleOnes) {
  for (const bool nearer_first : {false, true}) {
    GraphicsSystem system = square_before_another(nearer_first);
    for (const HiddenMethod method :
         {HiddenMethod::map, HiddenMethod::automatic, HiddenMethod::colour_rule}) {
      EXPECT_EQ(pieces_by(system, method).picks, std::vector<std::int32_t>{1}) << name_of(method);
    }
    EXPECT_EQ(pieces_by(system, HiddenMethod::depth_sort).picks, (std::vector<std::int32_t>{2, 1}));
    // The same where the application set it.
    system.set_hidden_surfaces({.removal = true});
    system.set_hidden_surfaces({.method = HiddenMethod::automatic});
    SortedDisplayFile sorted;
    EXPECT_EQ(drawn_pieces(sorted.update(system, HiddenMethod::automatic)).picks,
              std::vector<std::int32_t>{1});
  }
}

TEST(DrawnPieces, OfLinesKeepTheirPicks) {
  GraphicsSystem system;
  set_device_view(system);
  system.set_line_style({LineStyle::Kind::none});
  system.open_segment(1);
  system.polygon_abs_3({{0.25, 0, 0.5}, {0.75, 0, 0.5}, {0.75, 1, 0.5}, {0.25, 1, 0.5}});
  system.set_line_style({LineStyle::Kind::dashed, {0, 1, 0}, 2.0});
  for (const int pick : {5, 9}) {
    system.set_pick_id(pick);
    system.move_abs_3(0.0, 0.1 * pick, 0.0);
    system.line_abs_3(1.0, 0.1 * pick, 0.0);
  }
  system.close_segment();
  const DrawnPieces as_entered = drawn_pieces(system.display_file());
  ASSERT_EQ(as_entered.size(), 3u);
  EXPECT_EQ(as_entered.picks, (std::vector<std::int32_t>{0, 5, 9}));
  const DrawnPieces seen = pieces_by(system, HiddenMethod::franklin);
  ASSERT_EQ(seen.size(), 4u);
  EXPECT_EQ(seen.picks, (std::vector<std::int32_t>{5, 5, 9, 9}));
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(seen.kinds[k], DrawnPieces::Kind::line);
    EXPECT_EQ(seen.line_widths[k], 2.0);
    const auto line = points_of(seen, k);
    EXPECT_EQ(line[0].x, k % 2 == 0 ? 0.0 : 0.75);
    EXPECT_EQ(line[1].x, k % 2 == 0 ? 0.25 : 1.0);
  }
}

/// Enters the pieces in device coordinates: each filled, and then its sides.
GraphicsSystem drawn_anew(const DrawnPieces& pieces) {
  GraphicsSystem system;
  set_device_view(system);
  system.open_segment(1);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto points = points_of(pieces, k);
    if (pieces.kinds[k] == DrawnPieces::Kind::solid) {
      system.set_fill_style({FillStyle::Kind::solid, pieces.fills[k]});
      system.set_line_style({LineStyle::Kind::none});
      system.polygon_abs_3(points);
    }
    system.set_line_style(pieces.looks(k).line);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point3& from = points[i == 0 ? points.size() - 1 : i - 1];
      if (pieces.sides[pieces.first[k] + i] == 0) continue;
      system.move_abs_3(from.x, from.y, from.z);
      system.line_abs_3(points[i].x, points[i].y, points[i].z);
    }
  }
  system.close_segment();
  return system;
}

/// True if each piece has one colour and there are no texts.
bool is_of_pieces(const GraphicsSystem& system) {
  bool plain =
      system.looks().attributes.shading == Shading::flat && !system.looks().attributes.shadows;
  for (const Segment& segment : system.display_file().segments()) {
    plain = plain && !segment.entered()->has_texts() && !segment.has_annotations();
  }
  return plain;
}

/// Drawn one after another, they give the picture of the sort.
TEST(DrawnPieces, DrawnAnewMakeThePicture) {
  int compared = 0;
  test::Share share;
  test::for_each_in_gallery([&](const std::string& name, const test::Retained& retained) {
    if (!is_of_pieces(retained.system)) return;
    for (const HiddenMethod method :
         {HiddenMethod::none, HiddenMethod::bsp, HiddenMethod::map, HiddenMethod::franklin}) {
      if (!share.takes_next()) continue;
      DrawOptions options{.samples = 1};
      options.width = options.height = 128;
      options.background = Background{Background::Kind::solid, Colour(1.0)};
      options.surfaces.method = method;
      options.crumbs = true;  // pieces are all that is seen
      const Picture picture = draw(retained.system, options);
      options.surfaces.method = HiddenMethod::none;
      const Picture anew = draw(drawn_anew(pieces_by(retained.system, method)), options);
      std::size_t differ = 0;
      for (std::size_t p = 0; p < picture.pixels.size(); ++p) {
        differ += picture.pixels[p] != anew.pixels[p] ? 1 : 0;
      }
      // A side that was cut is scan-converted in parts, and its ends are rounded.
      const bool cuts = method == HiddenMethod::bsp || method == HiddenMethod::map;
      EXPECT_LE(differ, cuts ? picture.pixels.size() / 100 : 0)
          << name << " by " << name_of(method);
      ++compared;
    }
  });
  EXPECT_GT(compared, 60 / test::kShare);
}

}  // namespace
}  // namespace displayfile
