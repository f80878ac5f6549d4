#pragma once

#include <cmath>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "displayfile/graphics_system.h"
#include "tests/unit_square.h"

// Scenes of the tests of vector output: filled polygons distinguished by their colours.

namespace displayfile::test {

inline const Colour kRed{1, 0, 0}, kGreen{0, 1, 0}, kBlue{0, 0, 1}, kBlack{0, 0, 0};

inline FillStyle solid(const Colour& colour) { return {FillStyle::Kind::solid, colour}; }
inline LineStyle line(const Colour& colour, double width = 1.0) {
  return {LineStyle::Kind::solid, colour, width};
}
inline const LineStyle kNoLine{LineStyle::Kind::none};

/// The colour by which Canvas identifies a polygon.
inline FillStyle numbered(int id) {
  return solid({(id / 65536) / 255.0, (id / 256 % 256) / 255.0, (id % 256) / 255.0});
}

inline void enter(GraphicsSystem& g, int id, const std::vector<Point3>& vertices) {
  g.set_fill_style(numbered(id));
  g.set_pick_id(id);
  g.polygon_abs_3(vertices);
}

inline void enter_random(GraphicsSystem& g, unsigned seed, int n, double size, std::size_t sides) {
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  g.open_segment(1);
  for (int id = 0; id < n; ++id) {
    if (id == n / 2) {
      g.close_segment();
      g.open_segment(2);
    }
    // On a random plane, so that more than three sides are flat too.
    const Point3 middle{uniform(0, 1), uniform(0, 1), uniform(0.2, 0.8)};  // braces: in this order
    const double slope_x = uniform(-1, 1), slope_y = uniform(-1, 1);
    std::vector<Point3> vertices;
    for (std::size_t k = 0; k < sides; ++k) {
      const double dx = uniform(-size, size), dy = uniform(-size, size);
      vertices.push_back(middle + Point3(dx, dy, 0.2 * (slope_x * dx + slope_y * dy)));
    }
    enter(g, id, vertices);
  }
  g.close_segment();
}

/// Three bars, each over the next.
inline GraphicsSystem cyclic_overlap() {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  const auto bar = [&](int id, double angle) {
    std::vector<Point3> vertices;
    for (const auto& [x, y, z] :
         {std::tuple{-.45, -.25, .2}, {.45, -.25, .8}, {.45, -.1, .8}, {-.45, -.1, .2}}) {
      const double c = std::cos(angle), s = std::sin(angle);
      vertices.emplace_back(.5 + c * x - s * y, .5 + s * x + c * y, z);
    }
    enter(g, id, vertices);
  };
  for (const int k : {0, 1, 2})
    bar(k == 0 ? 0xff0000 : k == 1 ? 0x00ff00 : 0x0000ff, k * 2.0943951);
  g.close_segment();
  return g;
}

/// Faces turned both ways: nothing is left out before the order is sought.
inline void enter_cube(GraphicsSystem& g) {
  g.open_segment(1);
  const double c1 = std::cos(.6), s1 = std::sin(.6), c2 = std::cos(.7), s2 = std::sin(.7);
  const auto corner = [&](int i) {
    const double x = (i & 1) ? .25 : -.25, y = (i & 2) ? .25 : -.25, z = (i & 4) ? .25 : -.25;
    const double x1 = c1 * x + s1 * z, z1 = c1 * z - s1 * x;
    return Point3(.5 + x1, .5 + c2 * y - s2 * z1, .5 + c2 * z1 + s2 * y);
  };
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  int id = 0;
  for (const auto& face : faces) {
    enter(g, ++id * 40, {corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3])});
  }
  g.close_segment();
}

}  // namespace displayfile::test
