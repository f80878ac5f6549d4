#include "interp/draw/item_buffer.h"

#include <utility>
#include <vector>

#include "displayfile/segments/hidden_surface_check.h"
#include "displayfile/segments/sorted_display_file.h"
#include "interp/visibility/image_space.h"

namespace displayfile {

ItemBufferIs item_buffer_of(const GraphicsSystem& system, const PicturePlan& plan) {
  const HiddenMethod method = surfaces_of(plan.method);
  if (finds_lines(method)) {
    return sorts_together(system, plan.options.surfaces, plan.surfaces, method)
               ? ItemBufferIs::truth
               : ItemBufferIs::layers;
  }
  const bool is_exact = plan.surfaces.precision.exact && plan.is_on_first_device();
  if (is_image_space(method)) {
    return is_exact && decides_exactly(method) ? ItemBufferIs::truth : ItemBufferIs::drawn;
  }
  if (!is_object_space(method)) return ItemBufferIs::layers;
  if (!sorts_together(system, plan.options.surfaces, plan.surfaces, method)) {
    return ItemBufferIs::layers;
  }
  return is_exact ? ItemBufferIs::truth : ItemBufferIs::drawn;
}

DrawnLayers layers_of(const DisplayFile& drawn, const ViewedScene& scene, HiddenMethod method) {
  std::vector<DrawnLayers::Layer> layers;
  for (const auto& [name, first] : scene.segments()) {
    layers.push_back({first, drawn.segment(name).sorted() != nullptr});
  }
  return {std::move(layers), !finds_lines(method)};
}

DrawOptions row_of_pixel(const DrawOptions& options, const Picker::Pixel& at) {
  DrawOptions row = options;
  const int from_top = options.height - 1 - at.row;
  row.rows = PictureRows{from_top, from_top + 1};
  row.samples = 1;
  row.pens.reset();
  row.ids.clear();
  row.depth.clear();
  row.with_ids = row.with_depth = true;
  row.warn = {};
  return row;
}

}  // namespace displayfile
