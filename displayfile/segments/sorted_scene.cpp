#include "displayfile/segments/sorted_scene.h"

#include <algorithm>

#include "displayfile/segments/drawn_strokes.h"

namespace displayfile {

std::span<const StrokePart> OrderedScene::strokes_of_picture() const {
  std::call_once(of_picture->are_found, [&] {
    of_picture->parts = drawn_strokes(*scene, pieces);
    if (plan.line_order == LineOrder::depth) put_by_depth(*scene, pieces, plan, of_picture->parts);
  });
  return of_picture->parts;
}

bool SortedScene::has_shadows() const {
  return std::ranges::any_of(parts, [](const auto& part) { return part->scene->has_shadows(); });
}

std::size_t SortedScene::bytes() const {
  const auto size = [](const auto& array) { return array.size() * sizeof(array[0]); };
  std::size_t n = 0;
  for (const auto& part : parts) {
    const SortedPieces& pieces = part->pieces;
    n += part->scene->bytes() + size(pieces.pieces) + size(pieces.points) + size(pieces.visible) +
         size(pieces.hidden) + size(pieces.lights);
  }
  return n;
}

}  // namespace displayfile
