#pragma once

#include "displayfile/display_file.h"
#include "interp/output_device.h"

namespace displayfile {

/// Which instructions to interpret. With a z-buffer all fills are drawn before any line, so
/// that a line meets the final depths (and wins where they are equal); without one everything
/// is drawn in order.
enum class Pass { everything, fills, lines };

/// Walks the visible segments in order of creation, applies their image transformations and
/// hands each instruction to the device.
void interpret(const DisplayFile& display_file, OutputDevice& device, Pass pass = Pass::everything);

}  // namespace displayfile
