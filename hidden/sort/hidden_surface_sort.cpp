#include "hidden/sort/hidden_surface_sort.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/base/work_budget.h"
#include "hidden/sort/bsp_sort.h"
#include "hidden/sort/depth_sort.h"

namespace displayfile {

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
