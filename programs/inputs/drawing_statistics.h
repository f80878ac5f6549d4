#pragma once

#include <string>

#include "displayfile/segments/display_file.h"
#include "interp/draw/draw.h"

namespace displayfile {

/// `displayfile draw --stats`: what was drawn, and what finding hidden surfaces cost. `drawn` is
/// the system's display file in the order that was drawn.
std::string drawing_statistics(const GraphicsSystem& system, const DisplayFile& drawn,
                               const DrawOptions& options, PictureKind kind);

/// `displayfile draw --explain`: the method that draws the picture, and why.
std::string explanation_of_method(const GraphicsSystem& system, const DrawOptions& options,
                                  PictureKind kind);

}  // namespace displayfile
