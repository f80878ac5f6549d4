#include "displayfile/segments/surface_plan.h"

namespace displayfile {

SurfacePlan resolve_surfaces(const HiddenSurfaceOptions& options) {
  return {.options = options,
          .method = options.method.value_or(HiddenMethod::automatic),
          .precision = options.precision.value_or(Precision{}),
          .hidden_lines = options.hidden_lines.value_or(HiddenLines::none),
          .intersections = options.intersections};
}

SurfacePlan resolve_surfaces(const GraphicsSystem& system, const HiddenSurfaceOptions& options) {
  const HiddenMethod sorted =
      system.hidden_surfaces().removal ? system.hidden_surfaces().method : HiddenMethod::none;
  const HiddenMethod set = system.hidden_surfaces().z_buffer ? HiddenMethod::z_buffer : sorted;
  return {.options = options,
          .method = options.method.value_or(set),
          .precision = options.precision.value_or(system.hidden_surfaces().precision),
          .hidden_lines = options.hidden_lines.value_or(system.hidden_surfaces().hidden_lines),
          .intersections = contains(system.hidden_surfaces().lines.kinds, LineKind::intersection),
          .scope_of_application = system.hidden_surfaces().scope};
}

}  // namespace displayfile
