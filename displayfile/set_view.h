#pragma once

#include "clip/view.h"
#include "displayfile/graphics_system.h"

namespace displayfile {

/// Sets all of the view but the viewport. Throws Error as the system's routines do.
void set_view(const View& view, GraphicsSystem& system);

}  // namespace displayfile
