#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "displayfile/graphics_system.h"
#include "interp/draw/draw.h"
#include "programs/bench/timing.h"
#include "programs/scenes/scene.h"
#include "tests/bench/worst_inputs.h"
#include "tests/polygon_outlines.h"

namespace displayfile::bench {

// What the worst inputs are made of, in device coordinates: the view is the unit cube's.

inline double real(std::size_t n) { return static_cast<double>(n); }

/// The seconds of the processor that the work takes, and what it returns.
template <class Work>
Cost cost_of(const Work& work) {
  Cost cost{0.0, 0.0};
  cost.seconds =
      seconds_each(Clock::processor, 1, [&] { cost.output = static_cast<double>(work()); });
  return cost;
}

inline void begin(GraphicsSystem& g) {
  set_view(unit_view(), g);
  g.set_line_style({LineStyle::Kind::none});
}

/// One segment with these polygons, of colours that differ.
inline GraphicsSystem entered_polygons(const std::vector<Polygon>& polygons,
                                       bool with_lines = false) {
  GraphicsSystem g;
  begin(g);
  if (with_lines) g.set_line_style({});
  g.open_segment(1);
  double shade = 0.1;
  for (const Polygon& p : polygons) {
    shade = shade < 0.9 ? shade + 0.1 : 0.1;
    g.set_fill_style({.colour = {shade, 0.5, 0.5}});
    g.polygon_abs_3(p);
  }
  g.close_segment();
  return g;
}

/// An outline in the unit square, at a depth.
inline Polygon in_square(const test::Outline& outline, double z, double bend = 0.0) {
  Point2 low = outline[0], high = outline[0];
  for (const Point2& p : outline) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  Polygon polygon;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Point2 p = (outline[k] - low) / (high - low) * 0.98 + 0.01;
    polygon.emplace_back(p, k % 2 == 0 ? z + bend : z);
  }
  return polygon;
}

/// n sheets that fill the picture, the nearest last.
inline std::vector<Polygon> stack(std::size_t n) {
  std::vector<Polygon> sheets;
  for (std::size_t k = 0; k < n; ++k) {
    const double z = 0.1 + 0.8 * real(k) / real(n);
    sheets.push_back({{0.01, 0.01, z}, {0.99, 0.01, z}, {0.99, 0.99, z}, {0.01, 0.99, z}});
  }
  return sheets;
}

/// n planes through the picture, each two of which cross, at most `apart` from its middle.
inline std::vector<Polygon> planes_through(std::size_t n, double apart) {
  std::mt19937_64 random(1);
  const auto slope = [&] { return (static_cast<double>(random() % 2001) - 1000.0) / 2500.0; };
  std::vector<Polygon> all;
  for (std::size_t k = 0; k < n; ++k) {
    const double a = slope(), b = slope(), c = 0.5 + apart * slope();
    const auto at = [&](double x, double y) {
      return Point3(x, y, c + a * (x - 0.5) + b * (y - 0.5));
    };
    all.push_back({at(0.01, 0.01), at(0.99, 0.01), at(0.99, 0.99), at(0.01, 0.99)});
  }
  return all;
}
inline std::vector<Polygon> planes(std::size_t n) { return planes_through(n, 0.2); }
/// All of them meet in a point, or would without rounding.
inline std::vector<Polygon> bundle(std::size_t n) { return planes_through(n, 0.0); }

/// n/2 bars from side to side, and before them n/2 from bottom to top.
inline std::vector<Polygon> grid(std::size_t n) {
  std::vector<Polygon> bars;
  const std::size_t half = std::max<std::size_t>(1, n / 2);
  for (std::size_t k = 0; k < half; ++k) {
    const double from = 0.02 + 0.96 * real(k) / real(half), to = from + 0.4 / real(half);
    bars.push_back({{0.01, from, 0.2}, {0.99, from, 0.2}, {0.99, to, 0.2}, {0.01, to, 0.2}});
  }
  for (std::size_t k = 0; k < half; ++k) {
    const double from = 0.02 + 0.96 * real(k) / real(half), to = from + 0.4 / real(half);
    bars.push_back({{from, 0.01, 0.8}, {to, 0.01, 0.8}, {to, 0.99, 0.8}, {from, 0.99, 0.8}});
  }
  return bars;
}

/// n slivers from one corner of the picture to the other, which all but coincide.
inline std::vector<Polygon> needles(std::size_t n) {
  std::vector<Polygon> all;
  for (std::size_t k = 0; k < n; ++k) {
    const double lift = 0.3 * real(k) / real(n), z = 0.2 + 0.6 * real(k) / real(n);
    all.push_back(
        {{0.01, 0.3 - lift, z}, {0.99, 0.6 + lift, 1.0 - z}, {0.99, 0.601 + lift, 1.0 - z}});
  }
  return all;
}

/// One polygon of n sides, each of which crosses nearly all others.
inline Polygon crossing_star(std::size_t n, double z) {
  const std::size_t corners = n | 1;
  Polygon star;
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * real(k * (corners / 2) % corners) / real(corners);
    star.emplace_back(0.5 + 0.48 * std::cos(angle), 0.5 + 0.48 * std::sin(angle), z);
  }
  return star;
}

inline Polygon comb(std::size_t n, double z, double bend = 0.0) {
  return in_square(test::comb_outline(n, 1, false), z, bend);
}

inline std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

}  // namespace displayfile::bench
