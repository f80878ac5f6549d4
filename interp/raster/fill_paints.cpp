#include "interp/raster/fill_paints.h"

#include "interp/raster/pixel_shade.h"

namespace displayfile {

void FillPaints::take(const ViewedScene& scene) {
  pixel_.resize(1);
  pixel_.reserve(scene.most_fills() + 1);
  shade_.clear();
  shades_.clear();
  const auto runs = scene.fill_colours();
  std::size_t next = 0;  // of the runs: fills come in their order
  Colour colour(0.0);
  std::uint32_t pixel = 0;
  for (Fill fill = 1; fill < scene.end(); ++fill) {
    const ViewedScene::Item item = scene.item_of(fill);
    if (next < runs.size() && runs[next].first <= item) {
      while (next < runs.size() && runs[next].first <= item) ++next;
      colour = painted_colour({FillStyle::Kind::solid, scene.colour(runs[next - 1].style)});
      pixel = pixel_of(colour);
    }
    pixel_.push_back(pixel);
    const auto intensities = scene.intensities(item);
    if (intensities.empty()) continue;
    shade_.resize(fill, kNone);
    shade_.push_back(static_cast<std::uint32_t>(shades_.size()));
    shades_.push_back({colour, IntensityPlane(scene.points(item), intensities)});
  }
}

}  // namespace displayfile
