#include "displayfile/segments/hidden_lines_left.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/segments/surface_plan.h"
#include "interp/draw/draw.h"
#include "interp/draw/picture_checks.h"
#include "interp/draw/picture_plan.h"

namespace displayfile {

namespace {

/// The display file in the order in which vectors are drawn.
const DisplayFile& in_order(const GraphicsSystem& system, const DrawOptions& options,
                            SortedDisplayFile& kept) {
  const HiddenMethod method = drawing_method(system, options, PictureKind::vector);
  PicturePlan picture{.options = options, .device = &first_device()};
  picture.surfaces = resolve_surfaces(system, options.surfaces);
  require_line_order_obeyed(method, picture, PictureKind::vector);
  picture.surfaces.width = options.width;
  picture.surfaces.height = options.height;
  const DisplayFile& file = kept.update(system, options.surfaces, picture.surfaces, method);
  require_hidden_lines_dumped(file, method, options.surfaces);
  return file;
}

}  // namespace

void draw(const GraphicsSystem& system, OutputDevice& device, const DrawOptions& options) {
  const BudgetInForce in_force(options.surfaces.budget);
  SortedDisplayFile kept;
  interpret(in_order(system, options, kept), device);
}

DrawnPieces drawn_pieces(const GraphicsSystem& system, const DrawOptions& options,
                         SortedDisplayFile& kept) {
  const BudgetInForce in_force(options.surfaces.budget);
  return drawn_pieces(in_order(system, options, kept));
}

DrawnPieces drawn_pieces(const GraphicsSystem& system, const DrawOptions& options) {
  SortedDisplayFile kept;
  return drawn_pieces(system, options, kept);
}

}  // namespace displayfile
