#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hidden/lines/cell_layout.h"
#include "hidden/lines/visible_lines.h"
#include "hidden/primitives.h"

namespace displayfile {

/// The cells through which lines pass: with few lines, most polygons are in none of them and hide
/// nothing.
class CellsOfLines {
 public:
  /// Names are sorted, unique and valid.
  CellsOfLines(const Primitives& items, std::span<const LineName> names,
               std::span<const IntersectionLine> intersections);

  /// True if lines are many, or there are none: then come_near is always true.
  bool are_everywhere() const { return with_lines_.empty(); }
  /// False only if no point of the box is on a line, in the projection.
  bool come_near(const Rectangle& box) const;

 private:
  struct Line {
    Point2 from, to;
    double margin;  ///< around the line
  };
  bool enter(const std::vector<Line>& lines, std::size_t most);
  void pass_on();

  Rectangle all_{};  // around all lines
  CellLayout layout_;
  std::vector<std::vector<std::uint8_t>> with_lines_;  // per level and cell, row by row
};

}  // namespace displayfile
