#include "interp/visibility/auto_method.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace displayfile {

namespace {

using Fill = ViewedScene::Fill;

/// True if there are lines, and fills that hide but are invisible themselves.
bool shows_lines_alone(const ViewedScene& scene, const Background& background) {
  if (background.kind == Background::Kind::none || scene.end() == 1) return false;
  const auto of_background = [&](Fill fill) {
    const FillStyle style = scene.fill_style(scene.item_of(fill));
    return style.colour == background.colour && !style.shadow &&
           scene.shading(scene.item_of(fill)).empty();
  };
  for (Fill fill = 1; fill < scene.end(); ++fill) {
    if (!of_background(fill)) return false;
  }
  const std::vector<std::uint8_t> drawn = scene.drawn_sides();
  return scene.has_lines() || std::ranges::find(drawn, std::uint8_t{1}) != drawn.end();
}

MethodChoice choose_for_vectors(const ViewedScene& scene,
                                const std::optional<Background>& background) {
  if (background && scene.texts().empty() && shows_lines_alone(scene, *background)) {
    return {HiddenMethod::franklin,
            "vectors whose fills have the background's colour: visible lines only"};
  }
  if (scene.end() == 1) return {HiddenMethod::none, "no fills: nothing hides"};
  return {HiddenMethod::map, "vectors: the map of visible surfaces, without seams"};
}

}  // namespace

MethodChoice choose_method(const DisplayFile& display_file, PictureKind kind,
                           const std::optional<Background>& background) {
  if (kind == PictureKind::raster) {
    return {kMethodForPixels,
            "one picture in pixels: the z-buffer decides each pixel exactly and sorts nothing"};
  }
  return choose_for_vectors(ViewedScene(display_file), background);
}

}  // namespace displayfile
