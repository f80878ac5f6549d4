#include "interp/raster/fill_paints.h"

namespace displayfile {

FillPaints::FillPaints(const ViewedScene& scene, std::uint32_t background) {
  pixel_.reserve(scene.end());
  pixel_.push_back(background);
  const auto colours = scene.fill_colours();
  auto colour = colours.begin();  // of the fill: fills come in the order of the runs
  std::uint32_t pixel = colours.empty() ? background : pixel_of(colour->style);
  for (Fill fill = 1; fill < scene.end(); ++fill) {
    const ViewedScene::Item item = scene.item_of(fill);
    for (; colour + 1 != colours.end() && (colour + 1)->first <= item; ++colour) {
      pixel = pixel_of((colour + 1)->style);
    }
    pixel_.push_back(pixel);
    const auto intensities = scene.intensities(item);
    if (intensities.empty()) continue;
    shade_.resize(fill, kNone);
    shade_.push_back(static_cast<std::uint32_t>(shades_.size()));
    shades_.push_back({colour->style, IntensityPlane(scene.points(item), intensities)});
  }
}

}  // namespace displayfile
