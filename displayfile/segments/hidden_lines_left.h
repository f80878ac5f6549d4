#pragma once

#include <string>

#include "clip/surfaces.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/sorted_display_file.h"

namespace displayfile {

/// True if some line of the visible segments is hidden, and the display file is drawn in order of
/// entry, so that nothing finds where. `orders_count`: not where an order was found.
bool leaves_hidden_lines(const DisplayFile& display_file, bool orders_count, int threads);

/// Throws Error if the options ask for hidden lines, and a dump of the display file, which was
/// brought up to date for the method, leaves some out: it is in order of entry.
void require_hidden_lines_dumped(const DisplayFile& display_file, HiddenMethod method,
                                 const HiddenSurfaceOptions& options);

/// Why hidden lines are not drawn by that method: for an Error, or a warning.
std::string words_of_hidden_lines_left(HiddenMethod method);

}  // namespace displayfile
