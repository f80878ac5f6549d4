// The drawing of surfaces and of their surroundings: the lines of one height, colours by height
// with their legend, the box, and the margins of the picture.

#include "programs/surface/surface_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "clip/view/transformation.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/looks/height_colours.h"
#include "programs/surface/contours.h"

namespace displayfile {
namespace {

constexpr double kHole = std::numeric_limits<double>::quiet_NaN();

/// A surface of heights over a range of the test's own.
template <class Height>
SurfaceData surface_of(int x_points, int y_points, Height&& height) {
  SurfaceData surface{"s", {-1.0, 3.0, x_points, 2.0, 5.0, y_points}, {}};
  for (int j = 0; j < y_points; ++j) {
    for (int i = 0; i < x_points; ++i) {
      surface.heights.push_back(height(surface.range.x(i), surface.range.y(j)));
    }
  }
  return surface;
}
SurfaceData surface_of(int x_points, int y_points, std::vector<double> heights) {
  return {"s", {-1.0, 3.0, x_points, 2.0, 5.0, y_points}, std::move(heights)};
}

using Lines = std::vector<std::array<Point3, 2>>;

double length(const std::array<Point3, 2>& line) {
  return std::hypot(line[1].x - line[0].x, line[1].y - line[0].y);
}

// ---- Lines of one height ---------------------------------------------------------------

/// On a plane each line lies at the plane's points of its height, and all of a level together are
/// as long as the plane's line is within the grid.
TEST(Contours, DivideTheHeightsEvenly) {
  const auto plane = [](double x, double y) { return 2.0 * x + y; };  // 0 to 11
  const SurfaceData surface = surface_of(8, 6, plane);
  const Lines lines = contour_lines(surface.grid(), 0.0, 11.0, 4, -7.5);
  std::map<long, double> length_of_level;
  for (const auto& line : lines) {
    const double height = plane(line[0].x, line[0].y);
    EXPECT_NEAR(plane(line[1].x, line[1].y), height, 1e-12);
    EXPECT_EQ(line[0].z, -7.5);
    EXPECT_EQ(line[1].z, -7.5);
    const double level = height / 2.2;
    EXPECT_NEAR(level, std::round(level), 1e-12);
    length_of_level[std::lround(level)] += length(line);
  }
  // Within x from -1 to 3 and y from 2 to 5: a line of that slope is sqrt(5)/2 times as long as its
  // part along y, which is 3 where it leaves by neither of the sides that x bounds.
  const double slope = std::sqrt(5.0) / 2.0;
  ASSERT_EQ(length_of_level.size(), 4u);
  EXPECT_NEAR(length_of_level[1], 2.2 * slope, 1e-12);  // y from 2 to 4.2, at x = -1
  EXPECT_NEAR(length_of_level[2], 3.0 * slope, 1e-12);
  EXPECT_NEAR(length_of_level[3], 3.0 * slope, 1e-12);
  EXPECT_NEAR(length_of_level[4], 2.2 * slope, 1e-12);  // y from 2.8 to 5
}

/// A side of triangles that has the height itself is drawn once, and a corner alone is not.
TEST(Contours, ACornerAtAHeightCountsAsAbove) {
  const SurfaceData ridge = surface_of(3, 2, {0, 1, 2, 0, 1, 2});
  const Lines along = contour_lines(ridge.grid(), 0.0, 2.0, 1, 0.0);
  double sum = 0.0;
  for (const auto& line : along) {
    EXPECT_EQ(line[0].x, 1.0);
    EXPECT_EQ(line[1].x, 1.0);
    sum += length(line);
  }
  EXPECT_EQ(sum, 3.0);
  const SurfaceData peak = surface_of(3, 3, {0, 0, 0, 0, 1, 0, 0, 0, 0});
  EXPECT_TRUE(contour_lines(peak.grid(), 0.0, 2.0, 1, 0.0).empty());
  const SurfaceData pit = surface_of(3, 3, {2, 2, 2, 2, 1, 2, 2, 2, 2});
  EXPECT_TRUE(contour_lines(pit.grid(), 0.0, 2.0, 1, 0.0).empty());
}

/// Lines of neighbouring triangles have the same ends, bit for bit: each that is not on the grid's
/// border belongs to two.
TEST(Contours, GoOnFromTriangleToTriangle) {
  const SurfaceData waves = surface_of(
      9, 7, [](double x, double y) { return std::sin(2.3 * x + 0.1) * std::cos(1.7 * y); });
  const Lines lines = contour_lines(waves.grid(), -1.0, 1.0, 5, 0.0);
  std::map<std::pair<double, double>, int> ends;
  for (const auto& line : lines) {
    for (const Point3& end : line) ++ends[{end.x, end.y}];
  }
  int inside = 0;
  for (const auto& [at, count] : ends) {
    const auto [x, y] = at;
    const bool on_border = x == -1.0 || x == 3.0 || y == 2.0 || y == 5.0;
    inside += on_border ? 0 : 1;
    EXPECT_EQ(count, on_border ? 1 : 2) << x << ' ' << y;
  }
  EXPECT_GT(inside, 100);
}

TEST(Contours, LeaveOutTheCellsOfAHole) {
  std::vector<double> heights{0, 1, 2, 0, 1, 2, 0, 1, 2};
  for (const std::size_t hole : {0u, 2u, 6u, 8u}) {  // each a corner of one cell of the four
    std::vector<double> some = heights;
    some[hole] = kHole;
    const SurfaceData surface = surface_of(3, 3, some);
    double sum = 0.0;
    for (const auto& line : contour_lines(surface.grid(), 0.0, 2.0, 3, 0.0)) sum += length(line);
    // The heights 0.5, 1 and 1.5 each have a line as long as the grid; 0.5 and 1 pass the cells
    // at the left, 1.5 those at the right.
    EXPECT_EQ(sum, hole % 3 == 0 ? 6.0 : 7.5) << hole;
  }
}

// ---- Colours by height -----------------------------------------------------------------

/// CIE L* of an sRGB colour.
double lightness(const Colour& colour) {
  const auto linear = [](double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const double y =
      0.2126 * linear(colour.r) + 0.7152 * linear(colour.g) + 0.0722 * linear(colour.b);
  return 116.0 * std::cbrt(y) - 16.0;
}

TEST(HeightColours, GrowLighterEvenly) {
  EXPECT_NEAR(lightness(height_colour(0.0)), 16.0, 0.5);
  EXPECT_NEAR(lightness(height_colour(1.0)), 91.0, 0.5);
  for (int k = 0; k < 6; ++k) {
    const double step = lightness(height_colour((k + 1) / 6.0)) - lightness(height_colour(k / 6.0));
    EXPECT_NEAR(step, 75.0 / 6.0, 1.2) << k;
  }
  for (int step = 1; step < kHeightColours; ++step) {
    EXPECT_GT(lightness(height_colour_of_step(step)), lightness(height_colour_of_step(step - 1)));
  }
  EXPECT_GT(height_colour(0.0).b, height_colour(0.0).g);        // a violet
  EXPECT_GT(height_colour(1.0).r, 2.0 * height_colour(1.0).b);  // a yellow
}

TEST(HeightColours, AreLinearBetweenSeven) {
  for (int k = 0; k < 6; ++k) {
    const Colour from = height_colour(k / 6.0), to = height_colour((k + 1) / 6.0);
    const Colour between = height_colour((k + 0.25) / 6.0);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(between[c], 0.75 * from[c] + 0.25 * to[c], 1e-12) << k;
  }
  EXPECT_EQ(height_colour(-0.5), height_colour(0.0));
  EXPECT_EQ(height_colour(1.5), height_colour(1.0));
  for (const int step : {0, 1, 31, 63}) {
    EXPECT_EQ(height_colour_of_step(step), height_colour((step + 0.5) / 64.0));
  }
}

// ---- Scenes ----------------------------------------------------------------------------

/// A routine that was called, with its numbers and words.
struct Call {
  std::string routine;
  std::vector<std::string> words;
  double number(std::size_t k) const { return std::stod(words.at(k)); }
  Point3 point() const { return {number(0), number(1), number(2)}; }
};

/// The routines that entering surfaces calls, in world coordinates.
std::vector<Call> calls_of(const std::vector<SurfaceData>& surfaces, const SurfaceLook& look,
                           GraphicsSystem& system) {
  std::ostringstream recording;
  Recorder recorder(recording);
  system.set_recorder(&recorder);
  enter_surfaces(system, surfaces, look);
  system.set_recorder(nullptr);
  std::vector<Call> calls;
  std::istringstream lines(recording.str());
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Call call;
    words >> call.routine;
    for (std::string word; words >> word;) call.words.push_back(word);
    calls.push_back(std::move(call));
  }
  return calls;
}

std::vector<Call> calls_of(const std::vector<SurfaceData>& surfaces, const SurfaceLook& look) {
  GraphicsSystem system;
  return calls_of(surfaces, look, system);
}

SurfaceLook bare() {
  SurfaceLook look;
  look.axes = look.box = false;
  return look;
}

/// The lines that are drawn with moves between them.
Lines lines_of(const std::vector<Call>& calls) {
  Lines lines;
  Point3 at(0.0);
  for (const Call& call : calls) {
    if (call.routine == "move-abs-3") at = call.point();
    if (call.routine != "line-abs-3") continue;
    lines.push_back({at, call.point()});
    at = call.point();
  }
  return lines;
}

using Corner = std::tuple<double, double, double>;
Corner corner(const Point3& p) { return {p.x, p.y, p.z}; }

/// The edges of a surface's box: nine, each once, of which none ends at the corner nearest to the
/// viewer. Returns its lowest and its highest corner.
std::array<Point3, 2> box_of(const std::vector<SurfaceData>& surfaces, SurfaceLook look) {
  look.axes = false;
  look.box = true;
  Lines lines = lines_of(calls_of(surfaces, look));
  EXPECT_GE(lines.size(), 9u);
  if (lines.size() < 9) return {};
  lines.resize(9);  // contours follow
  std::array<Point3, 2> ends{lines[0][0], lines[0][0]};
  std::map<Corner, int> corners;
  std::set<std::pair<Corner, Corner>> edges;
  for (const auto& [from, to] : lines) {
    for (const Point3& p : {from, to}) {
      ends[0] = glm::min(ends[0], p);
      ends[1] = glm::max(ends[1], p);
      ++corners[corner(p)];
    }
    edges.insert(std::minmax(corner(from), corner(to)));
    const int differ = (from.x != to.x) + (from.y != to.y) + (from.z != to.z);
    EXPECT_EQ(differ, 1) << "an edge that is not along an axis";
  }
  EXPECT_EQ(edges.size(), 9u);
  EXPECT_EQ(corners.size(), 7u);
  int with_three = 0;
  for (const auto& [at, count] : corners) with_three += count == 3 ? 1 : 0;
  EXPECT_EQ(with_three, 4);  // the farthest, and the three beside it
  return ends;
}

TEST(SurfaceScene, TheBoxHoldsAllSurfaces) {
  const SurfaceData low = surface_of(2, 2, {0.5, 1.0, kHole, 2.0});
  SurfaceData high = surface_of(2, 2, {1.5, 3.0, 2.0, 2.5});
  EXPECT_EQ(box_of({low}, {}), (std::array<Point3, 2>{Point3(-1, 2, 0.5), Point3(3, 5, 2)}));
  high.range = {0.0, 7.0, 2, -4.0, 4.0, 2};
  const std::array<Point3, 2> both{Point3(-1, -4, 0.5), Point3(7, 5, 3)};
  EXPECT_EQ(box_of({low, high}, {}), both);
  EXPECT_EQ(box_of({high, low}, {}), both);
}

TEST(SurfaceScene, TheBoxHasTheHeightsThatAreSet) {
  const SurfaceData surface = surface_of(2, 2, {0.5, 1.0, 1.0, 2.0});
  const auto heights = [&](const SurfaceLook& look) {
    const auto box = box_of({surface}, look);
    return std::array{box[0].z, box[1].z};
  };
  SurfaceLook look;
  look.heights = {-1.0, 4.0};
  EXPECT_EQ(heights(look), (std::array{-1.0, 4.0}));
  look.contours = 3;  // at the base that is set
  EXPECT_EQ(heights(look), (std::array{-1.0, 4.0}));
  look.heights = {1.0, 1.5};  // which does not hold the surface
  EXPECT_EQ(heights(look), (std::array{0.5, 2.0}));
  look.heights.reset();  // room below for them
  EXPECT_EQ(heights(look), (std::array{0.5 - 0.6 * 1.5, 2.0}));
}

TEST(SurfaceScene, AFlatSurfaceHasRoomAboveAndBelow) {
  const auto heights = [](double z) {
    const auto box = box_of({surface_of(2, 2, {z, z, z, z})}, {});
    return std::array{box[0].z, box[1].z};
  };
  EXPECT_EQ(heights(0.25), (std::array{-0.25, 0.75}));
  EXPECT_EQ(heights(-8.0), (std::array{-12.0, -4.0}));
}

/// The corner without drawn edges is the one nearest to the eye.
TEST(SurfaceScene, TheBoxIsOpenToTheViewer) {
  const SurfaceData surface = surface_of(2, 2, {0.0, 1.0, 1.0, 2.0});
  for (const double azimuth : {30.0, 120.0, 210.0, 300.0}) {
    for (const double elevation : {-25.0, 25.0}) {
      SurfaceLook look = bare();
      look.box = true;
      look.camera.eye = EyeDirection{azimuth, elevation};
      look.camera.upright = upright("z");
      const std::vector<SurfaceData> surfaces{surface};
      GraphicsSystem system;
      enter_surfaces(system, surfaces, look);
      std::set<Corner> drawn;
      for (const auto& [from, to] : lines_of(calls_of(surfaces, look))) {
        drawn.insert(corner(from));
        drawn.insert(corner(to));
      }
      Point3 nearest(0.0);
      double depth = -std::numeric_limits<double>::infinity();
      for (int k = 0; k < 8; ++k) {
        const Point3 at((k & 1) != 0 ? 3 : -1, (k & 2) != 0 ? 5 : 2, (k & 4) != 0 ? 2 : 0);
        const auto device = system.to_device(at);
        ASSERT_TRUE(device);
        if (device->z <= depth) continue;
        depth = device->z;
        nearest = at;
      }
      EXPECT_EQ(drawn.size(), 7u);
      EXPECT_FALSE(drawn.contains(corner(nearest))) << azimuth << ' ' << elevation;
    }
  }
}

/// Two wide and deep, and 1.24 high; or as its units are.
TEST(SurfaceScene, TheBoxHasItsProportions) {
  const std::vector<SurfaceData> surfaces{surface_of(2, 2, {0.0, 1.0, 1.0, 2.0})};
  const auto size_of = [&](bool true_scale) {
    SurfaceLook look = bare();
    look.true_scale = true_scale;
    GraphicsSystem system;
    enter_surfaces(system, surfaces, look);
    const Point3 low = system.modelling_transformation().apply(Point3(-1, 2, 0));
    const Point3 high = system.modelling_transformation().apply(Point3(3, 5, 2));
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(low[a], -high[a], 1e-12);  // about the origin
    return high - low;
  };
  const Point3 size = size_of(false), scaled = size_of(true);
  EXPECT_NEAR(size.x, 2.0, 1e-12);
  EXPECT_NEAR(size.y, 2.0, 1e-12);
  EXPECT_NEAR(size.z, 1.24, 1e-12);
  EXPECT_NEAR(scaled.x, 2.0, 1e-12);
  EXPECT_NEAR(scaled.y, 1.5, 1e-12);
  EXPECT_NEAR(scaled.z, 1.0, 1e-12);
}

/// As large as fits, in the middle of the room between the margins.
TEST(SurfaceScene, TheBoxFillsThePictureBetweenItsMargins) {
  const std::vector<SurfaceData> surfaces{surface_of(2, 2, {0.0, 1.0, 1.0, 2.0})};
  struct Case {
    bool axes;
    double aspect, left, right, bottom, top;
  };
  for (const Case& c :
       {Case{false, 1.0, 0.03, 0.03, 0.03, 0.03}, Case{false, 3.0, 0.03, 0.03, 0.03, 0.03},
        Case{true, 1.0, 0.14, 0.12, 0.09, 0.03}, Case{true, 2.0, 0.14, 0.12, 0.09, 0.03},
        // A narrow picture: its margins take two thirds of the width.
        Case{true, 0.195, 0.07, 0.06, 0.045, 0.015}}) {
    GraphicsSystem system;
    system.set_aspect_ratio(c.aspect);
    SurfaceLook look = bare();
    look.axes = c.axes;
    enter_surfaces(system, surfaces, look);
    Point2 low(1e9), high(-1e9);
    for (int k = 0; k < 8; ++k) {
      const Point3 at((k & 1) != 0 ? 3 : -1, (k & 2) != 0 ? 5 : 2, (k & 4) != 0 ? 2 : 0);
      const auto device = system.to_device(at);
      ASSERT_TRUE(device);
      const Point2 seen(device->x * c.aspect, device->y);  // in parts of the picture's height
      low = glm::min(low, seen);
      high = glm::max(high, seen);
    }
    const double left = low.x - c.left, right = c.aspect - high.x - c.right;
    const double bottom = low.y - c.bottom, top = 1.0 - high.y - c.top;
    EXPECT_NEAR(left, right, 1e-9) << c.aspect;
    EXPECT_NEAR(bottom, top, 1e-9) << c.aspect;
    EXPECT_NEAR(std::min(left, bottom), 0.0, 1e-9) << c.aspect;
    EXPECT_GE(std::max(left, bottom), -1e-9) << c.aspect;
  }
}

/// The colours of the cells of a surface, in the order of its cells.
std::vector<Colour> colours_of_cells(const std::vector<Call>& calls) {
  std::vector<Colour> colours;
  Colour fill(-1.0);
  for (const Call& call : calls) {
    if (call.routine == "set-fill-style" && call.words.at(0) == "solid") {
      fill = {call.number(1), call.number(2), call.number(3)};
    }
    if (call.routine == "surface-3") colours.push_back(fill);
  }
  return colours;
}

TEST(SurfaceScene, ACellHasTheColourOfItsMeanHeight) {
  // Heights from 100 to 164, so that a step is 1 high.
  const SurfaceData surface = surface_of(3, 3, {100, 100, 164, 100, 106, 164, 100, 118, 164});
  SurfaceLook look = bare();
  look.coloured = true;
  const std::vector<Call> calls = calls_of({surface}, look);
  const std::vector<Colour> expected{height_colour_of_step(1),    // 100 and (0 + 0 + 0 + 6) / 4
                                     height_colour_of_step(33),   // (0 + 64 + 6 + 64) / 4
                                     height_colour_of_step(6),    // (0 + 6 + 0 + 18) / 4
                                     height_colour_of_step(38)};  // (6 + 64 + 18 + 64) / 4
  EXPECT_EQ(colours_of_cells(calls), expected);
  // Each cell stands where it is in the grid, with its heights.
  std::vector<Call> cells;
  for (const Call& call : calls) {
    if (call.routine == "surface-3") cells.push_back(call);
  }
  ASSERT_EQ(cells.size(), 4u);
  using Words = std::vector<std::string>;
  EXPECT_EQ(cells[1].words, (Words{"1", "3", "2", "2", "3.5", "2", "100", "164", "106", "164"}));
  EXPECT_EQ(cells[2].words, (Words{"-1", "1", "2", "3.5", "5", "2", "100", "106", "100", "118"}));
}

TEST(SurfaceScene, ColoursReachFromTheLowestToTheHighest) {
  SurfaceLook look = bare();
  look.coloured = true;
  const auto colours = [&](std::vector<double> heights) {
    return colours_of_cells(calls_of({surface_of(3, 2, std::move(heights))}, look));
  };
  const Colour lowest = height_colour_of_step(0), highest = height_colour_of_step(63);
  EXPECT_EQ(colours({-2, -2, 5, -2, -2, 5})[0], lowest);
  EXPECT_EQ(colours({-2, 5, 5, -2, 5, 5})[1], highest);
  const Colour middle = height_colour_of_step(32);  // for surfaces of one height
  EXPECT_EQ(colours({7, 7, 7, 7, 7, 7}), (std::vector<Colour>{middle, middle}));
  EXPECT_EQ(colours({kHole, 0, 1, 0, 0, 1}).size(), 1u);
  // All surfaces share them.
  const std::vector<Colour> shared =
      colours_of_cells(calls_of({surface_of(2, 2, {0, 0, 0, 0}), surface_of(2, 2, {1, 1, 1, 1}),
                                 surface_of(2, 2, {4, 4, 4, 4})},
                                look));
  EXPECT_EQ(shared, (std::vector<Colour>{lowest, height_colour_of_step(16), highest}));
}

/// A height has the place beside the bar at which its colour is.
TEST(SurfaceScene, TheLegendShowsWhichColourIsWhichHeight) {
  SurfaceLook look = bare();
  look.coloured = true;
  look.names[2] = "depth";
  const std::vector<Call> calls = calls_of({surface_of(2, 2, {10, 20, 30, 50})}, look);
  std::vector<Colour> bar;
  Colour fill(-1.0);
  double top = 0.25, left = 0.0, right = 0.0;  // of the last polygon
  Point3 at(0.0);
  std::map<std::string, double> places;
  for (const Call& call : calls) {
    if (call.routine == "set-fill-style" && call.words.at(0) == "solid") {
      fill = {call.number(1), call.number(2), call.number(3)};
    } else if (call.routine == "polygon-abs-3") {
      bar.push_back(fill);
      EXPECT_NEAR(call.number(1), top, 1e-12);
      left = call.number(0);
      right = call.number(3);
      top = call.number(7);
    } else if (call.routine == "move-abs-3") {
      at = call.point();
    } else if (call.routine == "line-abs-3" && at.x == right && at.y == call.point().y) {
      EXPECT_GT(call.point().x, right);  // a tick
      places["tick " + std::to_string(places.size())] = at.y;
    } else if (call.routine == "text") {
      places[call.words.at(0)] = at.y;
      const bool is_name = call.words.at(0) == "\"depth\"";
      EXPECT_TRUE(is_name ? at.x == left : at.x > right) << call.words.at(0);
    }
  }
  ASSERT_EQ(bar.size(), static_cast<std::size_t>(kHeightColours));
  for (int step = 0; step < kHeightColours; ++step) {
    EXPECT_EQ(bar[static_cast<std::size_t>(step)], height_colour_of_step(step)) << step;
  }
  EXPECT_NEAR(top, 0.75, 1e-12);
  ASSERT_TRUE(places.contains("\"10\"") && places.contains("\"50\"") && places.contains("\"30\""));
  EXPECT_EQ(places.at("tick 0"), 0.25);  // of 10
  EXPECT_NEAR(places.at("\"30\"") - places.at("\"10\""), 0.25, 1e-12);
  EXPECT_NEAR(places.at("\"50\"") - places.at("\"10\""), 0.5, 1e-12);
  EXPECT_LT(places.at("\"10\""), 0.25);  // letters stand about the tick's middle
  EXPECT_GT(places.at("\"10\""), 0.24);
  EXPECT_GT(places.at("\"depth\""), 0.75);
}

/// Where the legend of a surface stands, in parts of the picture's height.
struct LegendPlaces {
  double left = 0.0, right = 0.0;    ///< of the bar
  double tick = 0.0, numbers = 0.0;  ///< right of it
  double letters = 0.0, end = 0.0;   ///< size of the texts; where the longest ends, about
};
LegendPlaces legend_places(const std::string& name, const std::vector<double>& heights,
                           double aspect, bool axes = false) {
  GraphicsSystem system;
  system.set_aspect_ratio(aspect);
  SurfaceLook look = bare();
  look.coloured = true;
  look.axes = axes;
  look.names[2] = name;
  LegendPlaces places;
  double x = 0.0;
  bool is_legend = false;
  for (const Call& call : calls_of({surface_of(2, 2, heights)}, look, system)) {
    if (call.routine == "open-segment") is_legend = call.words.at(0) == "2";
    if (!is_legend) continue;
    if (call.routine == "polygon-abs-3") {
      places.left = call.number(0);
      places.right = call.number(3);
    } else if (call.routine == "set-text-style") {
      places.letters = call.number(0);
    } else if (call.routine == "line-abs-3" && x == places.right && call.number(0) > x) {
      places.tick = call.number(0) - x;
    } else if (call.routine == "move-abs-3") {
      x = call.number(0);
    } else if (call.routine == "text") {
      const std::string text = call.words.at(0).substr(1, call.words.at(0).size() - 2);
      const double width = 0.64 * places.letters * static_cast<double>(text.size());
      places.end = std::max(places.end, x + width);
      if (x > places.right) places.numbers = x - places.right;
    }
  }
  // Its window is the picture, upright.
  for (const Point3& corner : {Point3(0, 0, 0), Point3(1, 1, 0)}) {
    const auto device = system.to_device({corner.x * aspect, corner.y, 0.0});
    EXPECT_TRUE(device && glm::length(Point2(*device) - Point2(corner)) < 1e-12);
  }
  return places;
}

/// The bar is 0.115 to 0.14 from the right side, and farther where texts need that: the longest
/// ends 0.01 before the side.
TEST(SurfaceScene, TheLegendHasRoomForItsTexts) {
  const std::vector<double> few{1, 2, 3, 4}, many{1000001, 1000002, 1000003, 1000004};
  const LegendPlaces usual = legend_places("z", few, 1.5);
  EXPECT_NEAR(usual.left, 1.5 - 0.14, 1e-12);
  EXPECT_NEAR(usual.right, 1.5 - 0.115, 1e-12);
  EXPECT_NEAR(usual.tick, 0.008, 1e-12);
  EXPECT_NEAR(usual.numbers, 0.014, 1e-12);
  EXPECT_NEAR(usual.letters, 0.026, 1e-12);
  EXPECT_LT(usual.end, 1.5);
  const LegendPlaces with_name = legend_places("temperature-in-K", few, 1.5);
  EXPECT_NEAR(with_name.end, 1.5 - 0.01, 1e-12);
  EXPECT_LT(with_name.left, usual.left);
  const LegendPlaces with_numbers = legend_places("z", many, 1.5);
  EXPECT_NEAR(with_numbers.end, 1.5 - 0.01, 1e-12);
  EXPECT_LT(with_numbers.left, usual.left);
  EXPECT_NEAR(with_numbers.right - with_numbers.left, 0.025, 1e-12);
  // But no farther than 0.4 more.
  EXPECT_NEAR(legend_places(std::string(60, 'n'), few, 1.5).left, 1.5 - 0.54, 1e-12);
}

/// In a narrow picture it is smaller as a whole.
TEST(SurfaceScene, TheLegendIsSmallerInANarrowPicture) {
  // With axes its margins are 0.14, and 0.12 and 0.24 for the legend: two thirds of the width.
  const double scale = 0.5, aspect = scale * 0.5 * 3.0 / 2.0;
  const LegendPlaces places = legend_places("z", {1, 2, 3, 4}, aspect, true);
  EXPECT_NEAR(places.left, aspect - scale * 0.14, 1e-12);
  EXPECT_NEAR(places.right, aspect - scale * 0.115, 1e-12);
  EXPECT_NEAR(places.tick, scale * 0.008, 1e-12);
  EXPECT_NEAR(places.numbers, scale * 0.014, 1e-12);
  EXPECT_NEAR(places.letters, scale * 0.026, 1e-12);
}

TEST(SurfaceScene, SurfacesTogetherHaveFillsOfTheirOwn) {
  const SurfaceData surface = surface_of(2, 2, {0, 1, 1, 2});
  EXPECT_EQ(colours_of_cells(calls_of({surface}, bare())), std::vector<Colour>{Colour(1.0)});
  const std::vector<Colour> fills =
      colours_of_cells(calls_of(std::vector<SurfaceData>(7, surface), bare()));
  ASSERT_EQ(fills.size(), 7u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NE(fills[i], Colour(1.0));
    for (std::size_t k = 0; k < i; ++k) EXPECT_NE(fills[i], fills[k]) << i << ' ' << k;
  }
  EXPECT_EQ(fills[6], fills[0]);
}

/// The width of curves, unless it is set: thinner, the more there are.
TEST(SurfaceScene, CurvesAreThinnerWhereThereAreMany) {
  const auto width = [](int x_points, int y_points, double set) {
    SurfaceLook look = bare();
    look.line_width = set;
    const SurfaceData surface = surface_of(x_points, y_points, [](double x, double) { return x; });
    std::string last;
    for (const Call& call : calls_of({surface}, look)) {
      if (call.routine == "set-line-style") last = call.words.at(4);
    }
    return std::stod(last);
  };
  EXPECT_EQ(width(2, 2, 0.0), 0.8);
  EXPECT_EQ(width(2, 80, 0.0), 0.5);
  EXPECT_EQ(width(80, 2, 0.0), 0.5);
  EXPECT_EQ(width(400, 2, 0.0), 0.15);
  EXPECT_EQ(width(2, 2, 1.75), 1.75);
}

/// They lie on the bottom of the box, at heights that divide those of all surfaces.
TEST(SurfaceScene, ContoursLieAtTheBase) {
  SurfaceLook look = bare();
  look.contours = 3;
  const std::vector<SurfaceData> surfaces{surface_of(5, 2, [](double x, double) { return x; }),
                                          surface_of(5, 2, [](double, double) { return 7.0; })};
  const Lines lines = lines_of(calls_of(surfaces, look));
  std::map<double, double> length_at;  // of x, which is the height
  for (const auto& line : lines) {
    EXPECT_EQ(line[0].z, -1.0 - 0.6 * 8.0);
    EXPECT_EQ(line[1].z, line[0].z);
    EXPECT_EQ(line[0].x, line[1].x);
    length_at[line[0].x] += length(line);
  }
  EXPECT_EQ(length_at, (std::map<double, double>{{1.0, 3.0}, {3.0, 3.0}}));  // and 5, of none
}

}  // namespace
}  // namespace displayfile
