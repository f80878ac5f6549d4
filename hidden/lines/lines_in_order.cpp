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
  std::vector<IntersectionLine> intersections;
  if (options.intersections) intersections = intersection_lines(items, options.threads);
  const SeenLines seen = visible_lines(
      items, drawn_lines(items), method,
      {.precision = options.precision, .threads = options.threads, .progress = options.progress},
      intersections);
  return lines_in_order(items, seen, intersections);
}

SortedPieces lines_in_order(const Primitives& items, const SeenLines& seen,
                            std::span<const IntersectionLine> intersections) {
  SortedPieces pieces;
  pieces.are_lines = true;
  const std::size_t all = seen.pieces.size() + seen.intersections.size();
  pieces.pieces.reserve(all);
  pieces.points.reserve(2 * all);
  const auto add = [&](std::uint32_t item, const Ends& ends, double from, double to) {
    pieces.pieces.push_back({item, static_cast<std::uint32_t>(pieces.points.size()), 2});
    pieces.points.push_back(on_line(ends, from));
    pieces.points.push_back(on_line(ends, to));
  };
  auto next = seen.intersections.begin();
  const auto add_intersections_before = [&](std::size_t item) {
    for (; next != seen.intersections.end(); ++next) {
      const IntersectionLine& line = intersections[next->line];
      if (line.item_b >= item) return;
      add(line.item_b, {line.start, line.end}, next->from, next->to);
    }
  };
  for (const VisiblePiece& piece : seen.pieces) {
    add_intersections_before(piece.item);
    add(piece.item, ends_of(items, piece), piece.from, piece.to);
  }
  add_intersections_before(items.items.size());
  pieces.visible.assign(pieces.points.size(), 1);
  return pieces;
}

}  // namespace displayfile
