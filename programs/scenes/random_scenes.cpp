#include "programs/scenes/random_scenes.h"

#include "programs/scenes/shapes.h"

namespace displayfile {

Scene random_degenerate_scene(std::uint64_t seed) {
  constexpr std::size_t kGrids[] = {8, 6, 7, 64};
  Random random(seed);
  Scene scene;
  const std::size_t grid = kGrids[random.below(4)];
  const std::size_t levels = 3 + random.below(3);
  const bool tilted = random.below(2) == 0;
  const auto on_grid = [&](std::size_t steps) {
    return static_cast<double>(random.below(steps + 1)) / static_cast<double>(steps);
  };
  const std::size_t polygons = 2 + random.below(11);
  for (std::size_t i = 0; i < polygons; ++i) {
    const std::size_t sides = 3 + random.below(4);
    const double z0 = 0.25 + on_grid(levels - 1) / 2.0;
    const Sheet sheet{z0, (on_grid(2) - 0.5) / 4.0, (on_grid(2) - 0.5) / 4.0};
    const bool free_levels = sides == 3 && random.below(2) == 0;
    Polygon polygon(sides);
    for (Point3& p : polygon) {
      p = {on_grid(grid), on_grid(grid), 0.0};
      if (free_levels) {
        p.z = on_grid(levels - 1);
      } else {
        p.z = tilted ? sheet.at(p.x, p.y) : sheet.z0;
      }
    }
    scene.add(polygon);
  }
  return scene;
}

}  // namespace displayfile
