#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "clip/point.h"
#include "clip/surfaces.h"
#include "hidden/primitives.h"

namespace displayfile {

/// A polygon or line in the order, or a piece of one that was cut.
struct SortedPiece {
  static constexpr std::uint32_t kWhole = 0xffffffffu;
  std::uint32_t item;   ///< index of its item
  std::uint32_t first;  ///< of the piece's points in SortedPieces; kWhole if it was not cut
  std::uint32_t sides;
};

/// All items of a scene in back-to-front order: each solid polygon follows those that it hides. Of
/// coplanar polygons the one entered later follows; a line in a polygon's plane follows the
/// polygon.
struct SortedPieces {
  std::vector<SortedPiece> pieces;
  /// Pieces from this one on are parts of lines and of polygons' sides, with two points each
  /// (hidden/lines/lines_in_order.h): they follow all fills, or are all, if it is the first.
  static constexpr std::size_t kNoStrokes = std::numeric_limits<std::size_t>::max();
  std::size_t first_stroke = kNoStrokes;
  /// For each piece 1 if it is a hidden part of a line, to be drawn dashed. Empty: none.
  std::vector<std::uint8_t> hidden;
  /// For each piece, whether it is entirely lit or entirely in shadow. Empty: not computed.
  enum class Lit : std::uint8_t {
    unknown,  ///< not computed, or it shows no shadows
    lit,
    in_shadow,
  };
  std::vector<Lit> lights;
  Lit light(std::size_t k) const { return k < lights.size() ? lights[k] : Lit::unknown; }
  /// The points of cut pieces: coordinates, each rounded once, and the line kinds of the side that
  /// ends at the point, as Primitives::visible (0 for sides made by cuts). The first point of a
  /// stroke, which ends no side, has the byte of its cuts.
  std::vector<Point3> points;
  std::vector<std::uint8_t> visible;
  /// If the sort names sides: the corner of the item, from 0, at which the original side ends;
  /// kNoCorner for sides made by cuts.
  std::vector<std::uint32_t> corners;
  static constexpr std::uint32_t kNoCorner = 0xffffffffu;

  /// True if the piece is of a line of intersection; it has two points and only its style from the
  /// item.
  bool is_intersection(const SortedPiece& piece) const {
    return piece.sides == 2 && piece.first != SortedPiece::kWhole &&
           visible[piece.first + 1] == kinds_of(LineKind::intersection);
  }
  bool is_hidden(std::size_t k) const { return !hidden.empty() && hidden[k] != 0; }
  /// True for a piece drawn as a line between its points, whatever its item.
  bool is_stroke(std::size_t k) const {
    return k >= first_stroke || is_hidden(k) || is_intersection(pieces[k]);
  }
  /// The ends at which a stroke is cut.
  LineCuts stroke_cuts(const SortedPiece& stroke) const {
    return LineCuts::of(visible[stroke.first]);
  }

  /// The items whose pick identifiers apply to pieces of lines, indexed by their first point / 2:
  /// one of those that share the side. Empty: their own.
  std::vector<std::uint32_t> pick_items;
  std::uint32_t pick_item(const SortedPiece& piece) const {
    return pick_items.empty() ? piece.item : pick_items[piece.first / 2];
  }

  std::uint64_t comparisons = 0;  ///< of a polygon with a plane or polygon
  std::uint64_t cuts = 0;         ///< one piece in two
  std::uint32_t depth = 0;        ///< maximum depth of a tree; 0: none
};

/// Sorts by `bsp`, `plain_bsp` or `depth_sort` (hidden/sort/bsp.md, hidden/sort/depth_sort.md).
/// Polygons that are edge-on or have fewer than three distinct points hide nothing; they keep their
/// outlines. Throws Error for another method, and beyond the plan's limit of pieces.
SortedPieces sort_hidden_surfaces(const Primitives& items, const SurfacePlan& plan);

/// The limit of pieces for sorting this many items: that of the plan and the budget in force, or of
/// the budget alone if the plan has the default; never below the number without cuts.
std::size_t most_pieces_of_sort(const SurfacePlan& plan, std::size_t items);

/// Depth sort (the lecture's, with the problem book's priority tests) at the precision of the plan:
/// a drawing order over the pairs that overlap in the projection, with cuts only where polygons
/// intersect or overlap in a cycle (hidden/sort/depth_sort.md).
SortedPieces sort_by_depth(const Primitives& items, const SurfacePlan& plan);

}  // namespace displayfile
