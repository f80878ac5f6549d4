#include "tests/bench/touching_scenes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "clip/view/transformation.h"
#include "programs/scenes/shapes.h"

namespace displayfile::bench {

namespace {

/// As a number with two decimals is read.
double decimal(double x) { return std::round(x * 100.0) / 100.0; }
double decimal(Random& random, double low, double high) {
  return decimal(random.between(low, high));
}

/// The cells along a side of a square for `polygons` polygons at `polygons_a_cell` each.
std::size_t cells_a_side(std::size_t polygons, std::size_t polygons_a_cell) {
  return std::max<std::size_t>(1, side_of_square(polygons / polygons_a_cell));
}

/// A view in perspective of all that was drawn, from in front, above and the right.
void look_at(const Point3& middle, double radius, Scene& scene) {
  const Point3 into = glm::normalize(Point3(-0.37, -0.62, -0.71));
  View view;
  view.set_reference_point(middle);
  view.set_plane_normal(into);
  view.set_perspective(middle - 2.5 * radius * into);
  view.set_window({-radius, radius, -radius, radius});
  view.set_depth(-radius, radius);
  scene.view = view;
}

struct Ball {
  Point3 middle;
  double radius;
};
Ball around(const Scene& scene) {
  Point3 low = scene.points.front(), high = low;
  for (const Point3& p : scene.points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return {0.5 * low + 0.5 * high, 0.5 * glm::distance(low, high)};
}

/// A scene without placements, in a view of all of it.
Scene seen(Scene scene) {
  const Ball ball = around(scene);
  look_at(ball.middle, ball.radius, scene);
  return scene;
}

/// The same under a modelling transformation of three rotations and a translation.
Scene turned(Scene scene) {
  const Ball ball = around(scene);
  const Point3 degrees(11.0, 34.0, -7.0), then_move(0.31, -0.72, 0.23);
  scene.place(-ball.middle, degrees, then_move);
  scene.placements.back().first_polygon = 0;
  look_at(then_move, ball.radius, scene);
  return scene;
}

/// A square on the ground, larger than the objects on it.
Polygon ground(double side) {
  return {{-0.5, 0.0, -0.5}, {-0.5, 0.0, side}, {side, 0.0, side}, {side, 0.0, -0.5}};
}

// ---- A city -----------------------------------------------------------------------------

/// A level rectangle on the ground, or an upright one in the wall that faces +z or +x.
Polygon marking(double x, double z, double wide, double deep) {
  return {{x, 0.0, z}, {x, 0.0, z + deep}, {x + wide, 0.0, z + deep}, {x + wide, 0.0, z}};
}
Polygon window_to_front(double x, double y, double z, double size) {
  return {{x, y, z}, {x + size, y, z}, {x + size, y + size, z}, {x, y + size, z}};
}
Polygon window_to_right(double x, double y, double z, double size) {
  return {{x, y, z + size}, {x, y, z}, {x, y + size, z}, {x, y + size, z + size}};
}

void add_building(Random& random, double x, double z, Scene& scene) {
  const Point3 low(x + 0.2, 0.0, z + 0.2);
  const Point3 high(decimal(random, x + 0.7, x + 0.95), decimal(random, 0.4, 2.0),
                    decimal(random, z + 0.7, z + 0.95));
  scene.add(box(low, high));
  constexpr double kSize = 0.12;
  for (const double along : {0.08, 0.29}) {
    for (const double up : {0.1, 0.25}) {
      scene.add(window_to_front(low.x + along, up, high.z, kSize));
      scene.add(window_to_right(high.x, up, low.z + along, kSize));
    }
  }
}

Scene city_as_drawn(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const std::size_t side = cells_a_side(n, 16);  // a building, eight windows and two markings
  scene.add(ground(static_cast<double>(side)));
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      const auto x = static_cast<double>(column), z = static_cast<double>(row);
      add_building(random, x, z, scene);
      scene.add(marking(x + 0.08, z + 0.2, 0.04, decimal(random, 0.3, 0.6)));
      scene.add(marking(x + 0.2, z + 0.08, decimal(random, 0.3, 0.6), 0.04));
    }
  }
  return scene;
}

// ---- Bricks with studs ------------------------------------------------------------------

/// A prism of six sides that stands on a level plane.
void add_stud(const Point3& foot, double radius, double height, Scene& scene) {
  Polygon bottom, top;
  for (std::size_t k = 0; k < 6; ++k) {
    const Point2 corner = radius * on_circle(static_cast<double>(k) / 6.0);
    bottom.push_back(foot + Point3(corner.x, 0.0, corner.y));
    top.push_back(foot + Point3(corner.x, height, corner.y));
  }
  scene.add(bottom);
  scene.add(top);
  for (std::size_t k = 0; k < 6; ++k) {
    const std::size_t next = (k + 1) % 6;
    scene.add({bottom[k], bottom[next], top[next], top[k]});
  }
}

Scene bricks_as_drawn(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Point3 size(0.6, 0.36, 0.3);
  const std::size_t side = cells_a_side(n, 55);  // 2.5 bricks of 22 polygons
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      const std::size_t high = 1 + random.below(4);
      for (std::size_t up = 0; up < high; ++up) {  // corners are computed, as a loop draws bricks
        const Point3 low = size * Point3(static_cast<double>(column), static_cast<double>(up),
                                         static_cast<double>(row));
        scene.add(box(low, low + size));
        for (const double along : {0.25, 0.75}) {
          add_stud(low + size * Point3(along, 1.0, 0.5), 0.09, 0.06, scene);
        }
      }
    }
  }
  return scene;
}

// ---- Voxels -----------------------------------------------------------------------------

Scene voxels_as_drawn(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  constexpr double kSize = 0.1;
  const std::size_t side = cells_a_side(n, 18);  // three voxels of six faces
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      const std::size_t high = 1 + random.below(5);
      for (std::size_t up = 0; up < high; ++up) {
        const Point3 low(static_cast<double>(column), static_cast<double>(up),
                         static_cast<double>(row));
        scene.add(box(kSize * low, kSize * (low + 1.0)));
      }
    }
  }
  return scene;
}

// ---- Bars -------------------------------------------------------------------------------

/// A bar chart in three dimensions: bars of two parts side by side, on a ground.
Scene bars_as_drawn(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  constexpr double kPitch = 0.7;
  const std::size_t side = cells_a_side(n, 12);
  scene.add(ground(decimal(kPitch * static_cast<double>(side))));
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      const double x = kPitch * static_cast<double>(column), z = kPitch * static_cast<double>(row);
      const double middle = decimal(random, 0.2, 1.5);
      const double top = middle + decimal(random, 0.2, 1.0);
      scene.add(box({x, 0.0, z}, {x + kPitch, middle, z + kPitch}));
      scene.add(box({x, middle, z}, {x + kPitch, top, z + kPitch}));
    }
  }
  return scene;
}

template <Scene (*drawn)(std::size_t, std::uint64_t)>
Scene seen(std::size_t n, std::uint64_t seed) {
  return seen(drawn(n, seed));
}
template <Scene (*drawn)(std::size_t, std::uint64_t)>
Scene turned(std::size_t n, std::uint64_t seed) {
  return turned(drawn(n, seed));
}

constexpr TouchingScene kTouchingScenes[] = {
    {"streets", "buildings with windows in their walls, on a ground with markings",
     seen<city_as_drawn>},
    {"streets-turned", "the same, turned and moved", turned<city_as_drawn>},
    {"bricks", "stacks of bricks with studs on them", seen<bricks_as_drawn>},
    {"bricks-turned", "the same, turned and moved", turned<bricks_as_drawn>},
    {"voxels", "stacks of cubes, with all their faces", seen<voxels_as_drawn>},
    {"voxels-turned", "the same, turned and moved", turned<voxels_as_drawn>},
    {"bars", "a bar chart of bars in two parts, side by side on a ground", seen<bars_as_drawn>},
    {"bars-turned", "the same, turned and moved", turned<bars_as_drawn>},
};

}  // namespace

std::span<const TouchingScene> touching_scenes() { return kTouchingScenes; }

}  // namespace displayfile::bench
