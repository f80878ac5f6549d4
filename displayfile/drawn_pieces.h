#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "clip/point.h"
#include "displayfile/display_file.h"
#include "displayfile/looks/style.h"

namespace displayfile {

/// What the visible segments of a display file draw, in the order in which it is drawn, as arrays:
/// for programs that draw it by other means. Of a display file whose hidden surfaces were sorted
/// (sorted_display_file.h) they are
///  - by bsp or depth_sort all polygons from back to front, also those that others hide,
///  - by map, and by automatic, the visible pieces only,
///  - by a method that finds lines, the visible lines.
/// If they were not sorted these are all polygons and lines, as they were entered.
struct DrawnPieces {
  enum class Kind : std::uint8_t {
    solid,   ///< a polygon that is filled
    hollow,  ///< a polygon's sides alone
    line,    ///< from the first of its two points to the second
  };

  std::vector<Kind> kinds;
  /// Where each piece begins in points: piece k goes on to first[k + 1]. One more at the end.
  std::vector<std::uint32_t> first{0};
  /// Device coordinates: x and y in [0,1] over the picture, y up, larger z nearer to the viewer.
  std::vector<Point3> points;
  /// For each point 1 if the side that ends at it is drawn, or the kinds of line that it is
  /// (hidden/line_kinds.h), and 0 if it is not: sides that cuts made are not.
  std::vector<std::uint8_t> sides;
  /// For each point 1 if it is an end of a line, or of a side that is drawn, at which that is cut:
  /// it goes on there, but something may hide the rest. A thick line ends there without a cap.
  std::vector<std::uint8_t> cuts;
  /// One each piece: of solid polygons the colour that they are filled with, a shaded one with the
  /// mean of its shades; and how its sides, or the line, are drawn.
  std::vector<Colour> fills;
  enum class Line : std::uint8_t { solid, dashed, none };
  std::vector<Line> line_kinds;
  std::vector<Colour> line_colours;
  std::vector<double> line_widths, line_dashes, line_gaps;  ///< in pixels
  std::vector<std::int32_t> picks;     ///< pick identifiers; -1: a line without one
  std::vector<std::int32_t> segments;  ///< names

  std::size_t size() const { return kinds.size(); }
  /// What piece k is, but for its points.
  struct Looks {
    Kind kind;
    Colour fill;
    LineStyle line;
    std::int32_t pick, segment;
  };
  Looks looks(std::size_t k) const;
  /// The points since the last piece are one more.
  void end_piece(const Looks& looks);
};

DrawnPieces drawn_pieces(const DisplayFile& display_file);

}  // namespace displayfile
