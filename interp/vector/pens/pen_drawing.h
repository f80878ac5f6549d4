#pragma once

#include <string>
#include <vector>

#include "displayfile/looks/style.h"
#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"
#include "interp/vector/pens/pen_device.h"
#include "interp/vector/pens/stroke_chains.h"

namespace displayfile {

/// The paths that one pen draws, in order.
struct PenLayer {
  Pen pen;
  std::vector<PenPath> paths;
};

/// A picture for pens, on its sheet.
struct PenDrawing {
  PaperFit fit;
  std::vector<PenLayer> layers;  ///< at least one path each
};

/// The visible segments' strokes in the order of the display file, unprocessed. Throws Error as
/// require_pens and fit_on_paper do.
std::vector<PenStrokes> pen_strokes(const DisplayFile& display_file, int width, int height,
                                    const Paper& paper, const Pens& pens,
                                    const Background& background = {});
/// The same as paths in drawing order.
PenDrawing pen_drawing(const DisplayFile& display_file, int width, int height, const Paper& paper,
                       const Pens& pens, const Background& background = {});
/// The colours of Pens::layers that no layer of the drawing has, as #rrggbb.
std::vector<std::string> layers_without_pen(const PenDrawing& drawing, const Pens& pens);
/// True if pens draw anything: then pen_drawing returns a layer. Errors as above.
bool has_pen_strokes(const DisplayFile& display_file, int width, int height, const Paper& paper,
                     const Pens& pens, const Background& background = {});

}  // namespace displayfile
