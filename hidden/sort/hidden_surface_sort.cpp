#include "hidden/sort/hidden_surface_sort.h"

#include <string>

#include "clip/error.h"
#include "hidden/sort/bsp_sort.h"
#include "hidden/sort/depth_sort.h"

namespace displayfile {

SortedPieces sort_hidden_surfaces(const Primitives& items, HiddenMethod method,
                                  const SortOptions& options) {
  switch (method) {
    case HiddenMethod::bsp: return sort_by_bsp(items, options);
    case HiddenMethod::depth_sort: return sort_by_depth(items, options);
    default:
      throw Error("the hidden-surface method " + std::string(name_of(method)) +
                  " does not sort: expected bsp or depth-sort");
  }
}

}  // namespace displayfile
