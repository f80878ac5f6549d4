#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "clip/point.h"
#include "clip/surface_plan.h"
#include "hidden/primitives.h"

namespace displayfile {

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
  std::vector<SortedPiece> pieces;
  /// From this piece on they are parts of lines and of polygons' sides, of two points each
  /// (hidden/lines/lines_in_order.h): after all fills, or if it is the first, all that is drawn.
  static constexpr std::size_t kNoStrokes = std::numeric_limits<std::size_t>::max();
  std::size_t first_stroke = kNoStrokes;
  /// For each piece 1 if it is one of a line, of two points, that is hidden there: to be drawn
  /// dashed. Empty: none is.
  std::vector<std::uint8_t> hidden;
  /// For each piece whether the light reaches it, wholly or nowhere. Empty: nobody asked.
  enum class Lit : std::uint8_t {
    unknown,  ///< nobody asked of this one, or it shows no shadows
    lit,
    in_shadow,
  };
  std::vector<Lit> lights;
  Lit light(std::size_t k) const { return k < lights.size() ? lights[k] : Lit::unknown; }
  /// The points of the pieces that were cut: coordinates, each rounded once, and whether the side
  /// that ends at the point is drawn and as what, as Primitives::visible (the sides that cuts made
  /// are not). Of a stroke, whose first point ends no side, that point has the byte of its cuts.
  std::vector<Point3> points;
  std::vector<std::uint8_t> visible;
  /// Where the sort was asked to name sides: the corner of the item, from 0, at which the side ends
  /// that this one is or is a part of; kNoCorner of the sides that cuts made.
  std::vector<std::uint32_t> corners;
  static constexpr std::uint32_t kNoCorner = 0xffffffffu;

  /// True if the piece is of a line where polygons pass through each other; such a piece has two
  /// points, and is no more of the item than its style.
  bool is_intersection(const SortedPiece& piece) const {
    return piece.sides == 2 && piece.first != SortedPiece::kWhole &&
           visible[piece.first + 1] == kinds_of(LineKind::intersection);
  }
  bool is_hidden(std::size_t k) const { return !hidden.empty() && hidden[k] != 0; }
  /// True of a piece that is drawn as a line from one of its points to the other, whatever the item
  /// is.
  bool is_stroke(std::size_t k) const {
    return k >= first_stroke || is_hidden(k) || is_intersection(pieces[k]);
  }
  /// At which ends a stroke is cut.
  LineCuts stroke_cuts(const SortedPiece& stroke) const {
    return LineCuts::of(visible[stroke.first]);
  }

  /// The items whose pick identifiers pieces of lines have, by their first points over 2: one of
  /// those that share the side. Empty: their own.
  std::vector<std::uint32_t> pick_items;
  std::uint32_t pick_item(const SortedPiece& piece) const {
    return pick_items.empty() ? piece.item : pick_items[piece.first / 2];
  }

  std::uint64_t comparisons = 0;  ///< of a polygon with a plane or another polygon
  std::uint64_t cuts = 0;         ///< one piece in two
  std::uint32_t depth = 0;        ///< of the deepest tree; 0 where there is none
};

/// Sorts by `bsp`, `plain_bsp` or `depth_sort` (hidden/sort/bsp.md, hidden/sort/depth_sort.md).
/// Polygons that are edge-on or of fewer than three different points hide nothing; they keep their
/// outlines. Throws Error for another method, and where more pieces would be made than the plan
/// allows.
SortedPieces sort_hidden_surfaces(const Primitives& items, const SurfacePlan& plan);

/// How many pieces the sort of so many items may have: what the plan and the budget in force
/// allow, the budget alone where the plan has the usual number; but always what is not cut.
std::size_t most_pieces_of_sort(const SurfacePlan& plan, std::size_t items);

}  // namespace displayfile
