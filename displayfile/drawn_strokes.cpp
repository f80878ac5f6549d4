#include "displayfile/drawn_strokes.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "displayfile/scene_lines.h"
#include "displayfile/viewed_scene.h"

namespace displayfile {

std::vector<StrokePart> drawn_strokes(const ViewedScene& scene, const SortedPieces& pieces) {
  const std::size_t first = std::min(pieces.first_stroke, pieces.pieces.size());
  const std::vector<std::uint32_t> looks = looks_of_lines(scene);
  std::vector<StrokeOfPicture> strokes;
  strokes.reserve(pieces.pieces.size() - first);
  for (std::size_t k = first; k < pieces.pieces.size(); ++k) {
    const SortedPiece& piece = pieces.pieces[k];
    const LineKinds kinds = pieces.visible[piece.first + 1];
    const std::uint32_t look = looks.empty() ? 0 : looks[piece.item];
    strokes.push_back({{Point2(pieces.points[piece.first]), Point2(pieces.points[piece.first + 1])},
                       static_cast<std::uint32_t>(std::countr_zero(kinds)),
                       2 * look + (pieces.is_hidden(k) ? 1 : 0),
                       scene.kind(piece.item) == Primitives::Kind::line,
                       pieces.is_hidden(k)});
  }
  return strokes_once(strokes, lines_apart(scene.touching_of_ends()));
}

}  // namespace displayfile
