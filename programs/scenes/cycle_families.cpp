#include "programs/scenes/families.h"
#include "programs/scenes/shapes.h"

// Polygons that overlap in a cycle: no order of painting is right.

namespace displayfile {

namespace {

/// Midway between two steps of every integer depth format: at one half, which lies on the border
/// between two, depths would be distinguished however close.
constexpr double kLevel = 0.4;

Scene cycle(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  auto bars = ring_of_bars(n, {0.5, 0.5}, 0.4, gap(severity), 0.0, kLevel, random.unit());
  random.shuffle(bars);
  scene.add(bars);
  return scene;
}

Scene every_cycle(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t sides = 3; sides <= n; ++sides) {
    const Point2 centre = random_place(random, {0.2, 0.8});
    const double radius = random.between(0.1, 0.5), z = random.between(0.4, 0.6);
    auto bars = ring_of_bars(sides, centre, radius, gap(severity), 0.0, z, random.unit());
    random.shuffle(bars);
    scene.add(bars);
  }
  return scene;
}

Scene nested_cycles(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> all;
  for (std::size_t ring = 0; ring < n; ++ring) {  // all at one depth: they cycle with each other
    const double radius = 0.5 * static_cast<double>(ring + 1) / static_cast<double>(n);
    for (Polygon& p : ring_of_bars(3 + ring, {0.5, 0.5}, radius, gap(severity), 0.0, kLevel,
                                   static_cast<double>(ring) / 7.0)) {
      all.push_back(p);
    }
  }
  random.shuffle(all);
  scene.add(all);
  return scene;
}

Scene piercing_cycle(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  auto bars =
      ring_of_bars(n, {0.5, 0.5}, 0.4, gap(severity), 3.0 * gap(severity), kLevel, random.unit());
  random.shuffle(bars);
  scene.add(bars);
  return scene;
}

Scene weave(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> pieces;
  const double step = 1.0 / static_cast<double>(n), half = 0.3 * step;
  const auto middle = [&](std::size_t i) { return (static_cast<double>(i) + 0.5) * step; };
  const auto z = [&](std::size_t i, std::size_t k) {  // over and under in turn
    return kLevel + ((i + k) % 2 == 0 ? 1.0 : -1.0) * gap(severity);
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k + 1 < n; ++k) {
      const double a = middle(k), b = middle(k + 1), across = middle(i);
      pieces.push_back({{a, across - half, z(i, k)},
                        {b, across - half, z(i, k + 1)},
                        {b, across + half, z(i, k + 1)},
                        {a, across + half, z(i, k)}});
      pieces.push_back({{across - half, a, z(i, k + 1)},
                        {across + half, a, z(i, k + 1)},
                        {across + half, b, z(i, k)},
                        {across - half, b, z(i, k)}});
    }
  }
  random.shuffle(pieces);
  scene.add(pieces);
  return scene;
}

Scene mikado(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 middle = random_place(random, {0.3, 0.7});
    const Point2 along = 0.5 * on_circle(random.unit());
    const double rise = gap(severity) * (random.unit() - 0.5), z = kLevel;
    scene.add(bar(Point3(middle - along, z - rise), Point3(middle + along, z + rise), 0.05));
  }
  return scene;
}

}  // namespace

std::vector<HardCase> cycle_families() {
  return {
      {"cycle_of_3", "three bars, each over the next", "gap 10^-s", 3, kGaps, cycle,
       "The smallest scene that no order of painting gets right; with a small gap it is z-fighting "
       "as well."},
      {"cycle", "a ring of n bars, each over the next", "gap 10^-s", 7, kGaps, cycle,
       "Like three bars, but the cycle is found only by examining all bars."},
      {"every_cycle",
       "rings of 3, 4, ... n bars on each other",
       "gap 10^-s",
       20,
       {2, 9},
       every_cycle,
       "Cycles of every length up to 20, which also overlap and pierce each other."},
      {"nested_cycles",
       "rings in rings, all at one depth",
       "gap 10^-s",
       6,
       {2, 9, 15},
       nested_cycles,
       "Rings of different depth slopes lie across each other at the same depth: cycles between "
       "the cycles."},
      {"piercing_cycle",
       "a ring of bars that also pass through each other",
       "gap 10^-s",
       6,
       {2, 9, 15},
       piercing_cycle,
       "The bars roll: each passes through its neighbours as well as over and under them, so "
       "neither sorting nor cutting at outlines suffices."},
      {"weave", "strips over and under in turn", "gap 10^-s", 6, kGaps, weave,
       "Every strip is before half of the others and behind the other half, and pieces of a strip "
       "share edges that must not crack."},
      {"mikado",
       "long bars that lie across each other",
       "gap 10^-s",
       20,
       {1, 9, 15},
       mikado,
       "Nearly coplanar bars in many cycles, with crossings among them."},
  };
}

}  // namespace displayfile
