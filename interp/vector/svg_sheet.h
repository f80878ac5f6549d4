#pragma once

#include <ostream>
#include <string_view>

#include "interp/device/picture.h"

namespace displayfile {

/// Writes an SVG document, whose size is in pixels, on a sheet: a document in millimetres, which
/// contains the other unchanged, clipped to its frame.
void write_on_sheet(std::string_view document, const PaperFit& sheet, std::ostream& out);

}  // namespace displayfile
