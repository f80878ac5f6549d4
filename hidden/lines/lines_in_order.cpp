#include "hidden/lines/lines_in_order.h"

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

SortedPieces lines_in_order(const Primitives& items, HiddenMethod method,
                            const SortOptions& options) {
  return lines_in_order(items, visible_lines(items, drawn_lines(items), method,
                                             {.precision = options.precision,
                                              .threads = options.threads,
                                              .progress = options.progress}));
}

SortedPieces lines_in_order(const Primitives& items, const SeenLines& seen) {
  SortedPieces pieces;
  pieces.are_lines = true;
  pieces.pieces.reserve(seen.pieces.size());
  pieces.points.reserve(2 * seen.pieces.size());
  for (const VisiblePiece& piece : seen.pieces) {
    const Ends ends = ends_of(items, piece);
    pieces.pieces.push_back({piece.item, static_cast<std::uint32_t>(pieces.points.size()), 2});
    pieces.points.push_back(on_line(ends, piece.from));
    pieces.points.push_back(on_line(ends, piece.to));
  }
  pieces.visible.assign(pieces.points.size(), 1);
  return pieces;
}

}  // namespace displayfile
