#pragma once

#include <span>

#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// Sets a view that shows the meshes whole: a three-quarter perspective from the front (the side
/// of positive z), a little from the right and from above, y up; the window fitted to the
/// projected faces with a small margin, the view depth enclosing them. `aspect` is the picture's
/// width over its height. Also sets the light, from over the viewer's left shoulder. Throws Error
/// if the aspect ratio is not a positive number, the meshes have no faces, or a segment is open.
void fit_view(std::span<const Mesh> meshes, GraphicsSystem& system, double aspect = 1.0);

}  // namespace displayfile
