#pragma once

#include <cstdint>
#include <vector>

#include "hidden/lines/hidden_parts.h"
#include "hidden/lines/verticals.h"

namespace displayfile {

/// One perimeter, upper or lower: the polyline of the highest (lowest) sides drawn so far. It is
/// kept column by column: in each those sides that are part of it there, and maybe some that are
/// not. What a side is drawn against is exact; which sides are dropped from a column is decided by
/// rounded coordinates, with a margin.
class PerimeterPolyline {
 public:
  enum class Bound { upper, lower };

  /// A line from p to the right to q, and where it is among the columns.
  struct Line {
    std::uint32_t p, q;
    Point2 from, to;
    double slope;
    double height_at(double x) const { return from.y + slope * (x - from.x); }
  };
  static Line line_between(const Verticals& verticals, std::uint32_t a, std::uint32_t b);

  PerimeterPolyline(Bound bound, const GridSurface& surface, const Verticals& verticals);

  /// The parts of the line where the perimeter lies strictly beyond it, above it or below. United,
  /// with parameters that run to the left if it does.
  void find_within(const Line& line, bool runs_left, std::vector<PartOfLine>& parts) const;
  /// Moves the perimeter out to the side, where that is beyond it.
  void extend(const Line& side);

 private:
  /// A side, and the part of it that is in a column.
  struct Support {
    Line side;
    double low_x, high_x;  ///< of the part
    double lowest, highest;
  };
  std::uint32_t column_of(double x) const;
  Line upright(const Line& line) const;
  Support in_column(std::uint32_t column, const Line& line) const;
  void find_within_one(const Line& line, bool runs_left, const Line& side,
                       std::vector<PartOfLine>& parts) const;
  bool is_within(const Support& one, const Support& other) const;
  void drop_what_is_within(std::vector<Support>& supports);

  const GridSurface& surface_;
  const Verticals& verticals_;
  double sign_, left_, width_, margin_;  // of a column; sign 1: upper
  std::vector<std::vector<Support>> columns_;
  std::vector<std::uint32_t>
      drop_at_;  // of each column, the size at which to look for what to drop
  std::vector<PartOfLine> within_;
};

}  // namespace displayfile
