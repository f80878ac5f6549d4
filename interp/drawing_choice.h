#pragma once

#include "interp/draw.h"
#include "interp/visibility/auto_method.h"

namespace displayfile {

/// drawing_method (interp/draw.h), and why it is that.
MethodChoice drawing_choice(const GraphicsSystem& system, const DrawOptions& options,
                            PictureKind kind);

}  // namespace displayfile
