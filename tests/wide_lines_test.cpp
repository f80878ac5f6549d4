// Wide lines in pixels look as those of vector files: corners and free ends are round, and ends
// where something hides the line are cut (interp/scan/lines.md). Distances are computed here for
// every pixel.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "displayfile/graphics_system.h"
#include "interp/draw/draw.h"

namespace displayfile {
namespace {

constexpr int kSize = 100;
constexpr double kWidth = 10.0;
using Points = std::vector<Point2>;

/// A system whose window is the picture, in pixels, with lines of that width.
GraphicsSystem system_in_pixels(double width = kWidth) {
  GraphicsSystem g;
  g.set_window(0, kSize, 0, kSize);
  g.set_view_depth(-10, 10);
  LineStyle style;
  style.width = width;
  g.set_line_style(style);
  return g;
}

void enter_lines(GraphicsSystem& g, const Points& points, double z = 0.0) {
  g.move_abs_3(points[0].x, points[0].y, z);
  for (std::size_t i = 1; i < points.size(); ++i) g.line_abs_3(points[i].x, points[i].y, z);
}

GraphicsSystem polyline(const Points& points, double width = kWidth) {
  GraphicsSystem g = system_in_pixels(width);
  g.open_segment(1);
  enter_lines(g, points);
  g.close_segment();
  return g;
}

Picture drawn(const GraphicsSystem& g, HiddenMethod method = HiddenMethod::z_buffer,
              int samples = 1) {
  DrawOptions options{.samples = samples};
  options.width = options.height = kSize;
  options.surfaces.method = method;
  return draw(g, options);
}

bool is_black(const Picture& picture, int column, int row) {
  const auto at = static_cast<std::size_t>((kSize - 1 - row) * kSize + column);
  return picture.pixels[at] == pixel_of({0, 0, 0});
}

/// The centre of a pixel from a corner of a line, along it and across.
struct FromLine {
  double along, across;
};
FromLine from_line(const Point2& p, const Point2& from, const Point2& to) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const Point2 direction = (to - from) / length, offset = p - from;
  return {offset.x * direction.x + offset.y * direction.y,
          offset.y * direction.x - offset.x * direction.y};
}

double distance_to(const Points& points, const Point2& p) {
  double least = 1e9;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double length = std::hypot(points[i + 1].x - points[i].x, points[i + 1].y - points[i].y);
    const FromLine at = from_line(p, points[i], points[i + 1]);
    least = std::min(least, std::hypot(at.along - std::clamp(at.along, 0.0, length), at.across));
  }
  return least;
}

/// Expects black pixels where `is_inside`, unless that is within a millionth of a border.
void expect_black(const Picture& picture, const std::function<double(const Point2&)>& inside) {
  int wrong = 0;
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) {
      const double by = inside({column + 0.5, row + 0.5});
      if (std::abs(by) > 1e-6) wrong += is_black(picture, column, row) != (by > 0.0);
    }
  }
  EXPECT_EQ(wrong, 0);
}

const Points kBent{{20.3, 30.1}, {60.2, 35.7}, {40.6, 80.4}, {75.1, 60.2}};

TEST(WideLines, HaveRoundCornersAndEndsByEveryMethod) {
  for (const HiddenMethod method :
       {HiddenMethod::none, HiddenMethod::z_buffer, HiddenMethod::bsp, HiddenMethod::scan_line,
        HiddenMethod::franklin, HiddenMethod::colour_rule}) {
    SCOPED_TRACE(name_of(method));
    expect_black(drawn(polyline(kBent), method),
                 [](const Point2& p) { return 0.5 * kWidth - distance_to(kBent, p); });
  }
}

TEST(WideLines, HaveRoundCornersAsSidesOfPolygons) {
  GraphicsSystem g = system_in_pixels();
  g.set_fill_style({FillStyle::Kind::hollow});
  g.open_segment(1);
  g.polygon_abs_3({{20.3, 30.1, 0}, {60.2, 35.7, 0}, {40.6, 80.4, 0}});
  g.close_segment();
  const Points closed{{20.3, 30.1}, {60.2, 35.7}, {40.6, 80.4}, {20.3, 30.1}};
  expect_black(drawn(g), [&](const Point2& p) { return 0.5 * kWidth - distance_to(closed, p); });
}

/// Caps of lines that are no wider than a pixel and a half would be noise.
TEST(WideLines, AreThoseWiderThanAPixelAndAHalf) {
  for (const double width : {1.5, 1.6}) {
    const Picture picture = drawn(polyline({{20, 50}, {80, 50}}, width), HiddenMethod::z_buffer, 4);
    const auto beyond = static_cast<std::size_t>((kSize - 1 - 50) * kSize + 19);
    EXPECT_EQ(picture.pixels[beyond] == pixel_of(Background{}), width == 1.5);
  }
}

/// A rectangle before the middle of a line. The line's ends there are cut across it.
TEST(WideLines, AreCutWhereSomethingHidesThem) {
  const Point2 from(10.2, 40.3), to(90.4, 60.1);
  GraphicsSystem g = system_in_pixels();
  g.set_fill_style({FillStyle::Kind::solid, {0.5, 0.5, 0.5}});
  g.open_segment(1);
  enter_lines(g, {from, to}, -1.0);
  g.set_line_style({LineStyle::Kind::none});
  g.polygon_abs_3({{40, 10, 1}, {55, 10, 1}, {55, 90, 1}, {40, 90, 1}});
  g.close_segment();
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double scale = length / (to.x - from.x);
  const double first = (40.0 - from.x) * scale, second = (55.0 - from.x) * scale;
  for (const HiddenMethod method : {HiddenMethod::z_buffer, HiddenMethod::bsp}) {
    expect_black(drawn(g, method), [&](const Point2& p) {
      const FromLine at = from_line(p, from, to);
      const double seen = std::max(first - at.along, at.along - second);
      return std::min(0.5 * kWidth - distance_to({from, to}, p), seen);
    });
  }
}

TEST(WideLines, AreCutAtABorderInsideOfThePicture) {
  GraphicsSystem g = system_in_pixels();
  g.set_window(0.25 * kSize, 0.75 * kSize, 0.25 * kSize, 0.75 * kSize);
  g.set_viewport(0.25, 0.75, 0.25, 0.75);
  g.set_fill_style({FillStyle::Kind::hollow});
  g.open_segment(1);
  enter_lines(g, {{10, 40}, {50, 40}});
  g.polygon_abs_3({{50, 60, 0}, {90, 60, 0}, {90, 65, 0}});
  g.close_segment();
  const Picture picture = drawn(g);
  for (int row = 0; row < kSize; ++row) {
    for (const int column : {20, 24, 76, 79}) EXPECT_FALSE(is_black(picture, column, row)) << row;
  }
  EXPECT_TRUE(is_black(picture, 25, 40));
  EXPECT_TRUE(is_black(picture, 53, 40));  // its own end
}

/// A line along which two polygons intersect, behind a third one in part.
TEST(WideLines, OfIntersectionsAreCutWhereTheyAreHidden) {
  for (const LineOrder order : {LineOrder::entry, LineOrder::depth}) {
    GraphicsSystem g = system_in_pixels();
    g.set_fill_style({FillStyle::Kind::solid, {0.5, 0.5, 0.5}});
    g.set_hidden_surfaces({.removal = true, .line_order = order});
    g.set_back_face_removal(false);
    g.set_hidden_surfaces({.lines = LineSelection{kinds_of(LineKind::intersection)}});
    g.open_segment(1);
    g.polygon_abs_3({{10, 50, -5}, {90, 50, -5}, {90, 51, 5}, {10, 51, 5}});
    g.polygon_abs_3({{10, 10, 0}, {90, 10, 0}, {90, 90, 0}, {10, 90, 0}});
    g.polygon_abs_3({{40, 10, 8}, {60, 10, 8}, {60, 90, 8}, {40, 90, 8}});
    g.close_segment();
    const Picture picture = drawn(g);
    EXPECT_TRUE(is_black(picture, 39, 50));
    EXPECT_FALSE(is_black(picture, 41, 50));
    EXPECT_FALSE(is_black(picture, 58, 50));
    EXPECT_TRUE(is_black(picture, 61, 50));
    EXPECT_TRUE(is_black(picture, 7, 50));  // the cap of its own end
  }
}

/// Dashes are cut across the line, and have a round join where they pass a corner.
TEST(WideLines, DashesAreCutAcrossAndJoined) {
  const Points bent{{20.3, 20.4}, {50.2, 40.1}, {40.6, 80.4}};
  GraphicsSystem g = system_in_pixels();
  LineStyle style{LineStyle::Kind::dashed};
  style.width = kWidth;
  style.dash = 15.0;
  style.gap = 8.0;
  g.set_line_style(style);
  g.open_segment(1);
  enter_lines(g, bent);
  g.close_segment();
  const double before = std::hypot(bent[1].x - bent[0].x, bent[1].y - bent[0].y);
  const auto in_dash = [](double along) { return std::fmod(along, 23.0) < 15.0; };
  ASSERT_TRUE(in_dash(before));
  const auto is_there = [&](const Point2& p) {
    double start = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      const FromLine at = from_line(p, bent[i], bent[i + 1]);
      const double length =
          i == 0 ? before : std::hypot(bent[2].x - bent[1].x, bent[2].y - bent[1].y);
      const bool is_beside = at.along >= 0.0 && at.along <= length;
      if (is_beside && std::abs(at.across) < 0.5 * kWidth && in_dash(start + at.along)) return true;
      start += length;
    }
    const FromLine first = from_line(p, bent[0], bent[1]), second = from_line(p, bent[1], bent[2]);
    const bool is_outer = first.along > before && second.along < 0.0;
    return is_outer && std::hypot(p.x - bent[1].x, p.y - bent[1].y) < 0.5 * kWidth;
  };
  expect_black(drawn(g), [&](const Point2& p) { return is_there(p) ? 1.0 : -1.0; });
}

TEST(WideLines, WithoutLengthAreSquares) {
  expect_black(drawn(polyline({{50.2, 40.3}, {50.2, 40.3}}), HiddenMethod::none),
               [](const Point2& p) {
                 return 0.5 * kWidth - std::max(std::abs(p.x - 50.2), std::abs(p.y - 40.3));
               });
}

/// Bands of rows on several threads each draw their part of caps.
TEST(WideLines, AreTheSameOnAnyThreads) {
  DrawOptions options{.samples = 1};
  options.width = options.height = kSize;
  options.surfaces.threads = 1;
  const Picture one = draw(polyline(kBent, 25.0), options);
  options.surfaces.threads = 7;
  EXPECT_EQ(draw(polyline(kBent, 25.0), options).pixels, one.pixels);
}

}  // namespace
}  // namespace displayfile
