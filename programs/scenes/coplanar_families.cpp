#include "programs/scenes/families.h"
#include "programs/scenes/shapes.h"

// Coplanar polygons: at equal depths the one entered later is visible.

namespace displayfile {

namespace {

/// A sheet whose depths are exact for coordinates with up to 40 bits.
constexpr Sheet kExactSheet{0.25, 0.25, 0.125};

Scene coplanar_copies(std::size_t n, double slope, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Sheet sheet = random_sheet(random, 0.5, slope);
  const Polygon large = regular(3, {0.5, 0.5}, 0.7, random.unit(), sheet);
  for (std::size_t i = 0; i < n; ++i) scene.add(large);
  return scene;
}

Scene coplanar_turned(std::size_t n, double slope, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Sheet sheet = random_sheet(random, 0.5, slope);
  const Polygon large = regular(3, {0.5, 0.5}, 0.7, random.unit(), sheet);
  for (std::size_t i = 0; i < n; ++i) {
    const Polygon turned = begun_at(large, random.below(3));
    scene.add(random.below(2) == 0 ? turned : backwards(turned));
  }
  return scene;
}

Scene coplanar_patches(std::size_t n, double bits, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    Polygon patch;
    for (int k = 0; k < 3; ++k) {
      const double x = random.dyadic(static_cast<int>(bits));
      patch.push_back(kExactSheet.point(x, random.dyadic(static_cast<int>(bits))));
    }
    scene.add(patch);
  }
  return scene;
}

Scene coplanar_rounded(std::size_t n, double slope, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Sheet sheet = random_sheet(random, 0.5, slope);
  for (std::size_t i = 0; i < n; ++i) scene.add(random_triangle(random, sheet));
  return scene;
}

Scene coplanar_entry_orders(std::size_t n, double levels, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> stacks;
  const std::size_t m = side_of_square(n);
  const double size = 1.0 / static_cast<double>(m);
  for (std::size_t k = 0; k < m * m; ++k) {
    const double x = static_cast<double>(k % m) * size, y = static_cast<double>(k / m) * size;
    for (int level = 0; level < static_cast<int>(levels); ++level) {
      const double inset = size * level / (4.0 * levels);
      stacks.push_back(
          rectangle(x + inset, y + inset, x + size - inset, y + size - inset, kExactSheet));
    }
  }
  random.shuffle(stacks);
  scene.add(stacks);
  return scene;
}

Scene checker_over_base(std::size_t n, double slope, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Sheet sheet{0.5, slope * 0.25, slope * -0.125};
  const std::size_t m = side_of_square(n);
  std::vector<Polygon> tiles;
  for (std::size_t k = 0; k < m * m; ++k) {
    if ((k % m + k / m) % 2 != 0) continue;
    const auto at = [&](std::size_t i) { return static_cast<double>(i) / static_cast<double>(m); };
    tiles.push_back(rectangle(at(k % m), at(k / m), at(k % m + 1), at(k / m + 1), sheet));
  }
  tiles.insert(tiles.begin() + static_cast<std::ptrdiff_t>(random.below(2) * tiles.size() / 2),
               rectangle(0.0, 0.0, 1.0, 1.0, sheet));
  scene.add(tiles);
  return scene;
}

Scene decals(std::size_t n, double levels, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    Polygon decal;
    for (int k = 0; k < 3; ++k) {
      const double x = random.dyadic(20);
      decal.push_back(kExactSheet.point(x, random.dyadic(20)));
    }
    for (int level = 0; level < static_cast<int>(levels); ++level) {
      scene.add(decal);
      for (Point3& p : decal) p = decal[0] + (p - decal[0]) * 0.5;  // exact
    }
  }
  return scene;
}

Scene coplanar_fan_over_polygon(std::size_t n, double slope, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Sheet sheet = random_sheet(random, 0.5, slope);
  const Polygon whole = regular(n, {0.5, 0.5}, 0.5, random.unit(), sheet);
  scene.add(whole);
  const Point3 middle = sheet.point(0.5, 0.5);
  for (std::size_t i = 0; i < n; i += 2) scene.add({middle, whole[i], whole[(i + 1) % n]});
  return scene;
}

}  // namespace

std::vector<HardCase> coplanar_families() {
  return {
      {"coplanar_copies",
       "one tilted triangle entered n times",
       "slope",
       16,
       {0.0, 0.7, 30.0},
       coplanar_copies,
       "Every depth ties, and the last copy must be visible; the arithmetic is the same each time, "
       "so this is the control of the group: a comparison by 'nearer or equal' is right."},
      {"coplanar_turned",
       "one tilted triangle, begun at another vertex or run backwards each time",
       "slope",
       16,
       {0.7, 30.0},
       coplanar_turned,
       "The plane is exactly the same, but a depth computed from another vertex or another edge "
       "rounds differently, so the ties are broken at random."},
      {"coplanar_patches",
       "triangles in one plane, coordinates of few bits",
       "bits of a coordinate",
       20,
       {4, 10, 20},
       coplanar_patches,
       "All triangles lie exactly in one plane and tie exactly wherever they overlap; adding "
       "slopes from row to row and pixel to pixel breaks the ties."},
      {"coplanar_rounded",
       "triangles in one plane but for the rounding of their z",
       "slope",
       20,
       {0.0, 0.7, 30.0},
       coplanar_rounded,
       "The triangles look coplanar but are not: each vertex is off by half of its last place, and "
       "that decides. A tolerance treats this as a tie and shows the later one."},
      {"coplanar_entry_orders",
       "stacks of coplanar squares, entered in every order",
       "levels",
       16,
       {3, 8},
       coplanar_entry_orders,
       "The insets are rounded, so that the squares of a stack are only nearly coplanar, and each "
       "stack has another order: a rule that is right for one order fails for the next."},
      {"checker_over_base",
       "tiles of a checker on a base polygon in the same plane",
       "slope",
       36,
       {0.0, 0.7},
       checker_over_base,
       "The tiles' corners are sixths, so a tilted tile and the base differ by rounding alone."},
      {"decals",
       "triangles of half the size in the plane of the ones before",
       "levels",
       6,
       {6},
       decals,
       "Exactly coplanar at every level, with coordinates of many bits; the last level entered "
       "must be wholly visible."},
      {"coplanar_fan",
       "every second triangle of a polygon's fan, on the polygon",
       "slope",
       30,
       {0.0, 0.7},
       coplanar_fan_over_polygon,
       "A polygon and triangles through the same vertices have different support planes once the "
       "vertices are rounded."},
  };
}

}  // namespace displayfile
