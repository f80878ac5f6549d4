#include "interp/raster/fill_paints.h"

#include "interp/raster/pixel_shade.h"

namespace displayfile {

void FillPaints::take(const ViewedScene& scene) {
  pixel_.resize(1);
  pixel_.reserve(scene.end());
  shade_.clear();
  shades_.clear();
  const auto runs = scene.fill_colours();
  auto run = runs.begin();  // that the fill is in: fills come in the order of the runs
  Colour colour(0.0);
  std::uint32_t pixel = 0;
  const auto take_colour = [&](ViewedScene::Item item) {
    colour = painted_colour(scene.fill_style(item));
    pixel = pixel_of(colour);
  };
  if (scene.end() > 1) take_colour(scene.item_of(1));
  for (Fill fill = 1; fill < scene.end(); ++fill) {
    const ViewedScene::Item item = scene.item_of(fill);
    const auto before = run;
    while (run + 1 != runs.end() && (run + 1)->first <= item) ++run;
    if (run != before) take_colour(item);
    pixel_.push_back(pixel);
    const auto intensities = scene.intensities(item);
    if (intensities.empty()) continue;
    shade_.resize(fill, kNone);
    shade_.push_back(static_cast<std::uint32_t>(shades_.size()));
    shades_.push_back({colour, IntensityPlane(scene.points(item), intensities)});
  }
}

}  // namespace displayfile
