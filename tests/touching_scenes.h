#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/set_view.h"
#include "tests/predicate_inputs.h"
#include "tests/random_views.h"

// Scenes whose polygons touch as people draw them, in decimals, with a known answer: which polygon
// is in front of which, whatever viewing rounds.

namespace displayfile::test {

/// A number with so many decimals, as a drawing program has it.
inline double decimal(Source& s, double low, double high, int places = 2) {
  const double scale = std::pow(10.0, places);
  return std::round((low + (high - low) * s.unit()) * scale) / scale;
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
/// doubles of the window lie in the roof's plane but for rounding.
inline void enter_window_in_roof(Source& s, GraphicsSystem& g) {
  const double rise = decimal(s, 0.3, 1.2), foot = decimal(s, -1, 0);
  const auto on_roof = [&](double x, double z) { return Point3(x, foot + rise * z, z); };
  g.polygon_abs_3({on_roof(-2, -1.7), on_roof(2, -1.7), on_roof(2, 1.7), on_roof(-2, 1.7)});
  const double x = decimal(s, -1.2, 0.2), z = decimal(s, -1.1, 0.1);
  const double wide = decimal(s, 0.4, 1.2), high = decimal(s, 0.4, 1.2);
  g.polygon_abs_3(
      {on_roof(x, z), on_roof(x + wide, z), on_roof(x + wide, z + high), on_roof(x, z + high)});
}

}  // namespace displayfile::test
