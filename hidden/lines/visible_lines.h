#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/base/work_progress.h"
#include "clip/surfaces.h"
#include "hidden/lines/intersection_lines.h"
#include "hidden/primitives.h"

namespace displayfile {

/// A line of the items: for a polygon the side that ends at corner `corner`, counted from 0, and
/// starts at the corner before it, cyclically; for a Kind::line the line itself, from its point 0
/// to its point 1, with corner 1.
struct LineName {
  std::uint32_t item, corner;
  auto operator<=>(const LineName&) const = default;
};

/// A visible part of a line: from and to are fractions of the projected line's length, 0 <= from <
/// to <= 1.
struct VisiblePiece {
  std::uint32_t item, corner;
  double from, to;
  bool operator==(const VisiblePiece&) const = default;
};

/// The same for an intersection line, by its index in the input.
struct VisibleIntersection {
  std::uint32_t line;
  double from, to;
  bool operator==(const VisibleIntersection&) const = default;
};

/// The visible parts of lines; the rest of each is hidden.
struct SeenLines {
  std::vector<VisiblePiece> pieces;  ///< by item, corner, from; pieces of a line do not touch
  std::vector<VisibleIntersection> intersections;  ///< by line, from; likewise
};

class GridSurface;

/// The drawn lines: all lines, and the visible sides of polygons, in order of items and corners. A
/// shared side appears once, for the first polygon that draws it. Lines that project to a point are
/// omitted.
std::vector<LineName> drawn_lines(const Primitives& items);

/// One of these lines, with its combined attributes.
struct LineToDraw {
  LineName name;
  LineKinds kinds;          ///< all kinds as which a polygon draws the side
  std::uint32_t pick_item;  ///< the item with the lowest pick identifier
};
/// The same list; `picks` are the items' pick identifiers, and `surface` is the surface that they
/// form, if any (GridSurface::of).
std::vector<LineToDraw> lines_to_draw(const Primitives& items, std::span<const std::int32_t> picks,
                                      const GridSurface* surface);
std::vector<LineToDraw> lines_to_draw(const Primitives& items, std::span<const std::int32_t> picks);

/// Finds the visible parts of the named lines, in device coordinates (hidden/lines/README.md has
/// the definition). A line named twice counts once; a line that projects to a point has no pieces.
/// With exact precision each end of a piece is the true one, rounded once to the nearest double, so
/// that all methods give the same pieces. Throws Error for an invalid line, or a method that finds
/// no lines: expected are roberts, appel, franklin, plain_appel and, for a surface, perimeter.
/// `surface` is the items' surface, if known.
///
/// Intersections are results of intersection_lines for the same items, or some of them. Exact
/// precision uses the exact common line of both planes between its exact ends, not the line between
/// the rounded ones.
SeenLines visible_lines(const Primitives& items, std::span<const LineName> lines,
                        const SurfacePlan& plan,
                        std::span<const IntersectionLine> intersections = {},
                        const GridSurface* surface = nullptr);

}  // namespace displayfile
