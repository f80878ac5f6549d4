// Surfaces over a grid: cells of two triangles, whose diagonals and curves that are not drawn are
// invisible.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/views/retained_views.h"
#include "tests/error_of.h"

namespace displayfile {
namespace {

using test::expect_error;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::vector<double> wave(int x_points, int y_points) {
  std::vector<double> heights;
  for (int j = 0; j < y_points; ++j) {
    for (int i = 0; i < x_points; ++i) heights.push_back(0.3 * std::sin(0.9 * i) * std::cos(j));
  }
  return heights;
}

SurfaceGrid grid_of(int x_points, int y_points, const std::vector<double>& heights) {
  return {-0.5, 0.5, x_points, -0.4, 0.8, y_points, heights};
}

std::string dump_of(SurfaceCurves curves, const SurfaceGrid& grid) {
  GraphicsSystem g;
  g.rotate_x_3(-50);
  g.set_light({1, 2, 3});
  g.set_surface_curves(curves);
  g.open_segment(1);
  g.surface_3(grid);
  g.close_segment();
  return dump(g.display_file());
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++found;
  return found;
}

/// The same triangles, with all sides drawn.
void enter_triangles(GraphicsSystem& g, const SurfaceGrid& grid) {
  const auto at = [&](int x, int y) {
    const auto width = static_cast<std::size_t>(grid.x_points);
    const std::size_t index = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
    return Point3(grid.x(x), grid.y(y), grid.heights[index]);
  };
  int cell = 0;
  for (int j = 0; j + 1 < grid.y_points; ++j) {
    for (int i = 0; i + 1 < grid.x_points; ++i) {
      g.set_pick_id(cell++);
      g.polygon_abs_3({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      g.polygon_abs_3({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
}

/// A side that is not drawn is a move within its polygon.
std::string with_all_sides_drawn(std::string dumped) {
  for (std::size_t at = dumped.find("move "); at != dumped.npos; at = dumped.find("move ", at)) {
    dumped.replace(at, 4, "line");
  }
  return dumped;
}

TEST(Surface, IsTwoTrianglesOfEachCell) {
  const std::vector<double> heights = wave(6, 5);
  const SurfaceGrid grid = grid_of(6, 5, heights);
  const std::string surface = dump_of(SurfaceCurves::both, grid);
  GraphicsSystem g;
  g.rotate_x_3(-50);
  g.set_light({1, 2, 3});
  g.open_segment(1);
  enter_triangles(g, grid);
  g.close_segment();
  EXPECT_EQ(count(surface, "move "), 40u);  // a diagonal of each triangle
  EXPECT_EQ(with_all_sides_drawn(surface), dump(g.display_file()));
}

TEST(Surface, CurvesOfOneFamilyAreDrawnAlone) {
  const std::vector<double> heights = wave(4, 4);
  const SurfaceGrid grid = grid_of(4, 4, heights);
  for (const SurfaceCurves curves : {SurfaceCurves::x, SurfaceCurves::y}) {
    EXPECT_EQ(count(dump_of(curves, grid), "move "), 36u);  // a diagonal, and one side more
  }
  // Along x, y stays the same: all ends of sides that are drawn, seen from above.
  GraphicsSystem g;
  g.set_surface_curves(SurfaceCurves::x);
  EXPECT_EQ(g.looks().surfaces.curves, SurfaceCurves::x);
  g.open_segment(1);
  const std::vector<double> flat(4);
  g.surface_3({0, 1, 2, 0, 1, 2, flat});
  g.close_segment();
  std::istringstream lines(dump(g.display_file()));
  double last_y = 0.0;
  for (std::string word; lines >> word;) {
    double x = 0.0, y = 0.0, z = 0.0;
    if (word == "polygon") lines >> x;  // the number of sides; where it starts follows
    if (word == "polygon" || word == "move" || word == "line") {
      lines >> x >> y >> z;
      if (word == "line") {
        EXPECT_EQ(y, last_y);
      }
      last_y = y;
    }
  }
}

TEST(Surface, ACellWithAnUnknownHeightIsAHole) {
  std::vector<double> heights = wave(5, 5);
  heights[12] = kNone;  // the middle
  EXPECT_EQ(count(dump_of(SurfaceCurves::both, grid_of(5, 5, heights)), "polygon "), 2u * 12);
  std::ranges::fill(heights, kNone);
  EXPECT_EQ(count(dump_of(SurfaceCurves::both, grid_of(5, 5, heights)), "polygon "), 0u);
}

TEST(Surface, TheEndsOfItsRangesAreExact) {
  const SurfaceGrid grid{-0.1, 0.7, 12, 1.0 / 3.0, 2.0 / 3.0, 7, {}};
  EXPECT_EQ(grid.x(0), -0.1);
  EXPECT_EQ(grid.x(11), 0.7);
  EXPECT_EQ(grid.y(0), 1.0 / 3.0);
  EXPECT_EQ(grid.y(6), 2.0 / 3.0);
}

TEST(Surface, RecordedAndReplayedItIsTheSame) {
  std::vector<double> heights = wave(7, 3);
  heights[9] = kNone;
  std::ostringstream program;
  Recorder recorder(program);
  GraphicsSystem g;
  g.set_recorder(&recorder);
  g.set_surface_curves(SurfaceCurves::y);
  g.open_segment(1);
  g.surface_3(grid_of(7, 3, heights));
  g.line_rel_3(0.1, 0.1, 0.1);  // from the last point
  g.close_segment();
  GraphicsSystem again;
  replay(program.str(), "recorded", again);
  EXPECT_EQ(dump(again.display_file()), dump(g.display_file()));
  EXPECT_EQ(count(program.str(), " nan "), 1u);
  EXPECT_EQ(count(program.str(), "surface-3 "), 1u);
}

TEST(Surface, ARetainedOneIsSortedAndViewedAsItsTrianglesAre) {
  const std::vector<double> heights = wave(6, 6);
  const SurfaceGrid grid = grid_of(6, 6, heights);
  std::string dumps[2];
  for (const bool surface : {false, true}) {
    RetainedScene scene;
    GraphicsSystem g;
    g.retain(&scene);
    g.rotate_x_3(-50);
    g.set_surface_curves(SurfaceCurves::x);
    g.open_segment(1);
    surface ? g.surface_3(grid) : enter_triangles(g, grid);
    g.close_segment();
    dumps[surface] = dump(RetainedViews(scene, g.display_file(), {}).view(g.view()));
  }
  EXPECT_GT(count(dumps[1], "move "), count(dumps[0], "move "));
  EXPECT_EQ(with_all_sides_drawn(dumps[1]), with_all_sides_drawn(dumps[0]));
}

TEST(Surface, WhatCannotBeOneIsRefusedAndNothingIsEntered) {
  GraphicsSystem g;
  std::vector<double> heights(6);
  const auto enter = [&](const SurfaceGrid& grid) { return [&g, grid] { g.surface_3(grid); }; };
  expect_error(enter({0, 1, 3, 0, 1, 2, heights}), "no segment open");
  g.open_segment(1);
  expect_error(enter({0, 1, 6, 0, 1, 1, heights}), "surface of 6 x 1 points: expected 2 or more");
  expect_error(enter({0, 1, 0, 0, 1, 0, {}}), "surface of 0 x 0 points");
  expect_error(enter({0, 1, -3, 0, 1, -2, heights}), "surface of -3 x -2 points");
  expect_error(enter({1, 1, 3, 0, 1, 2, heights}), "surface from x 1 to 1: expected");
  expect_error(enter({0, 1, 3, 0, kNone, 2, heights}), "surface from y 0 to nan");
  expect_error(enter({0, 1, 3, 0, 1, 3, heights}),
               "surface of 3 x 3 points with 6 heights: expected 9");
  expect_error(enter({0, 1, 2147483647, 0, 1, 2147483647, heights}),
               "expected 4611686014132420609");
  expect_error(enter({-1e200, 1, 3, 0, 1, 2, heights}), "expected finite numbers of magnitude");
  heights[4] = std::numeric_limits<double>::infinity();
  expect_error(enter({0, 1, 3, 0, 1, 2, heights}), "height inf of point 2 2 of the surface");
  heights[4] = 1e101;
  expect_error(enter({0, 1, 3, 0, 1, 2, heights}), "expected finite numbers of magnitude");
  heights[4] = 0.0;
  g.set_vertex_normals({{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
  expect_error(enter({0, 1, 3, 0, 1, 2, heights}), "expected none before a surface");
  g.close_segment();
  EXPECT_EQ(count(dump(g.display_file()), "polygon "), 0u);
  EXPECT_EQ(g.counts().polygons, 0);
}

/// The line styles in a dump, in order, and the number of polygons in each.
std::map<std::string, int> polygons_by_style(const std::string& dumped) {
  std::map<std::string, int> polygons;
  std::string style;
  std::istringstream lines(dumped);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("line-style ")) style = line.substr(11);
    if (line.starts_with("polygon ")) ++polygons[style];
  }
  return polygons;
}

/// A roof, of which one slope is seen from above and the other from below, in the view along y.
void enter_roof(GraphicsSystem& g) {
  const std::vector<double> heights{0, 0, 2, 2, -1, -1};
  g.set_line_style({LineStyle::Kind::solid, {1, 0, 0}});
  g.open_segment(1);
  g.surface_3({-1, 1, 2, -1, 1, 3, heights});
  g.line_abs_3(0, 0, 0);
  g.close_segment();
}

void look_along_y(GraphicsSystem& g) {
  g.set_view_plane_normal({0, 1, -0.5});
  g.set_parallel({0, 1, -0.5});
  g.set_view_up({0, 0, 1});
  g.set_window(-4, 4, -4, 4);
}

TEST(Surface, EachSideHasItsLineStyle) {
  const LineStyle below{LineStyle::Kind::dashed, {0, 0, 1}, 2, 3, 4};
  struct Case {
    SurfaceSides sides;
    std::optional<LineStyle> lower;
    std::map<std::string, int> expected;
  };
  const std::string red = "solid 1 0 0 1", blue = "dashed 0 0 1 2 3 4";
  for (const auto& [sides, lower, expected] :
       {Case{SurfaceSides::both, {}, {{red, 4}}},
        Case{SurfaceSides::both, below, {{red, 2}, {blue, 2}}},
        Case{SurfaceSides::upper, below, {{red, 2}, {"none", 2}}},
        Case{SurfaceSides::lower, below, {{"none", 2}, {blue, 2}}},
        Case{SurfaceSides::lower, {}, {{"none", 2}, {red, 2}}}}) {
    for (const bool mirrored : {false, true}) {
      GraphicsSystem g;
      RetainedScene scene;
      g.retain(&scene);
      look_along_y(g);
      if (mirrored) g.scale_3(-1, 1, 1);
      g.set_surface_sides(sides);
      g.set_lower_line_style(lower);
      enter_roof(g);
      EXPECT_EQ(polygons_by_style(dump(g.display_file())), expected);
      EXPECT_EQ(g.looks().attributes.line.colour, Colour(1, 0, 0));
      EXPECT_FALSE(g.looks().attributes.dark_line);
      // From the other side, the slope seen from above is seen from below.
      View back = g.view();
      back.set_plane_normal({0, -1, -0.5});
      back.set_parallel({0, -1, -0.5});
      const std::string behind = dump(RetainedViews(scene, g.display_file(), {}).view(back));
      EXPECT_EQ(polygons_by_style(behind), expected);
    }
  }
}

/// From above it is seen, from below it is not.
TEST(Surface, ItsUpperSideIsTheLightFaceWhereItIsMirrored) {
  const std::vector<double> heights = wave(5, 4);
  for (const Point3& scale : {Point3(1, 1, 1), Point3(-1, 1, 1), Point3(1, -2, 1)}) {
    for (const double up : {1.0, -1.0}) {
      GraphicsSystem g;
      g.set_view_plane_normal({0, 0, -up});
      g.set_parallel({0, 0, -up});
      g.set_back_face_removal(true);
      g.scale_3(scale.x, scale.y, scale.z);
      g.open_segment(1);
      g.surface_3(grid_of(5, 4, heights));
      g.close_segment();
      EXPECT_EQ(count(dump(g.display_file()), "polygon "), up > 0.0 ? 24u : 0u);
    }
  }
}

TEST(Surface, AHollowSideThatIsNotDrawnStaysAndHasNoSides) {
  GraphicsSystem g;
  look_along_y(g);
  g.set_fill_style({FillStyle::Kind::hollow});
  g.set_surface_sides(SurfaceSides::upper);
  enter_roof(g);
  const std::string dumped = dump(g.display_file());
  EXPECT_EQ(count(dumped, "polygon "), 4u);
  EXPECT_EQ(count(dumped, "line "), 4u + 1u);
}

TEST(Surface, SidesAreRecorded) {
  std::ostringstream program;
  Recorder recorder(program);
  GraphicsSystem g;
  g.set_recorder(&recorder);
  look_along_y(g);
  g.set_surface_sides(SurfaceSides::lower);
  g.set_lower_line_style(LineStyle{LineStyle::Kind::solid, {0, 1, 0}, 3});
  enter_roof(g);
  g.set_lower_line_style(std::nullopt);
  GraphicsSystem again;
  replay(program.str(), "recorded", again);
  EXPECT_EQ(dump(again.display_file()), dump(g.display_file()));
  EXPECT_EQ(again.looks().surfaces.sides, SurfaceSides::lower);
  EXPECT_FALSE(again.looks().surfaces.lower_line);
  EXPECT_EQ(count(program.str(), "set-lower-line-style same"), 1u);
  expect_error(
      [&] {
        g.set_lower_line_style(LineStyle{LineStyle::Kind::solid, {0, 0, 2}});
      },
      "expected");
}

std::string error_of_program(const std::string& program) {
  GraphicsSystem g;
  return test::error_of([&] { replay(program, "p", g); });
}

TEST(Surface, ProgramsAreToldWhatIsWrongWhere) {
  EXPECT_EQ(error_of_program("open-segment 1\nsurface-3 0 1 2 0 1\n"),
            "p:2:20: surface-3: 5 arguments, expected 6 and heights: x-min x-max x-points y-min "
            "y-max y-points z ...");
  EXPECT_EQ(error_of_program("open-segment 1\nsurface-3 0 1 2 0 1 2  1 2 3\n"),
            "p:2:1: surface of 2 x 2 points with 3 heights: expected 4");
  EXPECT_NE(error_of_program("open-segment 1\nsurface-3 0 1 2 0 1 2  1 2 inf 3\n").find("p:2:28"),
            std::string::npos);
  EXPECT_NE(error_of_program("set-surface-curves z\n").find("p:1:20"), std::string::npos);
  EXPECT_NE(error_of_program("set-surface-sides left\n").find("p:1:19"), std::string::npos);
  EXPECT_NE(error_of_program("set-lower-line-style\n").find("none | same"), std::string::npos);
  EXPECT_NE(error_of_program("set-lower-line-style same 1\n").find("p:1:22"), std::string::npos);
}

}  // namespace
}  // namespace displayfile
