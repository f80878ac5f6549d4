#pragma once

#include "clip/view.h"
#include "programs/scenes/scene.h"
#include "tests/predicate_inputs.h"
#include "tests/random_views.h"

// Polygons on a coarse grid about the unit cube, so that they touch, cross and coincide, and views
// of which some clip them.

namespace displayfile::test {

inline double step(Source& s) { return s.between(-1, 5) / 4.0; }
inline Point3 any_vertex(Source& s) {
  if (s.below(4) == 0) return {s.unit(), s.unit(), s.unit()};
  return {step(s), step(s), step(s)};
}

inline Polygon triangle(Source& s) { return {any_vertex(s), any_vertex(s), any_vertex(s)}; }

/// Exactly in one plane; some concave or self-crossing.
inline Polygon flat(Source& s) {
  const int kind = s.below(3);
  const double at = step(s);
  Polygon polygon;
  for (int sides = s.between(4, 7); sides > 0; --sides) {
    const double a = step(s), b = step(s);
    if (kind == 0) polygon.push_back({a, b, at});
    if (kind == 1) polygon.push_back({at, a, b});
    if (kind == 2) polygon.push_back({a, b, at - a - b});
  }
  return polygon;
}

/// Flat within the tolerance only.
inline Polygon bent(Source& s) {
  Polygon polygon = {{0.125, 0.25, 0.5}, {0.875, 0.25, 0.5}, {0.875, 0.75, 0.5}, {0.25, 0.75, 0.5}};
  for (Point3& p : polygon) p.z += 1e-7 * s.unit();
  return polygon;
}

/// Some clip, some are set in a corner of the picture.
inline View any_clipping_view(Source& s) {
  View view = any_view(s);
  view.front_clipping = s.below(3) == 0;
  view.back_clipping = s.below(3) == 0;
  if (view.back_clipping) view.set_depth(view.front, view.front + (view.back - view.front) * 0.4);
  if (s.below(3) == 0) view.set_viewport({0.25, 0.75, 0.0, s.below(2) == 0 ? 0.5 : 0.7});
  return view;
}

}  // namespace displayfile::test
