#include "interp/visibility/auto_method.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "clip/rectangle.h"
#include "interp/scan/sort_stably.h"

namespace displayfile {

namespace {

using Fill = ViewedScene::Fill;

/// The minimax test of every pair, by a sweep from left to right. Boxes that only touch are apart:
/// of two polygons on either side of a line exactly one covers a centre on it.
bool boxes_are_apart(const ViewedScene& scene) {
  std::vector<Rectangle> boxes;
  for (Fill fill = 1; fill < scene.end(); ++fill)
    boxes.push_back(bounding_rectangle(scene.vertices(fill)));
  sort_stably(boxes, &Rectangle::x_min);
  std::size_t tests_left = 8 * boxes.size();
  std::vector<Rectangle> open;  // those that the sweep line crosses
  for (const Rectangle& box : boxes) {
    std::erase_if(open, [&](const Rectangle& other) { return other.x_max <= box.x_min; });
    if (open.size() > tests_left) return false;
    tests_left -= open.size();
    for (const Rectangle& other : open) {
      if (other.y_min < box.y_max && box.y_min < other.y_max) return false;
    }
    open.push_back(box);
  }
  return true;
}

/// True if no vertex lies before the plane of any fill, as in a single convex object without its
/// back faces: where two fills overlap their planes meet, and of equal depths the later is seen.
bool nothing_lies_in_front(const ViewedScene& scene) {
  constexpr std::size_t kMostVertices = 256;
  if (scene.all_points() > kMostVertices) return false;
  for (Fill fill = 1; fill < scene.end(); ++fill) {
    const Plane plane = scene.plane(fill);
    const int toward_viewer = facing(plane);
    for (Fill other = 1; other < scene.end(); ++other) {
      for (const Point3& v : scene.vertices(other)) {
        const int side = side_of_plane(v, plane) * toward_viewer;
        // A vertex off its own plane counts as moved on to it: no longer where it was tested.
        if (side > 0 || (other == fill && side != 0)) return false;
      }
    }
  }
  return true;
}

/// True if there are lines, and fills that hide but are not seen themselves.
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
            "vectors whose fills have the background's colour: the lines that are seen, and "
            "nothing else"};
  }
  if (scene.has_lines()) {
    return {HiddenMethod::depth_sort,
            "vectors with lines: depth sort cuts least and hides lines behind polygons"};
  }
  if (!scene.texts().empty()) {
    return {HiddenMethod::depth_sort, "vectors with texts, which polygons may hide: depth sort"};
  }
  if (nothing_hides(scene)) {
    return {HiddenMethod::none, "no polygon can hide another: any order is right"};
  }
  return {HiddenMethod::depth_sort, "vectors: depth sort orders the polygons with the fewest cuts"};
}

}  // namespace

bool nothing_hides(const ViewedScene& scene) {
  return scene.end() <= 2 || boxes_are_apart(scene) || nothing_lies_in_front(scene);
}

MethodChoice choose_method(const DisplayFile& display_file, PictureKind kind,
                           const std::optional<Background>& background) {
  if (kind == PictureKind::raster) {
    return {kMethodForPixels,
            "one picture in pixels: the z-buffer decides each pixel exactly and sorts nothing"};
  }
  return choose_for_vectors(ViewedScene(display_file), background);
}

}  // namespace displayfile
