#include "programs/scenes/families.h"
#include "programs/scenes/shapes.h"

// Polygons whose vertices or edges coincide.

namespace displayfile {

namespace {

Scene repeated_vertices(std::size_t n, double times, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    const Polygon plain = random_triangle(random, any_sheet(random));
    Polygon repeated;
    for (const Point3& p : plain)
      repeated.insert(repeated.end(), 1 + random.below(static_cast<std::size_t>(times)), p);
    scene.add(begun_at(repeated, random.below(repeated.size())));
  }
  return scene;
}

Scene first_three_in_line(std::size_t n, double pieces, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {  // no plane can be had from the first three vertices
    Polygon polygon;
    for (int k = 0; k < 4; ++k) polygon.push_back({random.dyadic(4), random.dyadic(4), 0.0});
    Polygon cut;
    const auto parts = static_cast<std::size_t>(pieces);
    for (std::size_t k = 0; k < 4; ++k) {
      const Point3 from = polygon[k], to = polygon[(k + 1) % 4];
      for (std::size_t part = 0; part < parts; ++part) {
        cut.push_back(from + (to - from) * (static_cast<double>(part) / pieces));
      }
    }
    const Sheet sheet{random.dyadic(3) / 2.0, 0.25, -0.125};
    for (Point3& p : cut) p.z = sheet.at(p.x, p.y);
    scene.add(cut);
  }
  return scene;
}

Scene zero_area(std::size_t n, double slope, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.add(rectangle(0.25, 0.25, 0.75, 0.75, {0.25, 0.125, slope}));
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 a = random_point(random), b = random_point(random);
    switch (i % 5) {
      case 0: scene.add({a, a, a}); break;
      case 1: scene.add({a, b, a}); break;
      case 2: scene.add({a, b, b, a}); break;
      case 3: scene.add({a, 0.5 * (a + b), b}); break;
      default: {  // there and back, along two edges
        const Point3 c = random_point(random);
        scene.add({a, b, c, b});
      }
    }
  }
  return scene;
}

Scene spikes(std::size_t n, double length, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {  // a triangle with out-and-back edges at its corners
    const Sheet sheet = any_sheet(random);
    Polygon spiky;
    for (const Point3& p : random_triangle(random, sheet)) {
      const Point2 tip = Point2(p) + length * on_circle(random.unit());
      spiky.insert(spiky.end(), {p, sheet.point(tip), p});
    }
    scene.add(spiky);
  }
  return scene;
}

}  // namespace

std::vector<HardCase> degenerate_families() {
  return {
      {"repeated_vertices",
       "triangles with vertices given several times",
       "times",
       12,
       {4},
       repeated_vertices,
       "Edges of no length, and three first vertices that are one point: no plane by the usual "
       "cross product."},
      {"first_three_in_line",
       "polygons whose first vertices define no plane",
       "pieces of a side",
       10,
       {2, 4},
       first_three_in_line,
       "The first three vertices are in line; the plane must be found from others. Corners on a "
       "coarse grid also put edges through centres."},
      {"zero_area",
       "polygons of no area, in front of a square",
       "slope",
       30,
       {0.0, 0.5},
       zero_area,
       "Points, segments, and there-and-back polygons cover nothing: a control for stray pixels."},
      {"spikes",
       "triangles with out-and-back edges of no width",
       "length",
       12,
       {0.5},
       spikes,
       "The spike's two edges coincide and cancel; the farthest vertices, which fix the plane, are "
       "spike tips."},
  };
}

}  // namespace displayfile
