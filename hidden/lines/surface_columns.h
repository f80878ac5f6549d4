#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "hidden/lines/verticals.h"

namespace displayfile {

/// A line from a surface's point p rightward to q, and its columns.
struct LineInColumns {
  std::uint32_t p, q;
  std::uint32_t first, last;  ///< its columns, up to rounding
  Point2 from, to;
  double slope;
  double height_at(double x) const { return from.y + slope * (x - from.x); }
};

/// The columns of a surface's picture (Verticals), each about as wide as the side of a cell.
/// Rounded coordinates decide columns.
class SurfaceColumns {
 public:
  /// `touching`: as Primitives::touching.
  SurfaceColumns(const GridSurface& surface, const Verticals& verticals, double touching);

  std::uint32_t size() const { return size_; }
  std::uint32_t of(double x) const {
    const double column = (x - left_) * per_width_;
    return static_cast<std::uint32_t>(std::clamp(column, 0.0, static_cast<double>(size_ - 1)));
  }
  /// The line between two points of the surface.
  LineInColumns line_between(std::uint32_t a, std::uint32_t b) const {
    Point2 from = verticals_.in_columns(a), to = verticals_.in_columns(b);
    if (from.x > to.x) {
      std::swap(a, b);
      std::swap(from, to);
    }
    const double width = to.x - from.x;
    return {a,
            b,
            of(from.x - margin_),
            of(to.x + margin_),
            from,
            to,
            width > 0.0 ? (to.y - from.y) / width : 0.0};
  }
  double left(std::uint32_t column) const { return left_ + column * width_; }
  /// More than the error of any rounded coordinate.
  double margin() const { return margin_; }
  /// Lines that are no farther from each other in the picture than this may be in one line as
  /// entered.
  double in_line() const { return in_line_; }

  /// A range of columns: [first, end).
  struct Range {
    std::uint32_t first, end;
  };
  /// Divides all columns into at most `count` parts with about equally many points.
  std::vector<Range> parts(std::size_t count) const;

 private:
  const GridSurface& surface_;
  const Verticals& verticals_;
  double left_ = 0.0, width_ = 1.0, per_width_ = 1.0, margin_ = 0.0, in_line_ = 0.0;
  std::uint32_t size_ = 1;
};

}  // namespace displayfile
