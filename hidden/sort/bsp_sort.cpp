#include "hidden/sort/bsp_sort.h"

#include "hidden/sort/sort_polygons.h"

namespace displayfile {

SortedPieces sort_by_bsp(const Primitives& items, const SortOptions& options) {
  const auto sort = [&](const auto& policy) {
    SortScene scene(items, policy);
    scene.table.most_entries = most_pieces_of_sort(options, items.items.size());
    SortPolygons sorting(scene, options);
    sorting.sort_all();
    SortedPieces pieces = sorted_pieces(scene, sorting.order());
    pieces.depth = sorting.depth();
    return pieces;
  };
  const Definitions points{items.points, {}};
  if (options.precision.exact) return sort(Exact(points));
  return sort(Roundoff::relative(points, options.precision.roundoff));
}

}  // namespace displayfile
