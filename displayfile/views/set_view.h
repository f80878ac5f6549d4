#pragma once

#include "clip/view.h"
#include "displayfile/graphics_system.h"

namespace displayfile {

/// Sets where the view plane is and how it is projected to. Throws Error as the system's routines
/// do, here as below.
void set_camera(const View& view, GraphicsSystem& system);

/// Sets all of the view but the viewport.
void set_view(const View& view, GraphicsSystem& system);

}  // namespace displayfile
