#pragma once

#include <cstdint>
#include <vector>

#include "hidden/lines/hidden_parts.h"
#include "hidden/lines/verticals.h"

namespace displayfile {

/// The perimeters as in the problem book: an array of minima and maxima, one per column of a
/// plotting device, and a test of a line's endpoints. Used with ROUNDOFF, and the plain form of the
/// exact polylines.
class PerimeterArray {
 public:
  static constexpr std::uint32_t kColumns = 1024;

  /// Heights within `roundoff` of the whole are equal.
  PerimeterArray(const GridSurface& surface, const Verticals& verticals, double roundoff);

  /// The hidden part of the line: nothing, all, or from one end to the column of the change.
  void find_hidden(std::uint32_t a, std::uint32_t b, std::vector<PartOfLine>& parts) const;
  void extend(std::uint32_t a, std::uint32_t b);

 private:
  struct Range {
    double low, high;
  };
  double column_of(double x) const { return (x - left_) / width_; }
  std::uint32_t index(double column) const;
  bool is_hidden(std::uint32_t column, double height) const {
    return height < columns_[column].high - equal_ && height > columns_[column].low + equal_;
  }

  const GridSurface& surface_;
  const Verticals& verticals_;
  double left_, width_, equal_;
  std::vector<Range> columns_;
};

}  // namespace displayfile
