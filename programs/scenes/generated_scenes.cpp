#include "programs/scenes/generated_scenes.h"

#include <algorithm>
#include <cmath>

#include "clip/base/error.h"
#include "programs/scenes/shapes.h"

namespace displayfile {

namespace {

/// The viewer in front of the scene and above it; y is up, and the scene goes back from z = 0.
View view_from_above(double height, double distance) {
  View view;
  view.set_perspective({0.0, height, distance});
  view.set_window({-0.6, 0.6, 0.0, 1.2});
  view.set_depth(-0.5, 4.0);
  return view;
}

/// Buildings on a square of blocks: walls, roof and floor. `height` of a building takes the side of
/// a block.
Scene buildings(std::size_t n, std::uint64_t seed, double (*height)(Random&, double)) {
  Random random(seed);
  Scene scene;
  scene.view = view_from_above(1.4, 2.5);
  const auto blocks =
      std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(n) / 6.0)));
  const double size = 3.0 / static_cast<double>(blocks);
  for (std::size_t row = 0; row < blocks; ++row) {
    for (std::size_t column = 0; column < blocks; ++column) {
      const double x = -1.5 + static_cast<double>(column) * size;
      const double z = -static_cast<double>(row) * size;
      const double width = size * random.between(0.4, 0.95),
                   depth = size * random.between(0.4, 0.95);
      scene.add(box({x, 0.0, z - depth}, {x + width, height(random, size), z}));
    }
  }
  return scene;
}

Scene city(std::size_t n, std::uint64_t seed) {
  return buildings(
      n, seed, [](Random& random, double) { return random.between(0.05, 0.6) * random.unit(); });
}

/// As high as keeps the number of polygons before a pixel about the same for every n.
Scene village(std::size_t n, std::uint64_t seed) {
  return buildings(n, seed,
                   [](Random& random, double size) { return size * random.between(0.3, 1.5); });
}

/// Value noise: heights at whole points, joined smoothly, summed over octaves.
class Heights {
 public:
  explicit Heights(std::uint64_t seed) : seed_(seed) {}
  double at(double x, double y) const {
    double height = 0.0, amplitude = 0.25, scale = 3.0;
    for (int octave = 0; octave < 7; ++octave, amplitude /= 2.0, scale *= 2.0) {
      height += amplitude * smooth(x * scale, y * scale);
    }
    return height;
  }

 private:
  double value(double x, double y) const {
    const auto bits = [](double v) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(v));
    };
    return Random(seed_ ^ Random(bits(x) * 0x1F123BB5u + bits(y)).next()).unit();
  }
  double smooth(double x, double y) const {
    const double left = std::floor(x), low = std::floor(y);
    const auto ease = [](double t) { return t * t * (3.0 - 2.0 * t); };
    const double u = ease(x - left), v = ease(y - low);
    const double below = value(left, low) * (1.0 - u) + value(left + 1.0, low) * u;
    const double above = value(left, low + 1.0) * (1.0 - u) + value(left + 1.0, low + 1.0) * u;
    return below * (1.0 - v) + above * v;
  }
  std::uint64_t seed_;
};

Scene terrain(std::size_t n, std::uint64_t seed) {
  Scene scene;
  scene.view = view_from_above(1.2, 2.0);
  const Heights heights(seed);
  const auto m =
      std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(n) / 2.0)));
  const auto point = [&](std::size_t column, std::size_t row) {
    const double x = -1.5 + 3.0 * static_cast<double>(column) / static_cast<double>(m);
    const double z = -3.0 * static_cast<double>(row) / static_cast<double>(m);
    return Point3(x, heights.at(x + 8.0, z + 8.0), z);
  };
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) {
      const Point3 a = point(column, row), b = point(column + 1, row);
      const Point3 c = point(column + 1, row + 1), d = point(column, row + 1);
      scene.add({a, b, c});
      scene.add({a, c, d});
    }
  }
  return scene;
}

/// As large as keeps the number of polygons before a pixel at about four.
Scene soup(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const double size = 7.0 / std::sqrt(static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 middle = random_point(random);
    Polygon triangle;
    for (int k = 0; k < 3; ++k) triangle.push_back(middle + size * (random_point(random) - 0.5));
    scene.add(triangle);
  }
  return scene;
}

Scene planes(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    const double z = random.between(0.3, 0.7);
    const Sheet sheet = random_sheet(random, z, 0.6);
    scene.add(random_regular(random, 4, {0.3, 0.7}, {0.5, 0.9}, sheet));
  }
  return scene;
}

Scene cycles(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const double size = 3.0 / std::sqrt(static_cast<double>(n));
  while (n >= 3) {
    const std::size_t bars = std::min(n, 3 + random.below(6));
    const Point2 centre = random_place(random);
    const double radius = std::min(0.5, size * random.between(0.5, 1.5)), z = random.unit();
    auto ring = ring_of_bars(bars, centre, radius, 0.1 * radius, 0.0, z, random.unit());
    random.shuffle(ring);
    scene.add(ring);
    n -= bars;
  }
  return scene;
}

Scene needles(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 from = random_point(random);
    const double length = random.between(0.05, 0.5);
    const Point2 along = length * on_circle(random.unit());
    const Point3 to(from.x + along.x, from.y + along.y, random.unit());
    scene.add(bar(from, to, power_of_ten(-2 - static_cast<int>(random.below(4)))));
  }
  return scene;
}

/// One line a scene.
constexpr GeneratedScene kGeneratedScenes[] = {
    {"city", "boxes behind boxes, seen from above", city},
    {"village", "low boxes, seen from above; each overlaps a few others, however many", village},
    {"terrain", "a triangulated height field, seen from above", terrain},
    {"soup", "small random triangles", soup},
    {"planes", "large polygons that all pass through each other; n cover each pixel", planes},
    {"cycles", "rings of 3 to 8 bars that overlap in a cycle", cycles},
    {"needles", "thin slivers, 1e-2 to 1e-5 wide", needles},
};

}  // namespace

std::span<const GeneratedScene> generated_scenes() { return kGeneratedScenes; }

const GeneratedScene& generated_scene(std::string_view name) {
  for (const GeneratedScene& scene : kGeneratedScenes) {
    if (scene.name == name) return scene;
  }
  throw Error("no generated scene of the name " + std::string(name));
}

}  // namespace displayfile
