#pragma once

#include <string>

#include "clip/surfaces.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/sorted_display_file.h"

namespace displayfile {

/// True if a line of the visible segments is hidden, and the display file is drawn in order of
/// entry, so that nothing finds its hidden parts. `orders_count`: false where an order was found.
bool leaves_hidden_lines(const DisplayFile& display_file, bool orders_count, int threads);

/// Throws Error if the options set hidden lines, and a dump of the display file, updated for the
/// method, omits some because it is in order of entry.
void require_hidden_lines_dumped(const DisplayFile& display_file, HiddenMethod method,
                                 const HiddenSurfaceOptions& options);

/// The reason why that method does not draw hidden lines, for an Error or a warning.
std::string words_of_hidden_lines_left(HiddenMethod method);

}  // namespace displayfile
