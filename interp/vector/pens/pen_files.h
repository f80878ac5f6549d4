#pragma once

#include "displayfile/files.h"
#include "interp/device/picture.h"
#include "interp/vector/pens/pen_drawing.h"

namespace displayfile {

/// Writes a drawing for pens as SVG in millimetres, with a layer of Inkscape for each pen: a group
/// with inkscape:groupmode="layer" whose label begins with the pen's number, 1, 2, ... Each path is
/// an element, in drawing order. The file appears whole or not at all. Throws Error, naming the
/// file, if it cannot be written. Only the options for SVG's names and declaration apply.
void write_pens_svg(const PenDrawing& drawing, const Destination& to,
                    const VectorOptions& options = {});
/// The same as PDF, whose page is the sheet, pen after pen. Also throws Error without Cairo.
void write_pens_pdf(const PenDrawing& drawing, const Destination& to,
                    const VectorOptions& options = {});

}  // namespace displayfile
