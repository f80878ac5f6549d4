#pragma once

#include "clip/surface_plan.h"
#include "displayfile/graphics_system.h"

namespace displayfile {

/// How the surfaces of a system's picture are found: as the call's options have it, and where they
/// leave it open as the application set it. The method is that of the options, or else what the
/// application set with set_z_buffer, set_hidden_line_removal and set_hidden_method; it may be
/// `automatic`. The scope is that of either, if one is set.
SurfacePlan resolve_surfaces(const GraphicsSystem& system, const HiddenSurfaceOptions& options);
/// Where there is no application: exactly, without hidden lines, by `automatic` unless the options
/// set something else.
SurfacePlan resolve_surfaces(const HiddenSurfaceOptions& options);

}  // namespace displayfile
