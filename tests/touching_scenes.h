#pragma once

#include <array>
#include <cmath>
#include <glm/mat4x3.hpp>
#include <vector>

#include "clip/view/transformation.h"
#include "displayfile/graphics_system.h"
#include "displayfile/views/scene_in_one_view.h"
#include "tests/predicate_inputs.h"
#include "tests/random_views.h"

// Scenes whose polygons touch as people draw them, in decimals, with a known answer: which polygon
// is in front of which, whatever viewing rounds.

namespace displayfile::test {

/// A number of `places` decimals, as a drawing program has it.
inline double decimal(Source& s, double low, double high, int places = 2) {
  const double scale = std::pow(10.0, places);
  return std::round((low + (high - low) * s.unit()) * scale) / scale;
}

/// The modelling matrix of three rotations and a translation, scaled.
inline glm::dmat4x3 any_matrix(Source& s) {
  ModellingTransformation m;
  if (s.below(2) == 0) {
    const double x = decimal(s, 0.5, 2), y = decimal(s, -2, -0.5), z = decimal(s, 0.5, 2);
    m.scale({x, y, z});
  }
  m.rotate_x(decimal(s, -180, 180));
  m.rotate_y(decimal(s, -180, 180));
  m.rotate_z(decimal(s, -180, 180));
  m.translate({decimal(s, -1, 1), decimal(s, -1, 1), decimal(s, -1, 1)});
  return glm::dmat4x3(m.matrix());
}

inline void view_from_anywhere(Source& s, GraphicsSystem& g, const Ball3& scene = {}) {
  set_view(any_view(s, scene), g);
}

inline void turn_and_move(Source& s, GraphicsSystem& g) {
  g.rotate_x_3(decimal(s, -180, 180));
  g.rotate_y_3(decimal(s, -180, 180));
  g.rotate_z_3(decimal(s, -180, 180));
  g.translate_3(decimal(s, -1, 1), decimal(s, -1, 1), decimal(s, -1, 1));
}

/// A floor with a rug that lies in its plane, polygon 1 on polygon 0.
inline void enter_rug_on_floor(Source& s, GraphicsSystem& g) {
  const double y = decimal(s, -1, 1);
  g.polygon_abs_3({{-2, y, -2}, {-2, y, 2}, {2, y, 2}, {2, y, -2}});
  std::vector<Point3> rug;
  for (const auto& [x, z] : std::array<std::array<double, 2>, 5>{
           {{-1.3, -0.9}, {-1.1, 1.2}, {0.3, 1.4}, {1.5, 0.7}, {1.2, -1.1}}}) {
    rug.emplace_back(x + decimal(s, -0.3, 0.3), y, z + decimal(s, -0.3, 0.3));
  }
  g.polygon_abs_3(rug);
}

/// A window with decimal coordinates in a roof whose slope is decimal: polygon 1 in polygon 0. The
/// window's coordinates lie in the roof's plane up to rounding.
inline void enter_window_in_roof(Source& s, GraphicsSystem& g) {
  const double rise = decimal(s, 0.3, 1.2), foot = decimal(s, -1, 0);
  const auto on_roof = [&](double x, double z) { return Point3(x, foot + rise * z, z); };
  g.polygon_abs_3({on_roof(-2, -1.7), on_roof(2, -1.7), on_roof(2, 1.7), on_roof(-2, 1.7)});
  const double x = decimal(s, -1.2, 0.2), z = decimal(s, -1.1, 0.1);
  const double wide = decimal(s, 0.4, 1.2), high = decimal(s, 0.4, 1.2);
  g.polygon_abs_3(
      {on_roof(x, z), on_roof(x + wide, z), on_roof(x + wide, z + high), on_roof(x, z + high)});
}

/// A box of six polygons.
inline void enter_box(GraphicsSystem& g, const Point3& low, const Point3& high) {
  const auto& [x, y, z] = std::array{low.x, low.y, low.z};
  const auto& [a, b, c] = std::array{high.x, high.y, high.z};
  g.polygon_abs_3({{x, y, z}, {x, b, z}, {a, b, z}, {a, y, z}});
  g.polygon_abs_3({{x, y, c}, {a, y, c}, {a, b, c}, {x, b, c}});
  g.polygon_abs_3({{x, y, z}, {a, y, z}, {a, y, c}, {x, y, c}});
  g.polygon_abs_3({{x, b, z}, {x, b, c}, {a, b, c}, {a, b, z}});
  g.polygon_abs_3({{x, y, z}, {x, y, c}, {x, b, c}, {x, b, z}});
  g.polygon_abs_3({{a, y, z}, {a, b, z}, {a, b, c}, {a, y, c}});
}

/// Boxes on a floor, some on others, some beside others: all in decimals.
inline void enter_boxes_on_floor(Source& s, GraphicsSystem& g) {
  const double y = decimal(s, -1, 0);
  g.polygon_abs_3({{-2, y, -2}, {-2, y, 2}, {2, y, 2}, {2, y, -2}});
  for (int n = s.between(1, 3); n > 0; --n) {
    const double x = decimal(s, -1.5, 0.8), z = decimal(s, -1.5, 0.8), top = y + decimal(s, 0.2, 1);
    const double x_end = x + decimal(s, 0.2, 0.7), z_end = z + decimal(s, 0.2, 0.7);
    enter_box(g, {x, y, z}, {x_end, top, z_end});
    const bool beside = s.below(2) == 0;
    const double other_top = top + decimal(s, 0.1, 0.5);
    if (beside) enter_box(g, {x_end, y, z}, {x_end + decimal(s, 0.1, 0.4), top, z_end});
    if (!beside) enter_box(g, {x, top, z}, {decimal(s, x, x_end), other_top, z_end});
  }
}

/// Windows flush in two walls that meet, drawn with decimals, under a turn of their own.
inline void enter_flush_windows(Source& s, GraphicsSystem& g) {
  g.rotate_y_3(decimal(s, -180, 180));
  for (int wall = 0; wall < 2; ++wall) {
    g.polygon_abs_3({{-1.5, -1, 1.25}, {1.5, -1, 1.25}, {1.5, 1, 1.25}, {-1.5, 1, 1.25}});
    for (int n = s.between(1, 4); n > 0; --n) {
      const double x = decimal(s, -1.4, 0.9), y = decimal(s, -0.9, 0.4);
      const double right = x + decimal(s, 0.2, 0.5), top = y + decimal(s, 0.2, 0.5);
      g.polygon_abs_3({{x, y, 1.25}, {right, y, 1.25}, {right, top, 1.25}, {x, top, 1.25}});
    }
    g.rotate_y_3(90);
  }
}

}  // namespace displayfile::test
