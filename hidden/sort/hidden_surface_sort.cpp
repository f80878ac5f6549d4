#include "hidden/sort/hidden_surface_sort.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/base/work_budget.h"
#include "hidden/sort/plain_bsp.h"
#include "hidden/sort/sort_polygons.h"

namespace displayfile {

namespace {

/// Sorts by the tree that make(scene) returns.
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

/// The textbook's sort (algorithms 9.8 to 9.16) at the precision of the plan: a tree of polygons,
/// each node's plane separates its front from its back (hidden/sort/bsp.md).
SortedPieces sort_by_bsp(const Primitives& items, const SurfacePlan& plan) {
  return sort_by_tree(items, plan, [&](auto& scene) { return SortPolygons(scene, plan); });
}

/// The same by the textbook's tree (hidden/sort/plain_bsp.h), without choosing roots.
SortedPieces sort_by_plain_bsp(const Primitives& items, const SurfacePlan& plan) {
  UnobservedBsp observer;
  return sort_by_tree(items, plan,
                      [&](auto& scene) { return PlainBsp(scene, scene.comparing, observer); });
}

}  // namespace

SortedPieces sort_hidden_surfaces(const Primitives& items, const SurfacePlan& plan) {
  constexpr const char* kInstead =
      "hidden-surface method map, which has visible pieces only, or for pixels z-buffer";
  switch (plan.method) {
    case HiddenMethod::bsp: {
      const NamedWork named({"the sort by bsp", kInstead});
      return sort_by_bsp(items, plan);
    }
    case HiddenMethod::plain_bsp: {
      const NamedWork named({"the sort by plain-bsp", kInstead});
      return sort_by_plain_bsp(items, plan);
    }
    case HiddenMethod::depth_sort: {
      const NamedWork named({"the sort by depth-sort", kInstead});
      return sort_by_depth(items, plan);
    }
    default:
      throw Error("the hidden-surface method " + std::string(name_of(plan.method)) +
                  " does not sort: expected bsp, depth-sort or plain-bsp");
  }
}

std::size_t most_pieces_of_sort(const SurfacePlan& plan, std::size_t items) {
  std::uint64_t most = plan.most_pieces;
  const WorkBudget* const budget = work_in_force().budget;
  if (budget != nullptr && budget->limits().pieces != WorkLimits::kNone) {
    const bool is_set = plan.most_pieces != kMostPieces;
    most = is_set ? std::min(most, budget->limits().pieces) : budget->limits().pieces;
  }
  return std::max(static_cast<std::size_t>(
                      std::min<std::uint64_t>(most, std::numeric_limits<std::size_t>::max())),
                  items);
}

}  // namespace displayfile
