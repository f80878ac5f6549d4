// set-line-order depth and set-line-halo in pixels, vectors, picks and records.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/segments/sorted_display_file.h"
#include "interp/draw/draw.h"
#include "interp/draw/renderer.h"

namespace displayfile {
namespace {

constexpr int kSize = 64;

/// Lines of random colours and widths, each in a depth of its own along it; every other one in the
/// second segment.
GraphicsSystem random_lines(unsigned seed, int lines, HiddenMethod method, bool fills) {
  std::mt19937 random(seed);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  GraphicsSystem g;
  g.set_hidden_surfaces({.removal = true, .method = method, .line_order = LineOrder::depth});
  g.set_window(0, 1, 0, 1);
  g.set_view_depth(-1, 0);
  for (int segment = 1; segment <= 2; ++segment) {
    g.open_segment(segment);
    if (fills && segment == 1) {
      g.set_fill_style({FillStyle::Kind::solid, Colour(0.0, 0.0, 1.0)});
      g.set_line_style({LineStyle::Kind::none});
      g.polygon_abs_3({{0.2, 0.2, 0.5}, {0.8, 0.2, 0.5}, {0.5, 0.9, 0.5}});
    }
    for (int k = segment - 1; k < lines; k += 2) {
      LineStyle style;
      style.colour = Colour((20.0 + k) / 255.0, 0.0, 0.0);
      style.width = 1.0 + static_cast<double>(random() % 6);
      g.set_line_style(style);
      g.set_pick_id(k);
      g.move_abs_3(unit(), unit(), unit());
      g.line_abs_3(unit(), unit(), unit());
    }
    g.close_segment();
  }
  return g;
}

DrawOptions options_of(LineOrder order, double halo = 0.0) {
  DrawOptions options;
  options.width = kSize;
  options.height = kSize;
  options.samples = 1;
  options.surfaces.line_order = order;
  if (halo > 0.0) options.surfaces.line_halo = halo;
  return options;
}

std::uint32_t red_of(const Picture& picture, int x, int y) {
  return picture.pixels[static_cast<std::size_t>(y * kSize + x)] & 0xffu;
}
bool is_of_line(const Picture& picture, int x, int y) {
  const std::uint32_t pixel = picture.pixels[static_cast<std::size_t>(y * kSize + x)];
  return (pixel & 0xffff00u) == 0 && (pixel & 0xffu) >= 20;
}

TEST(LineOrder, PicksAreThoseOfThePicture) {
  for (const HiddenMethod method : {HiddenMethod::z_buffer, HiddenMethod::franklin,
                                    HiddenMethod::bsp, HiddenMethod::map, HiddenMethod::ray_cast}) {
    for (unsigned seed = 0; seed < 2; ++seed) {
      const GraphicsSystem g = random_lines(seed, 14, method, seed == 1);
      for (const double halo : {0.0, 2.5}) {
        const DrawOptions options = options_of(LineOrder::depth, halo);
        const Picture picture = draw(g, options);
        Renderer renderer;
        for (int y = 0; y < kSize; ++y) {
          for (int x = 0; x < kSize; ++x) {
            const auto pick = renderer.pick(g, x + 0.5, y + 0.5, options, 1e-6);
            const bool is_line = pick && pick->kind == Pick::Kind::line;
            ASSERT_EQ(is_line, is_of_line(picture, x, y)) << x << " " << y << " " << seed;
            if (is_line) {
              ASSERT_EQ(20u + static_cast<std::uint32_t>(pick->id), red_of(picture, x, y));
            }
          }
        }
      }
    }
  }
}

struct Axis {
  Point3 from, to;
};

/// The crossing of two lines in the picture, and the depth by which the second is nearer.
bool crossing_of(const Axis& a, const Axis& b, Point2& at, double& nearer) {
  const Point3 u = a.to - a.from, v = b.to - b.from, w = b.from - a.from;
  const double turn = u.x * v.y - u.y * v.x;
  if (std::abs(turn) < 1e-3) return false;
  const double s = (w.x * v.y - w.y * v.x) / turn, t = (w.x * u.y - w.y * u.x) / turn;
  if (s < 0 || s > 1 || t < 0 || t > 1) return false;
  at = Point2(a.from + s * u);
  nearer = (b.from.z + t * v.z) - (a.from.z + s * u.z);
  return true;
}

/// Where two lines cross at a pixel, no third one near it, the nearer one is seen: by all
/// methods.
TEST(LineOrder, TheNearerLineIsSeenAtACrossing) {
  int crossings = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    const auto unit = [&] { return static_cast<double>(random() % 4096) / 4096.0; };
    std::vector<Axis> axes;
    for (int k = 0; k < 6; ++k)
      axes.push_back({{unit(), unit(), unit()}, {unit(), unit(), unit()}});
    const auto drawn = [&](HiddenMethod method) {
      GraphicsSystem g;
      g.set_hidden_surfaces({.removal = true, .method = method});
      g.set_window(0, 1, 0, 1);
      g.set_view_depth(-1, 0);
      g.open_segment(1);
      for (int k = 0; k < 6; ++k) {
        const Axis& axis = axes[static_cast<std::size_t>(k)];
        LineStyle style;
        style.colour = Colour((20.0 + k) / 255.0, 0.0, 0.0);
        style.width = 3.0;
        g.set_line_style(style);
        g.move_abs_3(axis.from.x, axis.from.y, axis.from.z);
        g.line_abs_3(axis.to.x, axis.to.y, axis.to.z);
      }
      g.close_segment();
      return draw(g, options_of(LineOrder::depth));
    };
    const Picture by_pixels = drawn(HiddenMethod::z_buffer);
    const Picture by_lines = drawn(HiddenMethod::franklin);
    ASSERT_EQ(by_pixels.pixels, by_lines.pixels);
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = i + 1; j < 6; ++j) {
        Point2 at;
        double nearer = 0.0;
        if (!crossing_of(axes[i], axes[j], at, nearer) || nearer == 0.0) continue;
        const int x = static_cast<int>(at.x * kSize);
        const int y = kSize - 1 - static_cast<int>(at.y * kSize);
        if (x < 0 || y < 0 || x >= kSize || y >= kSize) continue;
        const std::size_t seen = red_of(by_pixels, x, y) - 20u;
        if (seen != i && seen != j) continue;  // a third one is over both
        ++crossings;
        ASSERT_EQ(seen, nearer > 0 ? j : i) << seed;
      }
    }
  }
  EXPECT_GT(crossings, 100);
}

/// A red line behind a black one that was entered first.
GraphicsSystem cross(LineOrder order, double halo = 0.0) {
  GraphicsSystem g;
  g.set_hidden_surfaces({.removal = true, .line_order = order, .line_halo = halo});
  g.set_window(0, 1, 0, 1);
  g.set_view_depth(-1, 0);
  g.open_segment(1);
  LineStyle style;
  style.width = 4.0;
  g.set_line_style(style);
  g.move_abs_3(0.5, 0.1, 0.75);
  g.line_abs_3(0.5, 0.9, 0.75);
  style.colour = Colour(1.0, 0.0, 0.0);
  g.set_line_style(style);
  g.move_abs_3(0.1, 0.5, 0.25);
  g.line_abs_3(0.9, 0.5, 0.25);
  g.close_segment();
  return g;
}

TEST(LineOrder, VectorsHaveTheNearerLineLast) {
  DrawOptions options;
  options.width = 100;
  options.height = 100;
  const auto order = [&](const GraphicsSystem& g) {
    const std::string svg = draw_as(g, "svg", options);
    return std::pair(svg.find("#ff0000"), svg.find("#000000"));
  };
  const auto [red, black] = order(cross(LineOrder::depth));
  ASSERT_NE(red, std::string::npos);
  EXPECT_LT(red, black);
  const auto [red_before, black_before] = order(cross(LineOrder::entry));
  EXPECT_GT(red_before, black_before);
  const DrawnPieces pieces = drawn_pieces(cross(LineOrder::depth));
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces.line_colours[0], Colour(1.0, 0.0, 0.0));
}

TEST(LineOrder, AHaloLeavesAGapInPixelsAndVectors) {
  const GraphicsSystem g = cross(LineOrder::depth, 6.0);
  const Picture picture = draw(g, {.width = kSize, .height = kSize, .samples = 1});
  const auto pixel = [&](int x) {
    return picture.pixels[static_cast<std::size_t>(kSize / 2 * kSize + x)] & 0xffffffu;
  };
  EXPECT_EQ(pixel(32), 0u);         // the nearer one, 4 wide
  EXPECT_EQ(pixel(35), 0xffffffu);  // 6 of the halo
  EXPECT_EQ(pixel(39), 0xffffffu);
  EXPECT_EQ(pixel(40), 0xffu);
  EXPECT_EQ(pixel(24), 0xffffffu);
  EXPECT_EQ(pixel(23), 0xffu);
  DrawOptions options;
  options.width = 100;
  options.height = 100;
  const DrawnPieces pieces = drawn_pieces(g, options);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces.line_colours[0], Colour(0.0));  // beside the gap no order is needed
  EXPECT_NEAR(pieces.points[3].x, 0.5 - 0.08, 1e-12);
  EXPECT_NEAR(pieces.points[4].x, 0.5 + 0.08, 1e-12);
  EXPECT_EQ(pieces.cuts[3], 1);  // no cap reaches into the gap
  EXPECT_EQ(pieces.cuts[4], 1);
  EXPECT_EQ(pieces.cuts[2], 0);
}

TEST(LineOrder, IsOneOrderForAllSegments) {
  GraphicsSystem g;
  g.set_hidden_surfaces(
      {.removal = true, .method = HiddenMethod::franklin, .line_order = LineOrder::depth});
  g.set_window(0, 1, 0, 1);
  g.set_view_depth(-1, 0);
  for (int segment = 1; segment <= 2; ++segment) {
    g.open_segment(segment);
    LineStyle style;
    style.width = 4.0;
    style.colour = Colour(segment == 1 ? 1.0 : 0.0, 0.0, 0.0);
    g.set_line_style(style);
    segment == 1 ? g.move_abs_3(0.5, 0.1, 0.75) : g.move_abs_3(0.1, 0.5, 0.25);
    segment == 1 ? g.line_abs_3(0.5, 0.9, 0.75) : g.line_abs_3(0.9, 0.5, 0.25);
    g.close_segment();
  }
  const Picture picture = draw(g, {.width = kSize, .height = kSize, .samples = 1});
  EXPECT_EQ(red_of(picture, kSize / 2, kSize / 2), 255u);
}

void expect_refused(const GraphicsSystem& g, const DrawOptions& options, const std::string& words) {
  try {
    draw(g, options);
    FAIL() << words;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(LineOrder, WhatCannotBeObeyedIsRefused) {
  const GraphicsSystem g = cross(LineOrder::entry);
  DrawOptions options = options_of(LineOrder::depth);
  options.surfaces.method = HiddenMethod::none;
  expect_refused(g, options, "line order depth: hidden-surface method 'none' draws in order of");
  options.surfaces.method = HiddenMethod::back_face;
  expect_refused(g, options, "line order depth: hidden-surface method 'back-face'");
  options.surfaces.method = HiddenMethod::colour_rule;
  expect_refused(g, options, "line order depth: hidden-line method 'colour-rule'");
  options.surfaces.method = HiddenMethod::bsp;
  EXPECT_NO_THROW(draw(g, options));
  EXPECT_THROW(draw_as(g, "svg", options), Error);
  EXPECT_THROW(drawn_pieces(g, options), Error);
  options.surfaces.method.reset();
  options.surfaces.line_halo = -1.0;
  expect_refused(g, options, "a line halo of -1: expected 0 to 1000000 pixels");
  options.surfaces.line_halo = std::numeric_limits<double>::quiet_NaN();
  expect_refused(g, options, "a line halo of nan");
  options.surfaces.line_halo = 3.0;
  options.surfaces.line_order = LineOrder::entry;
  expect_refused(g, options, "a line halo of 3 pixels in line order entry");
  GraphicsSystem other;
  EXPECT_THROW(other.set_hidden_surfaces({.line_halo = -1.0}), Error);
  EXPECT_THROW(other.set_hidden_surfaces({.line_halo = 2e6}), Error);
  EXPECT_EQ(other.hidden_surfaces().line_halo, 0.0);
}

TEST(LineOrder, SettingsWithoutEffectAreWarnedOf) {
  const auto warned = [](GraphicsSystem g, DrawOptions options) {
    std::vector<std::string> texts;
    options.warn = [&](const DrawWarning& warning) {
      if (warning.kind == DrawWarning::Kind::no_effect) texts.push_back(warning.text);
    };
    draw(g, options);
    return texts;
  };
  DrawOptions options;
  options.width = 16;
  options.height = 16;
  options.samples = 1;
  EXPECT_TRUE(warned(cross(LineOrder::depth), options).empty());
  const auto halo = warned(cross(LineOrder::entry, 2.0), options);
  ASSERT_EQ(halo.size(), 1u);
  EXPECT_EQ(halo[0], "a line halo has no effect: expected line order depth");
  options.surfaces.method = HiddenMethod::none;
  const auto order = warned(cross(LineOrder::depth), options);
  ASSERT_EQ(order.size(), 1u);
  EXPECT_EQ(order[0],
            "line order depth has no effect: hidden-surface method 'none' draws in order of entry");
}

TEST(LineOrder, IsRecorded) {
  std::ostringstream program;
  Recorder recorder(program);
  GraphicsSystem g;
  g.set_recorder(&recorder);
  g.set_hidden_surfaces({.line_order = LineOrder::depth, .line_halo = 1.5});
  EXPECT_EQ(program.str(), "set-line-order depth\nset-line-halo 1.5\n");
}

}  // namespace
}  // namespace displayfile
