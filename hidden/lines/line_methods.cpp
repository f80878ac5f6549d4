#include "hidden/lines/line_methods.h"

#include "hidden/lines/cell_grid.h"
#include "hidden/lines/convex_objects.h"
#include "hidden/lines/franklin_finder.h"
#include "hidden/lines/roberts_finder.h"
#include "hidden/lines/visible_pieces.h"

namespace displayfile {

SeenLines visible_lines_by_roberts(const Primitives& items, const LineTable& scene,
                                   const SurfacePlan& plan) {
  const ConvexObjects objects(items, scene);
  const ExtentTree tree = extent_tree(objects.extents(), plan.threads);
  const auto find = [&](const auto& policy) {
    return visible_pieces(scene, scene.first_lines(), plan,
                          [&] { return Roberts(scene, objects, tree, policy); });
  };
  const Definitions points{items.points, {}};
  if (plan.precision.exact) return find(ExactLines(points));
  return find(RoundoffLines(points, plan.precision.roundoff));
}

SeenLines visible_lines_by_franklin(const Primitives& items, const LineTable& scene,
                                    const SurfacePlan& plan) {
  const CellGrid grid(scene, plan.threads);
  const std::vector<std::uint32_t> order = grid.lines_by_cell(scene);
  const auto find = [&](const auto& policy) {
    return visible_pieces(scene, order, plan, [&] { return Franklin(scene, grid, policy); });
  };
  const Definitions points{items.points, {}};
  if (plan.precision.exact) return find(ExactLines(points));
  return find(RoundoffLines(points, plan.precision.roundoff));
}

}  // namespace displayfile
