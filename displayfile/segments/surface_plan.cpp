#include "displayfile/segments/surface_plan.h"

#include "clip/base/error.h"

namespace displayfile {

SurfacePlan resolve_surfaces(const HiddenSurfaceOptions& options, const SurfacePlan& unless_set) {
  if (options.sets_applications()) {
    throw Error(
        "removal, z_buffer, lines and touching are set for the application, not for one call: "
        "expected set_hidden_surfaces");
  }
  SurfacePlan plan = unless_set;
  plan.method = options.method.value_or(plan.method);
  if (options.scope) plan.scope = options.scope;
  plan.precision = options.precision.value_or(plan.precision);
  plan.hidden_lines = options.hidden_lines.value_or(plan.hidden_lines);
  plan.line_order = options.line_order.value_or(plan.line_order);
  plan.line_halo = options.line_halo.value_or(plan.line_halo);
  plan.root = options.root;
  plan.threads = options.threads;
  plan.most_pieces = options.most_pieces;
  plan.progress = options.progress;
  plan.budget = options.budget;
  return plan;
}

SurfacePlan resolve_surfaces(const GraphicsSystem& system, const HiddenSurfaceOptions& options) {
  const HiddenSurfaces& set = system.hidden_surfaces();
  SurfacePlan plan = set;
  if (!set.removal) plan.method = HiddenMethod::none;
  if (set.z_buffer) plan.method = HiddenMethod::z_buffer;
  plan.intersections = contains(set.lines.kinds, LineKind::intersection);
  return resolve_surfaces(options, plan);
}

}  // namespace displayfile
