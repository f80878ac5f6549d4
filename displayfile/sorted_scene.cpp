#include "displayfile/sorted_scene.h"

namespace displayfile {

namespace {

std::size_t count(const SortedScene& sorted, bool lines) {
  std::size_t n = 0;
  for (const auto& part : sorted.parts) {
    if (part->pieces.are_lines) {
      n += lines ? part->pieces.pieces.size() : 0;
      continue;
    }
    for (const SortedPiece& piece : part->pieces.pieces) {
      n += (part->scene->kind(piece.item) == Primitives::Kind::line) == lines ? 1 : 0;
    }
  }
  return n;
}

}  // namespace

std::size_t SortedScene::polygons() const { return count(*this, false); }
std::size_t SortedScene::lines() const { return count(*this, true); }

std::size_t SortedScene::bytes() const {
  const auto size = [](const auto& array) { return array.size() * sizeof(array[0]); };
  std::size_t n = 0;
  for (const auto& part : parts) {
    const SortedPieces& pieces = part->pieces;
    n += part->scene->bytes() + size(pieces.pieces) + size(pieces.points) + size(pieces.visible);
  }
  return n;
}

}  // namespace displayfile
