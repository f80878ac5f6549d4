#include "programs/scenes/families.h"
#include "programs/scenes/shapes.h"

// Polygons that are no simple convex shapes.

namespace displayfile {

namespace {

Sheet any_sheet(Random& random) {
  const double z = random.between(0.3, 0.7);
  return random_sheet(random, z, 0.5);
}

}  // namespace

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

Scene concave(std::size_t n, double depth, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {  // stars with as many points, not crossing themselves
    const Sheet sheet = any_sheet(random);
    const Point2 centre = random_place(random, {0.3, 0.7});
    const std::size_t points = 3 + random.below(8);
    const double radius = random.between(0.2, 0.6), turn = random.unit();
    Polygon star;
    for (std::size_t k = 0; k < 2 * points; ++k) {
      const double turns = turn + static_cast<double>(k) / (2.0 * static_cast<double>(points));
      const double r = k % 2 == 0 ? radius : radius * depth;
      star.push_back(sheet.point(centre + r * on_circle(turns)));
    }
    scene.add(star);
  }
  return scene;
}

Scene combs(std::size_t n, double teeth, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const auto count = static_cast<std::size_t>(teeth);
  for (std::size_t i = 0; i < n; ++i) {
    const Sheet sheet = any_sheet(random);
    const double left = random.between(-0.1, 0.1), width = random.between(0.8, 1.2) / teeth;
    const bool upright = i % 2 == 0;
    const auto point = [&](double x, double y) {
      return upright ? sheet.point(x, y) : sheet.point(y, x);
    };
    Polygon comb;
    for (std::size_t k = 0; k < count; ++k) {
      const double x = left + static_cast<double>(k) * width;
      comb.insert(comb.end(), {point(x, 0.9), point(x, 0.1), point(x + width / 2.0, 0.1),
                               point(x + width / 2.0, 0.9)});
    }
    comb.push_back(point(left + teeth * width, 0.95));
    comb.push_back(point(left, 0.95));
    scene.add(comb);
  }
  return scene;
}

Scene spirals(std::size_t n, double turns, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    const Sheet sheet = any_sheet(random);
    const Point2 centre = random_place(random, {0.4, 0.6});
    const double start = random.unit();
    const auto steps = static_cast<std::size_t>(12.0 * turns);
    const auto arm = [&](std::size_t k, double width) {
      const double part = static_cast<double>(k) / static_cast<double>(steps);
      return sheet.point(centre + (0.5 * part + width) * on_circle(start + part * turns));
    };
    Polygon spiral;
    for (std::size_t k = 0; k <= steps; ++k) spiral.push_back(arm(k, 0.01));
    for (std::size_t k = steps + 1; k-- > 0;) spiral.push_back(arm(k, 0.01 + 0.25 / turns));
    scene.add(spiral);
  }
  return scene;
}

Scene crossing_stars(std::size_t n, double points, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const auto count = static_cast<std::size_t>(points);
  for (std::size_t i = 0; i < n; ++i) {  // {points / step}: even-odd leaves holes
    const Polygon round = random_regular(random, count, {0.3, 0.7}, {0.3, 0.6}, any_sheet(random));
    Polygon star;
    for (std::size_t k = 0; k < count; ++k) star.push_back(round[k * (count / 2) % count]);
    scene.add(star);
  }
  return scene;
}

Scene self_crossing(std::size_t n, double sides, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    const Sheet sheet = any_sheet(random);
    Polygon tangle;
    for (int k = 0; k < static_cast<int>(sides); ++k) {
      tangle.push_back(sheet.point(random_place(random)));
    }
    scene.add(tangle);
  }
  return scene;
}

Scene holes(std::size_t n, double slit, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {  // an outline and a hole, joined by a slit of no width
    const Sheet sheet = any_sheet(random);
    const Point2 centre = random_place(random, {0.3, 0.7});
    const double turn = random.unit();
    Polygon outline = regular(7, centre, 0.45, turn, sheet);
    outline.push_back(outline.front());
    Polygon hole = backwards(regular(5, centre, 0.25, turn + slit, sheet));
    hole.push_back(hole.front());
    outline.insert(outline.end(), hole.begin(), hole.end());
    scene.add(outline);
  }
  return scene;
}

Scene run_through_twice(std::size_t n, double times, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {  // even-odd: twice is nothing, three times is once
    const Polygon once = random_triangle(random, any_sheet(random));
    Polygon repeated;
    for (std::size_t k = 0; k < static_cast<std::size_t>(times) + i % 2; ++k) {
      repeated.insert(repeated.end(), once.begin(), once.end());
    }
    scene.add(repeated);
  }
  return scene;
}

Scene many_sides(std::size_t n, double jitter, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (int polygon = 0; polygon < 2; ++polygon) {
    const Sheet sheet = any_sheet(random);
    const Point2 centre = random_place(random, {0.4, 0.6});
    Polygon round;
    for (std::size_t k = 0; k < n; ++k) {
      const double radius = 0.4 + jitter * (random.unit() - 0.5);
      const double turns = static_cast<double>(k) / static_cast<double>(n);
      round.push_back(sheet.point(centre + radius * on_circle(turns)));
    }
    scene.add(round);
  }
  return scene;
}

Scene not_flat(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    const Sheet sheet = any_sheet(random);
    Polygon bent = random_regular(random, 4 + random.below(4), {}, {0.3, 0.6}, sheet);
    for (Point3& p : bent) p.z += gap(severity) * (random.unit() - 0.5);
    scene.add(bent);
  }
  return scene;
}

Scene bent_within_tolerance(std::size_t n, double part, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Sheet sheet{0.5, 0.125, 0.25};
  for (std::size_t i = 0; i < n; ++i) {  // kept whole: the support plane is not all vertices'
    Polygon bent = random_regular(random, 4 + random.below(4), {}, {0.3, 0.6}, sheet);
    for (Point3& p : bent) p.z += part * kFlatnessTolerance * (random.unit() - 0.5);
    scene.add(bent);
  }
  return scene;
}

Scene picket_fence(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> pickets;
  const double width = 1.0 / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i) * width;
    pickets.push_back(rectangle(x, 0.0, x + width, 1.0, {0.5, 0.0, 0.25}));
    pickets.push_back(rectangle(0.0, x, 1.0, x + width, {0.5 + gap(severity), 0.0, 0.25}));
    if (i % 2 == 0) pickets.pop_back();
  }
  random.shuffle(pickets);
  scene.add(pickets);
  return scene;
}

}  // namespace displayfile
