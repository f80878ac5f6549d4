#include "interp/vector/pens/pen_drawing.h"

#include <algorithm>
#include <utility>

#include "interp/annotation/annotation_marks.h"
#include "interp/device/interpreter.h"
#include "interp/vector/pens/pen_annotation.h"
#include "interp/vector/pens/pen_order.h"
#include "interp/vector/pens/unique_strokes.h"

namespace displayfile {

std::vector<PenStrokes> pen_strokes(const DisplayFile& display_file, int width, int height,
                                    const Paper& paper, const Pens& pens,
                                    const Background& background) {
  require_pens(pens);
  const bool transparent = background.kind == Background::Kind::none;
  PenDevice device({width, height, fit_on_paper(paper, width, height)}, pens,
                   transparent ? Colour(1.0) : background.colour);
  interpret(display_file, device);
  const double millimetre = 1.0 / fit_on_paper(paper, width, height).pixel;
  draw_annotation(annotation_marks(display_file, {width, height, millimetre}), {width, height},
                  device);
  return device.strokes();
}

PenDrawing pen_drawing(const DisplayFile& display_file, int width, int height, const Paper& paper,
                       const Pens& pens, const Background& background) {
  PenDrawing drawing{fit_on_paper(paper, width, height), {}};
  for (PenStrokes& of_pen : pen_strokes(display_file, width, height, paper, pens, background)) {
    std::vector<PenPath> paths = stroke_chains(unique_strokes(std::move(of_pen.strokes)));
    order_for_pen(paths);
    if (!paths.empty()) drawing.layers.push_back({of_pen.pen, std::move(paths)});
  }
  return drawing;
}

/// Hatching is looked at last: it takes the longest.
bool has_pen_strokes(const DisplayFile& display_file, int width, int height, const Paper& paper,
                     const Pens& pens, const Background& background) {
  const auto has = [&](const Pens& by) {
    const auto all = pen_strokes(display_file, width, height, paper, by, background);
    return std::ranges::any_of(all,
                               [](const PenStrokes& of_pen) { return !of_pen.strokes.empty(); });
  };
  return has({.crumbs = pens.crumbs}) || (pens.hatching && has(pens));
}

}  // namespace displayfile
