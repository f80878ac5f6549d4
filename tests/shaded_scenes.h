#pragma once

// Polygons whose vertices have normals, for the tests of smooth shading.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "clip/geometry/unit.h"
#include "displayfile/graphics_system.h"
#include "interp/draw/draw.h"
#include "interp/files/picture_compare.h"
#include "interp/visibility/image_space.h"
#include "tests/truth_scenes.h"

namespace displayfile::test {

inline const Point3 kLight{-0.5, 0.7, 1.0};
inline constexpr double kAmbient = 0.2;
inline const FillStyle kFill{FillStyle::Kind::solid, {0.9, 0.6, 0.3}};

struct ShadedScene {
  std::vector<std::vector<Point3>> polygons, normals;
};

inline double along(Dice& dice, double low, double high) {
  return low + (high - low) * dice.part();
}

inline Point3 direction(Dice& dice) {
  Point3 d;
  do {
    d = {along(dice, -1, 1), along(dice, -1, 1), along(dice, -1, 1)};
  } while (glm::length(d) < 0.1);
  return d;
}

/// Triangles through and over the window, with normals of their own making.
inline ShadedScene triangles(std::uint32_t seed, int count) {
  Dice dice(seed);
  ShadedScene scene;
  for (int i = 0; i < count; ++i) {
    std::vector<Point3> triangle, normals;
    const Point3 middle{along(dice, -1, 1), along(dice, -1, 1), along(dice, -1, 1)};
    for (int k = 0; k < 3; ++k) {
      triangle.push_back(middle + 0.6 * direction(dice));
      normals.push_back(direction(dice));
    }
    scene.polygons.push_back(triangle);
    scene.normals.push_back(normals);
  }
  return scene;
}

/// A surface of revolution about y, of quadrilaterals, with its own normals.
inline ShadedScene ball(int around, int up) {
  const auto point = [&](int i, int k) {
    const double a = std::numbers::pi * i / up, b = 2 * std::numbers::pi * k / around;
    return Point3(0.8 * std::sin(a) * std::sin(b), -0.8 * std::cos(a),
                  0.8 * std::sin(a) * std::cos(b));
  };
  ShadedScene scene;
  for (int i = 1; i + 1 < up; ++i) {
    for (int k = 0; k < around; ++k) {
      scene.polygons.push_back(
          {point(i, k), point(i, k + 1), point(i + 1, k + 1), point(i + 1, k)});
      scene.normals.push_back(scene.polygons.back());
    }
  }
  return scene;
}

inline void enter(const ShadedScene& scene, Shading shading, GraphicsSystem& g) {
  g.set_light(kLight, kAmbient);
  g.set_fill_style(kFill);
  g.set_line_style({LineStyle::Kind::none});
  g.set_shading(shading);
  g.open_segment(1);
  for (std::size_t i = 0; i < scene.polygons.size(); ++i) {
    g.set_vertex_normals(scene.normals[i]);
    g.polygon_abs_3(scene.polygons[i]);
  }
  g.close_segment();
}

inline GraphicsSystem drawn(const ShadedScene& scene, Shading shading, bool perspective = false) {
  GraphicsSystem g;
  g.set_hidden_surfaces(
      {.method = HiddenMethod::world_ray_cast});  // retains, in case it is drawn by that
  if (perspective) g.set_perspective({0.3, 0.4, 3.0});
  g.set_view_depth(-2, 2);
  enter(scene, shading, g);
  return g;
}

inline Picture picture(const GraphicsSystem& g, HiddenMethod method, int threads = 1) {
  DrawOptions options{.width = 97, .height = 83, .samples = 1};
  options.surfaces.method = method;
  options.surfaces.threads = threads;
  options.ids = "asked for";
  return draw(g, options);
}

inline double intensity_of(const Point3& normal) {
  return kAmbient + (1 - kAmbient) * std::max(0.0, glm::dot(unit(normal), unit(kLight)));
}

/// Every image-space method shows the same picture; sorted fragments and pieces of the map, whose
/// corners are rounded, the same within one level.
inline void expect_one_picture_by_all_methods(Shading shading) {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const GraphicsSystem g = drawn(triangles(seed, 60), shading, seed == 2);
    const Picture expected = picture(g, HiddenMethod::z_buffer);
    for (const auto& entry : image_space_methods()) {
      for (const int threads : {1, 3}) {
        const Picture seen = picture(g, entry.method, threads);
        EXPECT_EQ(seen.pixels, expected.pixels) << name_of(entry.method);
      }
    }
    for (const HiddenMethod method :
         {HiddenMethod::bsp, HiddenMethod::depth_sort, HiddenMethod::map}) {
      const Picture seen = picture(g, method, 2);
      EXPECT_EQ(seen.ids, expected.ids) << name_of(method);
      EXPECT_LE(compare(seen, expected).largest, 1.0) << name_of(method);
    }
  }
}

}  // namespace displayfile::test
