#include <cmath>

#include "clip/view/transformation.h"
#include "programs/scenes/families.h"
#include "programs/scenes/shapes.h"

// Coordinates of unlike sizes: offsets, tiny and huge polygons, extreme views.

namespace displayfile {

namespace {

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
    // Edges that pass near the picture's middle, the middle of the large square.
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

}  // namespace

std::vector<HardCase> scale_families() {
  return {
      {"offset_world",
       "a window far from the origin",
       "offset 2^s",
       12,
       {20, 40, 49},
       offset_world,
       "World coordinates have only a few bits left below the window's size; vertices fall on a "
       "coarse grid, and many on centres."},
      {"offset_depth",
       "all depths far from zero",
       "offset 10^s",
       12,
       {3, 9, 15},
       offset_depth,
       "The detail is in the last digits of z: single precision has none left, and integers are "
       "clamped. OSMesa's depth range starts at the offset here, so it loses nothing."},
      {"extreme_depth_range",
       "depths of all sizes in one scene",
       "10^-s to 10^s",
       16,
       {3, 12, 50},
       extreme_depth_range,
       "One triangle's depths span a hundred powers of ten; scaling to [0,1] loses all small "
       "ones."},
      {"deep_background",
       "small steps in depth before a far background",
       "its depth -10^s",
       12,
       {1, 6, 12},
       deep_background,
       "Steps of 1e-6 before a background at up to -1e12: a depth range fitted to the scene, such "
       "as OSMesa's here, has no digits left for them. Below 0, integers clamp."},
      {"subnormal_depths",
       "depths of a few times the smallest double",
       "steps",
       12,
       {2, 30},
       subnormal_depths,
       "Products of depth differences underflow to zero: all is one plane to every filter that "
       "ignores underflow."},
      {"tiny_coordinates",
       "coordinates close to zero",
       "size 10^-s",
       16,
       {12, 100, 300, 320},
       tiny_coordinates,
       "Corners within 1e-320 of the picture's corner, depths as small: products of two "
       "coordinates underflow."},
      {"shrunken_images",
       "image transformations that shrink a segment about a pixel's centre",
       "scale 10^-s",
       100,
       {3, 8, 15},
       shrunken_images,
       "A whole segment falls around one centre; slopes of depth become enormous, and "
       "single-precision vertices coincide."},
      {"giant_images",
       "image transformations that enlarge far beyond the picture",
       "scale 2^s",
       12,
       {10, 20, 40},
       giant_images,
       "Vertices a million pictures away, edges that pass through this one: absolute errors of the "
       "vertices' size would cover the picture."},
      {"giant_clipped",
       "triangles far larger than the window, clipped",
       "size 10^s",
       12,
       {3, 6, 12},
       giant_clipped,
       "The clip pipeline's cuts are rounded; the picture is judged by the clipped coordinates, "
       "which are no longer quite flat."},
      {"rotated_images",
       "the same square, turned and mirrored by image transformations",
       "angle in degrees",
       8,
       {90, 45, 1},
       rotated_images,
       "Coplanar by construction, up to the rounding of the transformation."},
      {"collapsed_images",
       "image transformations that flatten a segment",
       "scale 10^-s",
       20,
       {3, 15},
       collapsed_images,
       "A scale of zero makes all edge-on: nothing may be drawn. A scale of 1e-15 leaves slivers "
       "at centres."},
  };
}

}  // namespace displayfile
