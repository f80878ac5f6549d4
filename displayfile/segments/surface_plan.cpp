#include "displayfile/segments/surface_plan.h"

namespace displayfile {

SurfacePlan resolve_surfaces(const HiddenSurfaceOptions& options) {
  return {.method = options.method.value_or(HiddenMethod::automatic),
          .precision = options.precision.value_or(Precision{}),
          .root = options.root,
          .hidden_lines = options.hidden_lines.value_or(HiddenLines::none),
          .line_order = options.line_order.value_or(LineOrder::entry),
          .line_halo = options.line_halo.value_or(0.0),
          .scope = options.scope,
          .threads = options.threads,
          .most_pieces = options.most_pieces,
          .progress = options.progress,
          .budget = options.budget};
}

SurfacePlan resolve_surfaces(const GraphicsSystem& system, const HiddenSurfaceOptions& options) {
  const HiddenSurfaces set = system.hidden_surfaces();
  HiddenSurfaceOptions whole = options;
  if (!whole.method) whole.method = set.removal ? set.method : HiddenMethod::none;
  if (!options.method && set.z_buffer) whole.method = HiddenMethod::z_buffer;
  if (!whole.scope) whole.scope = set.scope;
  if (!whole.precision) whole.precision = set.precision;
  if (!whole.hidden_lines) whole.hidden_lines = set.hidden_lines;
  if (!whole.line_order) whole.line_order = set.line_order;
  if (!whole.line_halo) whole.line_halo = set.line_halo;
  SurfacePlan plan = resolve_surfaces(whole);
  plan.intersections = contains(set.lines.kinds, LineKind::intersection);
  return plan;
}

}  // namespace displayfile
