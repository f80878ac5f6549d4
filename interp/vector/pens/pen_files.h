#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

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
/// The same as PDF, whose page is the sheet: a layer for each pen, with the same names, if QPDF is
/// there (pdf_layers.h); otherwise pen after pen. Also throws Error without Cairo.
void write_pens_pdf(const PenDrawing& drawing, const Destination& to,
                    const VectorOptions& options = {});

/// The same as DXF, in millimetres: a layer for each pen, with the same names, its colour, and the
/// nearest width that the format has; a path is a polyline, a line or a point. The colour black is
/// black or white, as the reader's ground needs. Also throws Error without dxflib.
void write_pens_dxf(const PenDrawing& drawing, const Destination& to,
                    const VectorOptions& options = {});

/// The name of the layer of a pen, the first of which is number 1: "1 #ff0000 0.5 mm".
std::string name_of_layer(std::size_t number, const PenLayer& layer);
/// The colour of a layer's pen: "#ff0000".
std::string colour_of_layer(const PenLayer& layer);
/// Units of the sheet in millimetres, in the shortest form: exact.
std::string in_millimetres(std::int64_t units);

}  // namespace displayfile
