#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "clip/point.h"
#include "hidden/exact/precision.h"
#include "hidden/hidden_lines.h"
#include "hidden/hidden_method.h"
#include "hidden/primitives.h"

namespace displayfile {

/// How the root of a (sub)tree of polygons is chosen.
enum class RootChoice {
  last,    ///< the textbook's: the polygon entered last (algorithm 9.8)
  sample,  ///< of a sample of polygons the one with the lowest cost of cuts and balance
  free,    ///< also of planes that belong to no polygon; and only among polygons that overlap
};

struct SortOptions {
  Precision precision;
  RootChoice root = RootChoice::free;
  int threads = 1;  ///< the result is the same for any number
  /// Drawn too, by who finds lines (hidden/lines/lines_in_order.h).
  HiddenLines hidden_lines = HiddenLines::none;
};

/// A polygon or line in the order, or a piece of one that was cut.
struct SortedPiece {
  static constexpr std::uint32_t kWhole = 0xffffffffu;
  std::uint32_t item;   ///< index into the items
  std::uint32_t first;  ///< of the piece's points in SortedPieces; kWhole if it was not cut
  std::uint32_t sides;
};

/// All items of a scene in back-to-front order: each solid polygon comes after those that it hides.
/// Where polygons are coplanar the one entered later comes later; where a line lies in a polygon's
/// plane, the line.
struct SortedPieces {
  /// The pieces are those of lines and of polygons' sides that are seen, of two points each, and
  /// all that is drawn (hidden/lines/lines_in_order.h).
  bool are_lines = false;
  std::vector<SortedPiece> pieces;
  /// 1 for each piece that is one of a line, of two points, that is hidden there: to be drawn
  /// dashed. Empty: none is.
  std::vector<std::uint8_t> hidden;
  /// The points of the pieces that were cut: coordinates, each rounded once, and whether the side
  /// that ends at the point is drawn (the sides that cuts made are not).
  std::vector<Point3> points;
  std::vector<std::uint8_t> visible;

  std::uint64_t comparisons = 0;  ///< of a polygon with a plane or another polygon
  std::uint64_t cuts = 0;         ///< one piece in two
  std::uint32_t depth = 0;        ///< of the deepest tree; 0 where there is none
};

/// Sorts by `bsp` or `depth_sort` (hidden/sort/bsp.md, hidden/sort/depth_sort.md). Polygons that
/// are edge-on or of fewer than three different points hide nothing; they keep their outlines.
/// Throws Error for another method.
SortedPieces sort_hidden_surfaces(const Primitives& items, HiddenMethod method,
                                  const SortOptions& options);

}  // namespace displayfile
