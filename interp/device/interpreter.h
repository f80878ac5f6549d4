#pragma once

#include <cstddef>

#include "displayfile/looks/style.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/viewed_scene.h"
#include "interp/device/output_device.h"

namespace displayfile {

/// A style with its width and dashes multiplied by `by`.
LineStyle scaled(LineStyle style, double by);

/// Calls visit(item, style) for the items of a scene that draw lines, in order of entry, with the
/// line style of each, which is not scaled.
template <class Visit>
void for_each_outlined(const ViewedScene& scene, Visit&& visit) {
  const auto runs = scene.line_styles();
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const LineStyle& style = runs[k].style;
    if (style.kind == LineStyle::Kind::none) continue;
    const ViewedScene::Item end = k + 1 < runs.size() ? runs[k + 1].first : scene.items();
    for (ViewedScene::Item item = runs[k].first; item < end; ++item) visit(item, style);
  }
}

/// Passes the lines and the drawn sides of a scene's polygons to the device, in order of entry, as
/// interpret does with Pass::lines.
void interpret_lines(const ViewedScene& scene, OutputDevice& device, double line_scale = 1.0);

}  // namespace displayfile
