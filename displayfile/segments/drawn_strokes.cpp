#include "displayfile/segments/drawn_strokes.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "displayfile/segments/scene_lines.h"
#include "displayfile/segments/sorted_scene.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/lines/line_ends.h"
#include "hidden/lines/strokes_by_depth.h"

namespace displayfile {

namespace {

bool is_line(const ViewedScene& scene, ViewedScene::Item item) {
  return scene.kind(item) == Primitives::Kind::line;
}

}  // namespace

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
                       is_line(scene, piece.item) && !pieces.stroke_cuts(piece).any(),
                       pieces.is_hidden(k)});
  }
  return strokes_once(strokes, lines_apart(scene.touching_of_ends()));
}

void put_by_depth(const ViewedScene& scene, const SortedPieces& pieces, const SurfacePlan& plan,
                  std::vector<StrokePart>& parts) {
  const std::size_t first = std::min(pieces.first_stroke, pieces.pieces.size());
  const std::vector<std::uint32_t> looks = looks_of_lines(scene);
  const auto end_of_hidden = std::stable_partition(
      parts.begin(), parts.end(),
      [&](const StrokePart& part) { return pieces.is_hidden(first + part.stroke); });
  const auto hidden = static_cast<std::size_t>(end_of_hidden - parts.begin());
  const auto seen = std::span<const StrokePart>(parts).subspan(hidden);
  std::vector<DeepStroke> strokes;
  strokes.reserve(seen.size());
  for (const StrokePart& part : seen) {
    const SortedPiece& piece = pieces.pieces[first + part.stroke];
    const Point3 &from = pieces.points[piece.first], &to = pieces.points[piece.first + 1];
    const LineKinds kinds = pieces.visible[piece.first + 1];
    const bool kinds_differ = !scene.line_style(piece.item).of_kinds.empty();
    const std::uint32_t look = looks.empty() ? 0 : looks[piece.item];
    strokes.push_back({StrokePart::at(from, to, part.from), StrokePart::at(from, to, part.to),
                       style_of_stroke(scene, piece.item, kinds).width,
                       256 * look + (kinds_differ ? kinds : 0u), piece.item});
  }
  const StrokePicture picture{Point2(plan.width, plan.height),
                              lines_apart(scene.touching_of_ends())};
  std::vector<StrokePart> all(parts.begin(), end_of_hidden);
  all.reserve(parts.size());
  for (const PartByDepth& of : strokes_by_depth(strokes, picture, plan.line_halo, plan.threads)) {
    StrokePart part = seen[of.stroke];
    const double length = part.to - part.from;
    if (of.to != 1.0) part.to = part.from + of.to * length;
    if (of.from != 0.0) part.from += of.from * length;
    part.cuts = of.cuts;
    part.is_alone = part.is_alone || of.is_between_gaps;
    all.push_back(part);
  }
  parts = std::move(all);
}

std::vector<VisiblePiece> pieces_of_picture(const ViewedScene& scene, const FoundLines& found,
                                            const Point2& pixels) {
  const std::vector<VisiblePiece>& seen = found.seen.pieces;
  const std::vector<std::uint32_t> looks = looks_of_lines(scene);
  const Primitives items = scene.primitives();
  std::vector<StrokeOfPicture> strokes;
  strokes.reserve(seen.size() + found.seen.intersections.size());
  for (const VisiblePiece& piece : seen) {
    const LineEnds ends(items, {piece.item, piece.corner});
    strokes.push_back({{Point2(ends.at(piece.from)), Point2(ends.at(piece.to))},
                       0,
                       looks.empty() ? 0 : looks[piece.item],
                       is_line(scene, piece.item) && piece.from == 0.0 && piece.to == 1.0});
  }
  // Lines at which others may end, but which are not examined themselves.
  const auto own = static_cast<std::uint32_t>(strokes.size());
  const std::uint32_t no_look = scene.items();
  for (const VisibleIntersection& piece : found.seen.intersections) {
    const IntersectionLine& line = found.intersections[piece.line];
    const auto at = [&](double share) {
      return Point2(StrokePart::at(line.start, line.end, share));
    };
    strokes.push_back({{at(piece.from), at(piece.to)}, 0, no_look, true});
  }
  std::vector<VisiblePiece> drawn;
  for (const StrokePart& part : strokes_once(strokes, lines_apart(scene.touching_of_ends()))) {
    if (part.stroke >= own) break;
    VisiblePiece piece = seen[part.stroke];
    const double length = piece.to - piece.from;
    if (part.to != 1.0) piece.to = piece.from + part.to * length;
    if (part.from != 0.0) piece.from += part.from * length;
    const LineEnds ends(items, {piece.item, piece.corner});
    const Point2 from(ends.at(piece.from)), to(ends.at(piece.to));
    const LineKinds kinds = scene.side_kinds(piece.item, piece.corner);
    const double width = style_of_stroke(scene, piece.item, kinds).width;
    if (part.is_alone && is_shorter_than_wide(from, to, pixels, width)) continue;
    if (piece.from < piece.to) drawn.push_back(piece);
  }
  return drawn;
}

}  // namespace displayfile
