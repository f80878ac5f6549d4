#include "interp/raster/fill_paints.h"

#include "interp/raster/pixel_shade.h"

namespace displayfile {

namespace {

Colour painted(const Colour& colour) { return painted_colour({FillStyle::Kind::solid, colour}); }

}  // namespace

/// One palette serves many scenes.
void FillPaints::take_palette(const ViewedScene& scene) {
  if (palette_ == scene.palette()) return;
  palette_ = scene.palette();
  palette_pixel_.clear();
  palette_pixel_.reserve(scene.palette_colours());
  for (std::uint32_t number = 0; number < scene.palette_colours(); ++number) {
    palette_pixel_.push_back(pixel_of(painted(scene.colour(number))));
  }
}

void FillPaints::take(const ViewedScene& scene) {
  pixel_.resize(1);
  pixel_.reserve(scene.most_fills() + 1);
  shades_.clear();
  phongs_.clear();
  take_palette(scene);
  const auto runs = scene.fill_colours();
  const bool has_shades = scene.has_shades();
  std::size_t next = 0;  // of the runs: fills come in their order
  std::uint32_t number = 0, pixel = 0;
  for (Fill fill = 1; fill < scene.end(); ++fill) {
    const ViewedScene::Item item = scene.item_of(fill);
    if (next < runs.size() && runs[next].first <= item) {
      while (next < runs.size() && runs[next].first <= item) ++next;
      number = runs[next - 1].style;
      pixel = number < palette_pixel_.size() ? palette_pixel_[number]
                                             : pixel_of(painted(scene.colour(number)));
    }
    pixel_.push_back(pixel);
    if (!has_shades) continue;
    const VertexShading shading = scene.shading(item);
    if (shading.empty()) continue;
    const Colour colour = painted(scene.colour(number));
    if (shading.normals.empty()) {
      shades_.add(fill, {colour, IntensityPlane(scene.points(item), shading.intensities)});
    } else {
      phongs_.add(fill, {colour, NormalPlane(scene.points(item), shading.normals), *shading.light});
    }
  }
}

}  // namespace displayfile
