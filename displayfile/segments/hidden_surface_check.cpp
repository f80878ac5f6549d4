#include "displayfile/segments/hidden_surface_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "clip/base/budgeted_work.h"
#include "clip/base/memory.h"
#include "clip/base/work_budget.h"
#include "displayfile/segments/cuts_at_vertices.h"
#include "displayfile/segments/scene_lines.h"
#include "hidden/sort/touching_vertices.h"

namespace displayfile {

namespace {

SortedPieces pieces_of(const ViewedScene& scene, const SurfacePlan& plan) {
  if (finds_lines(plan.method)) {
    return lines_in_order(scene, find_lines(scene, plan), plan.hidden_lines);
  }
  if (plan.method == HiddenMethod::map) return map_in_order(scene, plan);
  Primitives items = scene.primitives();
  if (!plan.precision.exact) {  // a ROUNDOFF decides which polygons are coplanar
    items.planes = {};
    items.plane_rests = {};
    items.touching = 0.0;
  }
  SortedPieces sorted = sort_hidden_surfaces(items, plan);
  put_cuts_at_vertices(scene, sorted);
  append_lines(scene, plan, sorted);
  return sorted;
}

bool sorts(HiddenMethod method) {
  return is_object_space(method) && method != HiddenMethod::map && !finds_lines(method);
}

/// The limit set by the plan and the budget in force.
std::size_t limit_of_pieces(const SurfacePlan& plan) {
  return sorts(plan.method) ? most_pieces_of_sort(plan, 0) : most_pieces_in_force();
}

/// The plan to be kept, with the limit that was in force.
SurfacePlan kept(const SurfacePlan& plan) {
  SurfacePlan kept = plan.kept();
  kept.most_pieces = limit_of_pieces(plan);
  return kept;
}

std::shared_ptr<const SortedScene> sorted_scene(ViewedScene viewed,
                                                const ImageTransformation& image,
                                                const SurfacePlan& plan) {
  SortedPieces pieces = pieces_of(viewed, plan);
  const auto hidden = static_cast<std::size_t>(std::ranges::count(pieces.hidden, 1));
  const SortCounts counts{pieces.pieces.size() - hidden, pieces.cuts, pieces.comparisons,
                          pieces.depth};
  double moved = viewed.boundary_error() + cuts_may_move(viewed);
  if (plan.precision.exact && vertices_touch(viewed.touching_of_ends())) moved += kTouchingStrip;
  auto ordered = std::make_shared<OrderedScene>(OrderedScene{
      std::make_shared<ViewedScene>(std::move(viewed)), std::move(pieces), plan.kept()});
  return std::make_shared<SortedScene>(
      SortedScene{{std::move(ordered)}, image, kept(plan), counts, moved});
}

/// Returns the result of `sort`, which has at least every point in its tables.
template <class Sort>
std::shared_ptr<const SortedScene> with_memory_of_sort(std::size_t points, HiddenMethod method,
                                                       Sort&& sort) {
  return with_memory(
      points * sizeof(Point3),
      [&] { return fmt::format("sorting {} points by {}", points, name_of(method)); }, sort);
}

}  // namespace

bool is_object_space(HiddenMethod by) {
  const HiddenMethod method = surfaces_of(by);
  return method == HiddenMethod::bsp || method == HiddenMethod::depth_sort ||
         method == HiddenMethod::plain_bsp || method == HiddenMethod::map || finds_lines(method);
}

std::size_t most_pieces_in_force() {
  const WorkBudget* const budget = work_in_force().budget;
  const std::uint64_t most = budget == nullptr ? WorkLimits::kNone : budget->limits().pieces;
  return static_cast<std::size_t>(
      std::min<std::uint64_t>(most, std::numeric_limits<std::size_t>::max()));
}

/// A sort may briefly have one piece more than in the end, when it tries a cut. The number of
/// pieces of a map or of lines is not kept.
bool is_within_limit(const SortedScene& sorted, const SurfacePlan& plan) {
  const SurfacePlan now = plan.by(sorted.plan.method);
  const std::size_t limit = limit_of_pieces(now);
  if (limit >= sorted.plan.most_pieces) return true;
  const bool limits_lines = most_pieces_in_force() != std::numeric_limits<std::size_t>::max();
  std::uint64_t pieces = sorted.counts.cuts + 1;
  for (const auto& part : sorted.parts) {
    if (limits_lines && part->scene->has_lines()) return false;
    pieces += part->scene->items();
  }
  return sorts(now.method) && pieces <= limit;
}

std::shared_ptr<const SortedScene> hidden_surface_check(
    const std::shared_ptr<const Instructions>& entered, const ImageTransformation& image,
    const SurfacePlan& set) {
  const SurfacePlan plan = set.by(surfaces_of(set.method));
  return with_memory_of_sort(entered->points(), plan.method, [&] {
    return sorted_scene(ViewedScene(entered, image), image, plan);
  });
}

std::shared_ptr<const SortedScene> hidden_surface_check(std::span<const Segment* const> segments,
                                                        const SurfacePlan& set) {
  const SurfacePlan plan = set.by(surfaces_of(set.method));
  std::size_t points = 0;
  for (const Segment* segment : segments) points += segment->entered()->points();
  return with_memory_of_sort(points, plan.method,
                             [&] { return sorted_scene(ViewedScene(segments), {}, plan); });
}

}  // namespace displayfile
