#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>
#include <sstream>
#include <string>

#include "clip/view.h"
#include "tests/predicate_inputs.h"

// Views of a scene in a ball, from anywhere, for the tests of scenes sorted once and seen from many
// eyes.

namespace displayfile::test {

inline Point3 any_direction(Source& s) {
  const double z = 2.0 * s.unit() - 1.0, angle = 2.0 * std::numbers::pi * s.unit();
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

struct Ball3 {
  Point3 middle{0.5};
  double radius = 0.87;  ///< of the unit cube's
};
/// A ball that all the points are well inside of.
inline Ball3 ball_around(std::span<const Point3> points) {
  Point3 low = points.front(), high = low;
  for (const Point3& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return {0.5 * (low + high), 0.51 * glm::length(high - low)};
}

/// Looking along `into`, which way up does not matter.
inline View looking(const Point3& into) {
  View view;
  view.set_plane_normal(into);
  view.set_up(std::abs(into.y) > 0.9 * glm::length(into) ? Point3(1, 0, 0) : Point3(0, 1, 0));
  return view;
}

/// From outside, all of the scene in the window.
inline View parallel_view(const Point3& into, const Point3& direction, const Ball3& scene) {
  View view = looking(into);
  view.set_reference_point(scene.middle);
  view.set_parallel(direction);
  view.set_depth(-2.0 * scene.radius, 2.0 * scene.radius);
  view.set_window({-scene.radius, scene.radius, -scene.radius, scene.radius});
  return view;
}
/// Every other one is oblique.
inline View any_parallel_view(Source& s, const Ball3& scene = {}) {
  const Point3 into = any_direction(s);
  const Point3 aside = 0.3 * any_direction(s);
  return parallel_view(into, s.below(2) == 0 ? into : into + aside, scene);
}

inline View perspective_view(const Point3& eye, const Point3& into, double half_window,
                             const Ball3& scene) {
  const double unit = scene.radius;  // the view plane's distance
  View view = looking(into);
  view.set_reference_point(eye + unit * glm::normalize(into));
  view.set_perspective(eye);
  view.set_depth(-0.5 * unit, 4.0 * unit);
  const double half = half_window * unit;
  view.set_window({-half, half, -half, half});
  return view;
}
/// From outside, or from among the polygons.
inline View any_perspective_view(Source& s, const Ball3& scene = {}) {
  const Point3 direction = any_direction(s);
  if (s.below(2) == 0) {
    const double away = (1.1 + 3.0 * s.unit()) * scene.radius;
    return perspective_view(scene.middle - away * direction, direction, 1.05 * scene.radius / away,
                            scene);
  }
  const Point3 into = any_direction(s);
  const double out = 0.7 * scene.radius * s.unit();
  return perspective_view(scene.middle + out * direction, into, 1.0, scene);
}
inline View any_view(Source& s, const Ball3& scene = {}) {
  return s.below(2) == 0 ? any_parallel_view(s, scene) : any_perspective_view(s, scene);
}

inline std::string text_of(const View& view) {
  std::ostringstream out;
  out.precision(17);
  const auto put = [&](const char* name, const Point3& p) {
    out << name << " " << p.x << " " << p.y << " " << p.z << "; ";
  };
  const bool perspective = view.projection == View::Projection::perspective;
  put("reference point", view.reference_point);
  put("normal", view.plane_normal);
  put("up", view.up);
  put(perspective ? "perspective" : "parallel",
      perspective ? view.centre_of_projection : view.direction_of_projection);
  out << "window " << view.window.x_min << " " << view.window.x_max << " " << view.window.y_min
      << " " << view.window.y_max;
  return out.str();
}

}  // namespace displayfile::test
