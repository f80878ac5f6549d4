#include "tests/bench/traversal.h"

#include <cmath>
#include <vector>

#include "hidden/sort/world_tree.h"

namespace displayfile::bench {

namespace {

/// Evenly over all directions: the golden angle's spiral on a sphere.
Point3 direction(int k, int of) {
  const double z = 1.0 - (2.0 * k + 1.0) / of, angle = 2.399963229728653 * k;
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

/// Eye k of so many, for a scene in the unit cube.
Eye eye(int k, int of) {
  const Point3 from = direction(k, of);
  switch (k % 4) {
    case 1: return Eye::at(Point3(0.5) + 2.0 * from);
    case 3: return Eye::at(Point3(0.5) + 0.3 * from);
    default: return Eye::toward(from);
  }
}

}  // namespace

Traversal traversal(const DeviceScene& scene, int eyes) {
  const WorldTree tree(scene.items(), {});
  std::vector<WorldTree::Index> order;
  tree.far_to_near(eye(0, eyes), order);  // the order's memory is there from now on
  std::vector<double> per_polygon, per_piece;
  for (int k = 0; k < eyes; ++k) {
    const double time = seconds([&] { tree.far_to_near(eye(k, eyes), order); });
    per_polygon.push_back(static_cast<double>(scene.size()) / time);
    per_piece.push_back(static_cast<double>(order.size()) / time);
  }
  return {scene.size(), tree.size(), spread(per_polygon), spread(per_piece)};
}

}  // namespace displayfile::bench
