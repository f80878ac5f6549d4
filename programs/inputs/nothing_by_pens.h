#pragma once

#include <string>

#include "displayfile/segments/display_file.h"
#include "interp/draw/draw.h"

namespace displayfile {

/// True if options select a picture by pens and pens draw nothing of it. `drawn` is sorted for the
/// picture; the options have its background.
bool pens_draw_nothing(const DisplayFile& drawn, const DrawOptions& options);

/// Warns of that, with the output's name (programs/process/warnings.h).
void warn_that_pens_draw_nothing(const std::string& output, const DrawOptions& options);

}  // namespace displayfile
