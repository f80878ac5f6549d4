#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "clip/geometry/rectangle.h"
#include "clip/point.h"
#include "interp/annotation/page_annotation.h"

namespace displayfile {

/// Clearances, in parts of the capitals' height.
inline constexpr double kFromFigure = 1.5, kFromOthers = 0.7;

/// A place beside the figure for a leader's text or a balloon.
struct LabelCell {
  Point2 port;  ///< the end of the line, on the strip's border
  PageAnnotation::Side side;
  Rectangle box;  ///< of the largest text or balloon there
};

/// Where the cells are: left and right of the figure, in the whole height of the room; above and
/// below it, in the whole width; or all around, no farther than the figure.
enum class LabelSides { beside, above_and_below, around };
struct LabelCells {
  std::vector<LabelCell> cells;
  bool have_room = true;  ///< false: they are at the room's border, and may cover the figure
};

/// Cells for labels on both sides of a strip that holds the figure, whose rectangle this is, and
/// the labels' anchors: all boxes are outside of the strip, in the room, and disjoint
/// (placement.md).
LabelCells label_cells(std::span<PageAnnotation* const> labels, const Rectangle& figure,
                       const Rectangle& room, LabelSides sides);

/// crosses(i, c): whether the line from anchor i to the port of cell c crosses other annotation.
using CrossesOthers = std::function<bool(std::size_t anchor, std::size_t cell)>;

/// Gives each anchor a cell of its own so that no two lines from anchors to ports cross, and few of
/// them cross other annotation (a local minimum). Returns the number of each anchor's cell, or the
/// number of cells where none was left.
std::vector<std::size_t> assigned_cells(std::span<const Point2> anchors,
                                        std::span<const LabelCell> cells,
                                        const CrossesOthers& crosses);

}  // namespace displayfile
