#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "clip/surfaces.h"
#include "displayfile/graphics_system.h"

namespace displayfile::test {

using Quad = std::array<Point3, 4>;
inline std::vector<Quad> box() {
  std::vector<Quad> quads;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.5, 0.5}) {
      Quad quad;
      for (std::size_t k = 0; k < 4; ++k) {
        const double u = k == 1 || k == 2 ? 0.5 : -0.5, v = k >= 2 ? 0.5 : -0.5;
        quad[k][axis] = side;
        quad[k][(axis + 1) % 3] = side > 0.0 ? u : v;
        quad[k][(axis + 2) % 3] = side > 0.0 ? v : u;
      }
      quads.push_back(quad);
    }
  }
  return quads;
}
inline void enter(GraphicsSystem& g, const std::vector<Quad>& quads) {
  for (const Quad& quad : quads) g.polygon_abs_3(quad);
}
inline void enter_triangles(GraphicsSystem& g, const std::vector<Quad>& quads) {
  for (const Quad& quad : quads) {
    g.polygon_abs_3({quad[0], quad[1], quad[2]});
    g.polygon_abs_3({quad[0], quad[2], quad[3]});
  }
}

/// A closed ring of quadrilaterals that are not flat, so that they are entered as triangles.
inline std::vector<Quad> torus(int around, int across) {
  const auto at = [&](int i, int j) {
    const double u = 2.0 * std::numbers::pi * (i % around) / around;
    const double v = 2.0 * std::numbers::pi * (j % across) / across;
    const double r = 0.5 + 0.2 * std::cos(v);
    return Point3(r * std::cos(u), r * std::sin(u), 0.2 * std::sin(v) + 0.05 * std::sin(3.0 * u));
  };
  std::vector<Quad> quads;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return quads;
}

/// A system whose only segment has the primitives of `enter_all`, with those lines.
template <class Enter>
GraphicsSystem drawn_with(const std::string& words, Enter&& enter_all) {
  GraphicsSystem g;
  g.set_perspective({1.5, 1.2, 5.0});
  g.set_view_depth(-3.0, 3.0);
  g.set_hidden_surfaces({.lines = line_selection(words)});
  g.open_segment(1);
  enter_all(g);
  g.close_segment();
  return g;
}

}  // namespace displayfile::test
