#include "programs/inputs/nothing_by_pens.h"

#include <fmt/format.h>

#include <ostream>

#include "interp/vector/pens/pen_drawing.h"
#include "programs/process/warnings.h"

namespace displayfile {

bool pens_draw_nothing(const DisplayFile& drawn, const DrawOptions& options) {
  if (!options.pens) return false;
  Pens pens = *options.pens;
  pens.lettering = options.lettering;
  return !has_pen_strokes(drawn, options.width, options.height,
                          options.vectors.paper.value_or(Paper{}), pens,
                          options.background.value_or(Background{}));
}

void warn_that_pens_draw_nothing(const std::string& output, const DrawOptions& options) {
  warnings() << fmt::format("{}: pens draw nothing: {}\n", output,
                            options.pens && options.pens->hatching
                                ? "no line is visible, and no fill that hatching shows"
                                : "no line is visible, and fills are drawn with --hatch only");
}

}  // namespace displayfile
