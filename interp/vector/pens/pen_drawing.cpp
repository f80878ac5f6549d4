#include "interp/vector/pens/pen_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "interp/annotation/annotation_marks.h"
#include "interp/device/interpreter.h"
#include "interp/device/picture.h"
#include "interp/vector/pens/cut_order.h"
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
  device.draw_texts(display_file);
  const double millimetre = 1.0 / fit_on_paper(paper, width, height).pixel;
  draw_annotation(annotation_marks(display_file, {width, height, millimetre}), {width, height},
                  background, device);
  return device.strokes();
}

PenDrawing pen_drawing(const DisplayFile& display_file, int width, int height, const Paper& paper,
                       const Pens& pens, const Background& background) {
  PenDrawing drawing{fit_on_paper(paper, width, height), {}};
  for (PenStrokes& of_pen : pen_strokes(display_file, width, height, paper, pens, background)) {
    std::vector<PenPath> paths = stroke_chains(unique_strokes(std::move(of_pen.strokes)));
    pens.order == PenOrder::cut ? order_for_cutting(paths) : order_for_pen(paths);
    if (!paths.empty()) drawing.layers.push_back({of_pen.pen, std::move(paths)});
  }
  const auto place = [&](const PenLayer& layer) {
    const auto is_its = [&](const Colour& c) { return pixel_of(c) == layer.pen.colour; };
    return std::ranges::find_if(pens.layers, is_its) - pens.layers.begin();
  };
  std::ranges::stable_sort(drawing.layers, {}, place);
  return drawing;
}

std::vector<std::string> layers_without_pen(const PenDrawing& drawing, const Pens& pens) {
  std::vector<std::string> without;
  for (const Colour& colour : pens.layers) {
    const std::uint32_t pixel = pixel_of(colour);
    const auto has_it = [&](const PenLayer& layer) { return layer.pen.colour == pixel; };
    if (std::ranges::none_of(drawing.layers, has_it)) {
      without.push_back(fmt::format("#{:02x}{:02x}{:02x}", pixel & 0xff, (pixel >> 8) & 0xff,
                                    (pixel >> 16) & 0xff));
    }
  }
  return without;
}

/// Hatching is examined last: it takes longest.
bool has_pen_strokes(const DisplayFile& display_file, int width, int height, const Paper& paper,
                     const Pens& pens, const Background& background) {
  const auto has = [&](const Pens& by) {
    const auto all = pen_strokes(display_file, width, height, paper, by, background);
    return std::ranges::any_of(all,
                               [](const PenStrokes& of_pen) { return !of_pen.strokes.empty(); });
  };
  Pens without_hatching = pens;
  without_hatching.hatching.reset();
  return has(without_hatching) || (pens.hatching && has(pens));
}

}  // namespace displayfile
