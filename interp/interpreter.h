#pragma once

#include "displayfile/display_file.h"
#include "displayfile/viewed_scene.h"
#include "interp/output_device.h"

namespace displayfile {

/// Which instructions to interpret. With a z-buffer all fills are drawn before any line, so
/// that a line meets the final depths (and wins where they are equal); without one everything
/// is drawn in order.
enum class Pass { everything, fills, lines };

/// Which order of the instructions: that of drawing, back to front where hidden surfaces were
/// sorted, or that of entry, every polygon whole, for a method that finds hidden surfaces itself.
enum class Order { drawn, entered };

/// Walks the visible segments in order of creation, applies their image transformations and
/// hands each instruction to the device. Where all visible segments were sorted together, a
/// segment may begin and end several times. The widths and dashes of lines are so many times as
/// large: they are in pixels, and a pixel may have several samples across.
void interpret(const DisplayFile& display_file, OutputDevice& device, Pass pass = Pass::everything,
               Order order = Order::drawn, double line_scale = 1.0);

/// Hands the lines and the drawn sides of a scene's polygons to the device, in order of entry, as
/// interpret does with Pass::lines.
void interpret_lines(const ViewedScene& scene, OutputDevice& device, double line_scale = 1.0);

}  // namespace displayfile
