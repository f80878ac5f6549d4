#include "interp/raster/fill_paints.h"

namespace displayfile {

FillPaints::FillPaints(const ViewedScene& scene, std::uint32_t background) {
  pixel_.reserve(scene.end());
  pixel_.push_back(background);
  for (Fill fill = 1; fill < scene.end(); ++fill) {
    const ViewedScene::Item item = scene.item_of(fill);
    pixel_.push_back(pixel_of(scene.fill_colour(item)));
    const auto intensities = scene.intensities(item);
    if (intensities.empty()) continue;
    shade_.resize(fill, kNone);
    shade_.push_back(static_cast<std::uint32_t>(shades_.size()));
    shades_.push_back({scene.fill_colour(item), IntensityPlane(scene.points(item), intensities)});
  }
}

}  // namespace displayfile
