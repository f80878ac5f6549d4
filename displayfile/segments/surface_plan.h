#pragma once

#include "clip/surfaces.h"
#include "displayfile/graphics_system.h"

namespace displayfile {

/// The plan for a system's picture: the call's options, and otherwise the application's settings.
/// The method is that of the options, or the one set by set_z_buffer, set_hidden_line_removal and
/// set_hidden_method; it may be `automatic`. The scope is that of either, if set.
SurfacePlan resolve_surfaces(const GraphicsSystem& system, const HiddenSurfaceOptions& options);
/// The plan without an application: `unless_set`, overridden by the options. Throws Error, here and
/// above, for options that belong to the application.
SurfacePlan resolve_surfaces(const HiddenSurfaceOptions& options,
                             const SurfacePlan& unless_set = {});

}  // namespace displayfile
