#pragma once

#include <cassert>
#include <cstdint>
#include <vector>

#include "hidden/lines/hidden_parts.h"
#include "hidden/lines/surface_columns.h"

namespace displayfile {

/// One perimeter, upper or lower: the polyline of the highest (lowest) sides drawn so far. It is
/// stored by columns, each with the sides that are part of it there, and possibly others.
/// Comparisons with sides are exact; sides are dropped from a column by rounded coordinates with a
/// margin.
class PerimeterPolyline {
 public:
  enum class Bound { upper, lower };

  using Line = LineInColumns;

  /// A perimeter for some of the columns. The arguments must outlive this.
  PerimeterPolyline(Bound bound, const GridSurface& surface, const Verticals& verticals,
                    const SurfaceColumns& columns, const SurfaceColumns::Range& range);

  /// The parts of the line strictly within the perimeter. United, with parameters that run to the
  /// left if `runs_left`. Sides of the perimeter that are in one line with it in the picture hide
  /// nothing, and are reported: true if there is one, and the parts are not the whole line.
  bool find_within(const Line& line, bool runs_left, std::vector<PartOfLine>& parts) const;
  /// Extends the perimeter to the side, where that is beyond it.
  void extend(const Line& side);

 private:
  /// A side, and the part of it that is in a column.
  struct Support {
    Line side;
    double low_x, high_x;  ///< of the part
    double lowest, highest;
  };
  /// The sides that are part of the perimeter in a column.
  struct Column {
    std::vector<Support> supports;
    std::uint32_t drop_at;  ///< the size at which to drop sides
    double floor;           ///< lower bound of the perimeter in the column
  };
  /// Columns from the first to the last; first > last: none.
  struct InRange {
    std::uint32_t first, last;
  };
  InRange in_range(const Line& line) const {
    return {std::max(range_.first, line.first), std::min(range_.end - 1, line.last)};
  }
  Column& column(std::uint32_t number) {
    assert(range_.first <= number && number < range_.end);
    return columns_[number - range_.first];
  }
  const Column& column(std::uint32_t number) const {
    assert(range_.first <= number && number < range_.end);
    return columns_[number - range_.first];
  }
  Line upright(const Line& line) const;
  Support in_column(std::uint32_t column, const Line& line) const;
  bool is_below_floors(const Line& line) const;
  bool is_covered(const Line& line) const;
  bool is_in_line(const Line& line, const Line& side) const;
  void find_within_one(const Line& line, bool runs_left, const Line& side,
                       std::vector<PartOfLine>& parts) const;
  bool is_clear_of(const Line& line, const Line& side) const;
  bool is_within(const Support& one, const Support& other) const;
  void drop_what_is_within(std::vector<Support>& supports);
  double floor_of(std::uint32_t number);

  const GridSurface& surface_;
  const Verticals& verticals_;
  const SurfaceColumns& layout_;
  SurfaceColumns::Range range_;
  double sign_, margin_;  // sign 1: upper
  std::vector<Column> columns_;
  std::vector<PartOfLine> within_;
};

}  // namespace displayfile
