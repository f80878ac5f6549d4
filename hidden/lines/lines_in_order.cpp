#include "hidden/lines/lines_in_order.h"

#include "hidden/lines/visible_lines.h"

namespace displayfile {

namespace {

struct Ends {
  Point3 from, to;
};
Ends ends_of(const Primitives& items, const VisiblePiece& piece) {
  const PointRow points = items.points_of(items.items[piece.item]);
  const std::uint32_t before =
      piece.corner == 0 ? static_cast<std::uint32_t>(points.size()) - 1 : piece.corner - 1;
  return {points[before], points[piece.corner]};
}

/// At that share of the way.
Point3 on_line(const Ends& ends, double share) {
  if (share == 0.0) return ends.from;
  return share == 1.0 ? ends.to : ends.from + share * (ends.to - ends.from);
}

}  // namespace

SortedPieces lines_in_order(const Primitives& items, std::span<const std::int32_t> picks,
                            HiddenMethod method, const SortOptions& options) {
  const std::vector<LineToDraw> lines = lines_to_draw(items, picks);
  std::vector<LineName> names;
  names.reserve(lines.size());
  for (const LineToDraw& line : lines) names.push_back(line.name);
  const SeenLines seen = visible_lines(
      items, names, method, {.precision = options.precision, .threads = options.threads});
  SortedPieces pieces;
  pieces.are_lines = true;
  pieces.pieces.reserve(seen.pieces.size());
  pieces.points.reserve(2 * seen.pieces.size());
  pieces.visible.reserve(2 * seen.pieces.size());
  pieces.pick_items.reserve(seen.pieces.size());
  auto line = lines.begin();  // both are in order of names
  for (const VisiblePiece& piece : seen.pieces) {
    while (line->name != LineName{piece.item, piece.corner}) ++line;
    const Ends ends = ends_of(items, piece);
    pieces.pieces.push_back({piece.item, static_cast<std::uint32_t>(pieces.points.size()), 2});
    pieces.points.push_back(on_line(ends, piece.from));
    pieces.points.push_back(on_line(ends, piece.to));
    pieces.visible.insert(pieces.visible.end(), {LineKinds{0}, line->kinds});
    pieces.pick_items.push_back(line->pick_item);
  }
  return pieces;
}

}  // namespace displayfile
