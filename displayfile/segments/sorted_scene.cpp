#include "displayfile/segments/sorted_scene.h"

#include <algorithm>

#include "displayfile/segments/drawn_strokes.h"

namespace displayfile {

namespace {

std::size_t count(const SortedScene& sorted, bool lines) {
  std::size_t n = 0;
  for (const auto& part : sorted.parts) {
    const SortedPieces& all = part->pieces;
    for (std::size_t k = 0; k < all.pieces.size(); ++k) {
      const bool is_line =
          all.is_stroke(k) || part->scene->kind(all.pieces[k].item) == Primitives::Kind::line;
      n += is_line == lines ? 1 : 0;
    }
  }
  return n;
}

}  // namespace

std::span<const StrokePart> OrderedScene::strokes_of_picture() const {
  std::call_once(of_picture->are_found, [&] {
    of_picture->parts = drawn_strokes(*scene, pieces);
    if (strokes.order == LineOrder::depth) put_by_depth(*scene, pieces, strokes, of_picture->parts);
  });
  return of_picture->parts;
}

bool SortedScene::has_shadows() const {
  return std::ranges::any_of(parts, [](const auto& part) { return part->scene->has_shadows(); });
}

std::size_t SortedScene::polygons() const { return count(*this, false); }
std::size_t SortedScene::lines() const { return count(*this, true); }

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
