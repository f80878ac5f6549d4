#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/base/work_progress.h"
#include "clip/surface_plan.h"
#include "hidden/lines/intersection_lines.h"
#include "hidden/primitives.h"

namespace displayfile {

/// A line of the items: of a polygon the side that ends at its corner of that number, counted from
/// 0, and starts at the corner before it, cyclically; of a Kind::line the line itself, from its
/// point 0 to its point 1, and the corner is 1.
struct LineName {
  std::uint32_t item, corner;
  auto operator<=>(const LineName&) const = default;
};

/// A part of a line that is seen: from and to are shares of the projected line's length,
/// 0 <= from < to <= 1.
struct VisiblePiece {
  std::uint32_t item, corner;
  double from, to;
  bool operator==(const VisiblePiece&) const = default;
};

/// The same of an intersection line, by its place among those that were given.
struct VisibleIntersection {
  std::uint32_t line;
  double from, to;
  bool operator==(const VisibleIntersection&) const = default;
};

/// What is seen of lines; what is left of each is hidden.
struct SeenLines {
  std::vector<VisiblePiece> pieces;  ///< by item, corner, from; pieces of a line do not touch
  std::vector<VisibleIntersection> intersections;  ///< by line, from; likewise
};

class GridSurface;

/// The lines that are drawn: all lines, and the sides of polygons that are visible, in order of
/// items and corners. A side that polygons share is there once, as the first of those that are
/// drawn. What projects to a point is left out.
std::vector<LineName> drawn_lines(const Primitives& items);

/// One of these lines, and what it is as the polygons share it.
struct LineToDraw {
  LineName name;
  LineKinds kinds;          ///< those that the side is drawn as in one of the polygons or more
  std::uint32_t pick_item;  ///< the item of the lowest pick identifier
};
/// The same list; `picks` are the pick identifiers of the items, and `surface` what they are if
/// they are one (GridSurface::of).
std::vector<LineToDraw> lines_to_draw(const Primitives& items, std::span<const std::int32_t> picks,
                                      const GridSurface* surface);
std::vector<LineToDraw> lines_to_draw(const Primitives& items, std::span<const std::int32_t> picks);

/// Finds what is seen of the lines named, in device coordinates (hidden/lines/README.md has the
/// definition). A line named twice counts once; a line that projects to a point has no pieces. With
/// exact precision each end of a piece is the true one, rounded once to the nearest double, so that
/// all methods give the same pieces. Throws Error for a line that there is not, or a method that
/// finds no lines: expected are roberts, appel, franklin, plain_appel and, for a surface,
/// perimeter. `surface` is what the items are, if that is known.
///
/// Intersections are those that intersection_lines found among the same items, or some of them.
/// Exact precision takes each as the line that both planes have in common, between its ends as
/// they are defined, and not as the line between the rounded ones.
SeenLines visible_lines(const Primitives& items, std::span<const LineName> lines,
                        const SurfacePlan& plan,
                        std::span<const IntersectionLine> intersections = {},
                        const GridSurface* surface = nullptr);

}  // namespace displayfile
