#include <cmath>

#include "programs/scenes/families.h"
#include "programs/scenes/shapes.h"

// Coordinates of unlike sizes: offsets, tiny and huge polygons, extreme views.

namespace displayfile {

Scene offset_world(std::size_t n, double bits, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const double offset = std::ldexp(1.0, static_cast<int>(bits));
  scene.view.set_window({offset, offset + 1.0, offset, offset + 1.0});
  for (std::size_t i = 0; i < n; ++i) {  // the world's coordinates have few bits left
    Polygon triangle = random_triangle(random);
    for (Point3& p : triangle) p += Point3(offset, offset, 0.0);
    scene.add(triangle);
  }
  return scene;
}

Scene offset_depth(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const double offset = 1.0 / gap(severity);
  for (std::size_t i = 0; i < n; ++i) {
    Polygon triangle = random_triangle(random);
    for (Point3& p : triangle) p.z += offset;
    scene.add(triangle);
  }
  return scene;
}

Scene extreme_depth_range(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const auto range = static_cast<std::size_t>(severity);
  for (std::size_t i = 0; i < n; ++i) {
    Polygon triangle = random_triangle(random);
    for (Point3& p : triangle) {
      p.z *= power_of_ten(static_cast<int>(random.below(2 * range + 1)) - static_cast<int>(range));
    }
    scene.add(triangle);
  }
  return scene;
}

Scene deep_background(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.add(rectangle(0.0, 0.0, 1.0, 1.0, {-1.0 / gap(severity)}));
  for (std::size_t i = 0; i < n; ++i) {
    const double z = static_cast<double>(random.below(n)) * 1e-6;
    scene.add(random_regular(random, 4, {}, {0.2, 0.5}, {z, 1e-6, 0.0}));
  }
  return scene;
}

Scene subnormal_depths(std::size_t n, double steps, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> all;
  for (std::size_t i = 0; i < n; ++i) {
    Polygon triangle = random_regular(random, 3, {}, {0.5, 0.8}, {0.0});
    for (Point3& p : triangle) {
      p.z = static_cast<double>(random.below(static_cast<std::size_t>(steps))) * 0x1p-1074;
    }
    all.push_back(triangle);
  }
  scene.add(all);
  return scene;
}

Scene tiny_coordinates(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  double tiny = 1.0;
  for (int i = 0; i < static_cast<int>(severity); ++i) tiny /= 10.0;
  for (std::size_t i = 0; i < n; ++i) {  // corners in the picture's corner, by nearly nothing off
    const Point3 corner = tiny * random_point(random), other = tiny * random_point(random);
    const Point2 reach = random_place(random);
    scene.add({corner, {reach.x, other.y, tiny * random.unit()}, {other.x, reach.y, other.z}});
  }
  return scene;
}

Scene shrunken_images(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {  // each covers a pixel's centre, or just misses it
    const double x = (static_cast<double>(random.below(32)) + 0.5) / 32.0;
    const double y = (static_cast<double>(random.below(32)) + 0.5) / 32.0;
    ImageTransformation image;
    image.scale = {gap(severity), gap(severity)};
    image.translation = Point2(x, y) - gap(severity) * Point2(0.5, 0.5);
    scene.open_segment(image);
    for (int k = 0; k < 4; ++k)
      scene.add(random_regular(random, 4, {0.4, 0.6}, {0.1, 0.6}, {0.5, 0.1, 0.1}));
  }
  return scene;
}

Scene giant_images(std::size_t n, double bits, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  ImageTransformation image;
  const double scale = std::ldexp(1.0, static_cast<int>(bits));
  image.scale = {scale, scale};
  image.translation = Point2(0.5 - scale / 2.0, 0.5 - scale / 2.0);
  scene.open_segment(image);
  for (std::size_t i = 0; i < n; ++i) {
    // Edges that pass near the picture's middle, which is that of the large square.
    const Point2 along = 0.4 * on_circle(random.unit());
    const Point2 through = Point2(0.5, 0.5) + random_place(random, {-0.5, 0.5}) / scale;
    const Point2 third = random_place(random);
    scene.add({Point3(through + along, random.unit()), Point3(through - along, random.unit()),
               Point3(third, 0.5)});
  }
  return scene;
}

Scene giant_clipped(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const double size = 1.0 / gap(severity);
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 through = random_place(random), along = size * on_circle(random.unit());
    const Point2 third = size * on_circle(random.unit());
    const double rise = random.between(-0.25, 0.25) * size;
    scene.add({Point3(through - along, 0.5 - rise), Point3(through + along, 0.5 + rise),
               Point3(third, 0.5)});
  }
  return scene;
}

Scene rotated_images(std::size_t n, double angle, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    ImageTransformation image;
    image.rotation = angle * static_cast<double>(i);
    image.scale = {random.below(2) == 0 ? 1.0 : -1.0, 0.75};  // some mirrored
    image.translation = {0.5, 0.5};
    scene.open_segment(image);
    const Sheet sheet{0.5, 0.125, 0.125};
    scene.add(rectangle(0.0, 0.0, 0.5, 0.5, sheet));
    scene.add(random_triangle(random, sheet));
  }
  return scene;
}

Scene collapsed_images(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {  // flattened to a line, or nearly
    ImageTransformation image;
    image.scale = {i % 2 == 0 ? gap(severity) : 1.0, i % 3 == 0 ? 0.0 : 1.0};
    const Point2 pixel(static_cast<double>(random.below(32)), 8.0);
    image.translation = {(pixel.x + 0.5) / 32.0, 0.0};
    scene.open_segment(image);
    scene.add({{-1e-3, 0.0, 0.5}, {1e-3, 0.0, 0.25}, {1e-3, 1.0, 0.75}, {-1e-3, 1.0, 1.0}});
    scene.add(random_triangle(random));
  }
  return scene;
}

namespace {

/// The viewer at `eye` above the view plane z = 0, looking along -z at a window of two by two.
View perspective_view(double eye, double front, double back) {
  View view;
  view.set_perspective({0.0, 0.0, eye});
  view.set_depth(front, back);
  return view;
}

}  // namespace

Scene near_front_plane(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  // The front plane all but touches the viewer: depth is spent on what is near.
  scene.view = perspective_view(1.0, -(1.0 - gap(severity)), 100.0);
  for (std::size_t i = 0; i < n; ++i) {
    const double z = -random.between(1.0, 99.0), reach = 1.0 - z;
    const Point2 place = random_place(random, {-1.0, 1.0});
    Polygon face = regular(4, reach * place, reach * 0.7, random.unit(), {z, 0.01, 0.01});
    scene.add(face);
  }
  return scene;
}

Scene ground_to_horizon(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const double far = 1.0 / gap(severity);
  scene.view = perspective_view(2.0, -1.0, far);
  const double step = far / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {  // road and stripes on it, to the horizon
    const double near = 1.0 - static_cast<double>(i) * step, back = near - 1.5 * step;
    scene.add({{-far, -1.0, near}, {far, -1.0, near}, {far, -1.0, back}, {-far, -1.0, back}});
    const double shift = random.between(-1.0, 1.0);
    scene.add({{shift - 0.5, -1.0, near},
               {shift + 0.5, -1.0, near},
               {shift + 0.5, -1.0, back},
               {shift - 0.5, -1.0, back}});
  }
  return scene;
}

Scene decals_in_perspective(std::size_t n, double slope, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.view = perspective_view(3.0, -1.0, 5.0);
  const Sheet wall{-1.0, slope, slope / 2.0};
  scene.add(rectangle(-2.0, -2.0, 2.0, 2.0, wall));
  for (std::size_t i = 0; i < n; ++i) {
    scene.add(random_regular(random, 4, {-1.5, 1.5}, {0.2, 0.8}, wall));
  }
  return scene;
}

Scene behind_the_viewer(std::size_t n, double reach, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.view = perspective_view(1.0, -0.5, 10.0);
  for (std::size_t i = 0; i < n; ++i) {  // cut where it passes the viewer
    Polygon triangle;
    for (int k = 0; k < 3; ++k) {
      const Point2 place = random_place(random, {-reach, reach});
      triangle.emplace_back(place, random.between(-5.0, 5.0));
    }
    scene.add(triangle);
  }
  return scene;
}

Scene oblique_view(std::size_t n, double slant, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.view.set_parallel({slant, -slant / 3.0, 1.0});
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 low{0.125 * static_cast<double>(random.below(6)),
                     0.125 * static_cast<double>(random.below(6)),
                     0.25 * static_cast<double>(random.below(3))};
    scene.add(box(low, low + 0.25));
  }
  return scene;
}

}  // namespace displayfile
