#include "hidden/lines/franklin.h"

#include "hidden/lines/cell_grid.h"
#include "hidden/lines/franklin_finder.h"
#include "hidden/lines/visible_pieces.h"

namespace displayfile {

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
