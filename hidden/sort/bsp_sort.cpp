#include "hidden/sort/bsp_sort.h"

#include "hidden/sort/plain_bsp.h"
#include "hidden/sort/sort_polygons.h"

namespace displayfile {

namespace {

/// By what make(scene) makes of the polygon table.
template <class Make>
SortedPieces sort_by_tree(const Primitives& items, const SurfacePlan& plan, const Make& make) {
  const auto sort = [&](const auto& policy) {
    SortTables scene(items, policy);
    scene.table.most_entries = most_pieces_of_sort(plan, items.items.size());
    auto sorting = make(scene);
    sorting.sort_all();
    SortedPieces pieces = sorted_pieces(scene, sorting.order());
    pieces.depth = sorting.depth();
    return pieces;
  };
  const Definitions points{items.points, {}};
  if (plan.precision.exact) return sort(Exact(points));
  return sort(Roundoff::relative(points, plan.precision.roundoff));
}

}  // namespace

SortedPieces sort_by_bsp(const Primitives& items, const SurfacePlan& plan) {
  return sort_by_tree(items, plan, [&](auto& scene) { return SortPolygons(scene, plan); });
}

SortedPieces sort_by_plain_bsp(const Primitives& items, const SurfacePlan& plan) {
  UnobservedBsp observer;
  return sort_by_tree(items, plan,
                      [&](auto& scene) { return PlainBsp(scene, scene.comparing, observer); });
}

}  // namespace displayfile
