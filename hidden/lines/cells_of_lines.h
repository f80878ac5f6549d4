#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hidden/lines/cell_layout.h"
#include "hidden/lines/visible_lines.h"
#include "hidden/primitives.h"

namespace displayfile {

/// The cells through which lines go: where lines are few, most polygons are in none of them, and
/// hide nothing of any.
class CellsOfLines {
 public:
  /// The names are in order, each once, and exist.
  CellsOfLines(const Primitives& items, std::span<const LineName> names,
               std::span<const IntersectionLine> intersections);

  /// True if lines are not few, or there are none: then they come near everything.
  bool are_everywhere() const { return with_lines_.empty(); }
  /// False only if no point of the box is on a line, in the projection.
  bool come_near(const Rectangle& box) const;

 private:
  struct Line {
    Point2 from, to;
    double margin;  ///< around it
  };
  bool enter(const std::vector<Line>& lines, std::size_t most);
  void pass_on();

  Rectangle all_{};  // around all lines
  CellLayout layout_;
  std::vector<std::vector<std::uint8_t>> with_lines_;  // of each level, of each cell, row by row
};

}  // namespace displayfile
