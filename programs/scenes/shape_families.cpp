#include "clip/geometry/planarity.h"
#include "programs/scenes/families.h"
#include "programs/scenes/shapes.h"

// Polygons that are no simple convex shapes.

namespace displayfile {

namespace {

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

}  // namespace

std::vector<HardCase> shape_families() {
  return {
      {"concave",
       "stars that do not cross themselves",
       "inner radius",
       8,
       {0.5, 0.1},
       concave,
       "Several spans a row; a fan of triangles from the first vertex is wrong for these."},
      {"combs",
       "combs across each other",
       "teeth",
       6,
       {8, 40},
       combs,
       "Up to forty spans a row, each thinner than a pixel."},
      {"spirals",
       "spirals of several turns",
       "turns",
       4,
       {2, 5},
       spirals,
       "Concave polygons whose bounding boxes decide nothing; overlap tests by box or by "
       "separating line find nothing to separate."},
      {"crossing_stars",
       "stars that cross themselves, with even-odd holes",
       "points",
       6,
       {5, 11},
       crossing_stars,
       "Filled by winding number, or as a fan, the middle is wrong."},
      {"self_crossing",
       "random polygons that cross themselves",
       "sides",
       6,
       {5, 9, 30},
       self_crossing,
       "Many crossings, and holes between them, by the even-odd rule."},
      {"holes",
       "outlines with a hole, joined by a slit of no width",
       "turn of the hole",
       5,
       {0.0, 0.1},
       holes,
       "The slit's two edges coincide and must leave no trace; the hole must show the polygons "
       "behind it."},
      {"run_through_twice",
       "polygons run through several times",
       "times",
       8,
       {2},
       run_through_twice,
       "By the even-odd rule twice is nothing and three times is once."},
      {"many_sides",
       "two polygons of n sides",
       "roughness",
       400,
       {0.0, 0.3},
       many_sides,
       "Edges far shorter than a pixel, hundreds crossing a row when rough; the suite also enters "
       "it with 10,000 sides."},
      {"not_flat",
       "polygons that are triangulated on entry",
       "bend 10^-s",
       10,
       {1, 3},
       not_flat,
       "A polygon with no plane is cut into triangles that share its identifier."},
      {"bent_within_tolerance",
       "polygons kept whole though not quite flat",
       "part of the tolerance",
       12,
       {0.9, 1e-6},
       bent_within_tolerance,
       "The definition takes the support plane of three vertices everywhere; interpolating along "
       "the edges gives another surface."},
      {"picket_fence",
       "strips before strips",
       "gap 10^-s",
       20,
       {1, 9, 15},
       picket_fence,
       "Narrow strips, edge to edge, a gap before others that lie across them."},
  };
}

}  // namespace displayfile
