#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/predicate_inputs.h"
#include "tests/sort_scenes.h"

// Scenes for the tests of sort(whole=True) of the Python package.

namespace displayfile::test {

/// Polygons, and lines after them, in device coordinates, as the Python package enters them.
struct PaintedScene {
  std::vector<Loop> polygons;
  std::vector<std::pair<Point3, Point3>> lines;
};

struct TurnedView {
  double a, b, distance;
  explicit TurnedView(Source& s)
      : a(2.0 * std::numbers::pi * s.unit()),
        b(std::numbers::pi * (s.unit() - 0.5)),
        distance(s.below(2) == 0 ? 0.0 : 2.0 + 4.0 * s.unit()) {}
  /// From a cube of side 1 about the origin into the picture's, seen from some side, in
  /// perspective or not.
  Point3 operator()(const Point3& p) const {
    const double x = p.x * std::cos(a) - p.y * std::sin(a),
                 y = p.x * std::sin(a) + p.y * std::cos(a);
    const double up = y * std::sin(b) + p.z * std::cos(b),
                 near = p.z * std::sin(b) - y * std::cos(b);
    const double w = distance == 0.0 ? 1.0 : 1.0 - near / distance;
    return {0.5 + 0.4 * x / w, 0.5 + 0.4 * up / w, 0.5 + 0.4 * near / w};
  }
};

/// The quadrilaterals of a surface over a grid: they touch, and are not flat.
inline void add_surface(Source& s, const TurnedView& view, PaintedScene& scene) {
  const int n = s.between(2, 9), m = s.between(2, 9);
  const double wave = 6.0 * s.unit(), phase = 6.0 * s.unit(), height = 0.4 * s.unit(),
               level = 0.4 * (s.unit() - 0.5);
  const bool round = s.below(2) == 0;
  const auto at = [&](int i, int j) {
    const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / m;
    if (round) {
      const double turn = 2.0 * std::numbers::pi * u, tilt = std::numbers::pi * (v - 0.5);
      return view({0.5 * std::cos(turn) * std::cos(tilt), 0.5 * std::sin(turn) * std::cos(tilt),
                   level + height * std::sin(tilt)});
    }
    return view({u - 0.5, v - 0.5,
                 level + height * std::sin(wave * u + phase) * std::cos(wave * v - phase)});
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      scene.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
}

/// Bars beside each other, whose sides touch.
inline void add_bars(Source& s, const TurnedView& view, PaintedScene& scene) {
  const int n = s.between(1, 4), m = s.between(1, 4);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      const double x0 = static_cast<double>(i) / n - 0.5, y0 = static_cast<double>(j) / m - 0.5;
      const double x1 = static_cast<double>(i + 1) / n - 0.5,
                   y1 = static_cast<double>(j + 1) / m - 0.5, z = s.between(0, 6) / 6.0 - 0.5;
      const auto face = [&](Loop corners) {
        for (Point3& p : corners) p = view(p);
        scene.polygons.push_back(corners);
      };
      for (const double level : {-0.5, z}) {
        face({{x0, y0, level}, {x1, y0, level}, {x1, y1, level}, {x0, y1, level}});
      }
      for (const double y : {y0, y1}) face({{x0, y, -0.5}, {x1, y, -0.5}, {x1, y, z}, {x0, y, z}});
      for (const double x : {x0, x1}) face({{x, y0, -0.5}, {x, y1, -0.5}, {x, y1, z}, {x, y0, z}});
    }
  }
}

/// Thin ones among others.
inline void add_slivers(Source& s, PaintedScene& scene) {
  for (int k = s.between(3, 12); k > 0; --k) {
    const Point3 a = in_cube(s), b = in_cube(s), c = in_cube(s);
    const double width = s.below(3) == 0 ? 1.0 : std::pow(10.0, -s.between(1, 12));
    scene.polygons.push_back({a, b, a + 0.5 * (b - a) + width * (c - a)});
  }
}

inline PaintedScene of_family(Source& s, const SortFamily& family) {
  const ItemList list = family.make(s);
  PaintedScene scene;
  for (std::size_t k = 0; k < list.items.size(); ++k) {
    const auto given = list.points_of(k);
    const Loop loop(given.begin(), given.end());
    if (list.items[k].kind == ItemList::Kind::line) {
      scene.lines.emplace_back(loop[0], loop[1]);
    } else {
      scene.polygons.push_back(loop);
    }
  }
  return scene;
}

/// Says some corners twice: as closed rings do, or with a step to them that is next to nothing.
inline void repeat_corners(Source& s, Loop& loop) {
  const auto any = [&] {
    return static_cast<std::ptrdiff_t>(s.below(static_cast<int>(loop.size())));
  };
  if (s.below(2) == 0) loop.push_back(loop.front());
  if (s.below(4) == 0) {
    const std::ptrdiff_t k = any();
    loop.insert(loop.begin() + k, loop[static_cast<std::size_t>(k)]);
  }
  if (s.below(4) == 0) {
    const std::ptrdiff_t k = any();
    const Point3 p = loop[static_cast<std::size_t>(k)],
                 q = loop[static_cast<std::size_t>(k + 1) % loop.size()];
    loop.insert(loop.begin() + k + 1, p + std::pow(10.0, -s.between(8, 17)) * (q - p));
  }
}

/// Moves and scales it by a power of two, so that all of it is in the picture.
inline void bring_into_picture(PaintedScene& scene) {
  Point3 low(std::numeric_limits<double>::infinity()), high = -low;
  const auto each = [&](const auto& use) {
    for (Loop& loop : scene.polygons) std::ranges::for_each(loop, use);
    for (auto& [from, to] : scene.lines) use(from), use(to);
  };
  each([&](const Point3& p) { low = glm::min(low, p), high = glm::max(high, p); });
  int exponent = 0;
  std::frexp(std::max({high.x - low.x, high.y - low.y, high.z - low.z}), &exponent);
  each([&](Point3& p) { p = std::ldexp(1.0, -exponent) * (p - low); });
}

inline PaintedScene any_scene(Source& s) {
  PaintedScene scene;
  const TurnedView view(s);
  switch (s.below(6)) {
    case 0: add_surface(s, view, scene); break;
    case 1:
      add_surface(s, view, scene);
      add_surface(s, view, scene);
      break;
    case 2: add_bars(s, view, scene); break;
    case 3:
      add_slivers(s, scene);
      if (s.below(2) == 0) add_surface(s, view, scene);
      break;
    default: {
      const auto& families = sort_families();
      scene = of_family(
          s, families[static_cast<std::size_t>(s.below(static_cast<int>(families.size())))]);
    }
  }
  for (int k = s.below(4) == 0 ? s.between(1, 5) : 0; k > 0; --k) {
    const Point3 a = in_cube(s), b = in_cube(s);
    scene.lines.emplace_back(a, b);
  }
  if (s.below(3) == 0) {
    for (Loop& loop : scene.polygons) {
      if (s.below(2) == 0) repeat_corners(s, loop);
    }
  }
  bring_into_picture(scene);
  return scene;
}

inline std::string text_of(const PaintedScene& scene) {
  std::ostringstream out;
  out.precision(17);
  for (const Loop& loop : scene.polygons) {
    for (const Point3& p : loop) out << "  " << p.x << " " << p.y << " " << p.z;
    out << "\n";
  }
  for (const auto& [a, b] : scene.lines) {
    out << "line " << a.x << " " << a.y << " " << a.z << "  " << b.x << " " << b.y << " " << b.z
        << "\n";
  }
  return out.str();
}

/// A place where some polygon of the scene is, or anywhere.
inline Point2 any_place(Source& s, const PaintedScene& scene) {
  if (scene.polygons.empty() || s.below(4) == 0) return {s.unit(), s.unit()};
  const Loop& loop =
      scene.polygons[static_cast<std::size_t>(s.below(static_cast<int>(scene.polygons.size())))];
  const int corners = static_cast<int>(loop.size()), i = s.below(corners),
            j = i + s.between(1, corners - 1), k = j + s.between(1, corners - 1);
  const auto corner = [&](int n) { return loop[static_cast<std::size_t>(n % corners)]; };
  const Point3 a = corner(i), b = corner(j), c = corner(k % corners == i ? k + 1 : k);
  const double t = s.unit(), u = s.unit();
  const Point3 p = a + t * (b - a), q = p + u * (c - p);
  return {q.x, q.y};
}

}  // namespace displayfile::test
