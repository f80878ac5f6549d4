#pragma once

#include "clip/view.h"
#include "displayfile/graphics_system.h"

namespace displayfile {

/// Sets the view plane and the projection. Throws Error as the system's routines do, here and
/// below.
void set_camera(const View& view, GraphicsSystem& system);

/// Sets all of the view except the viewport.
void set_view(const View& view, GraphicsSystem& system);

}  // namespace displayfile
