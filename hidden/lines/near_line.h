#pragma once

#include <algorithm>
#include <cmath>

#include "clip/point.h"

namespace displayfile {

/// Which points of the picture lie on a line but for rounding: what viewing rounds, and within
/// reach of each other what files do. A corner that is so close to a line is on it: two polygons
/// that meet along the line, one of which has a vertex where the other has none, leave no gap
/// there, and neither covers more than its own side. In doubles, device coordinates.
class NearLine {
 public:
  /// No point is near, unless it is on the line.
  NearLine() = default;
  /// The line between two points, and how far a point may be off it; for a short line no farther
  /// than 2^-10 of its length.
  NearLine(const Point2& a, const Point2& b, double off) : a_(a), way_(b - a) {
    squared_ = way_.x * way_.x + way_.y * way_.y;
    const double length = std::sqrt(squared_);
    off_ = off > 0.0 ? std::min(off, 0x1p-10 * length) * length : -1.0;
  }

  bool has(const Point2& p) const {
    return std::abs(way_.x * (p.y - a_.y) - way_.y * (p.x - a_.x)) <= off_;
  }
  /// Where the point is, or the one of the line that is closest to it: 0 at its start, 1 at its
  /// end.
  double place(const Point2& p) const {
    return (way_.x * (p.x - a_.x) + way_.y * (p.y - a_.y)) / squared_;
  }

 private:
  Point2 a_{0.0}, way_{0.0};
  double squared_ = 0.0, off_ = -1.0;
};

/// How far points may be off a line where coordinates may be off by `touching` and viewing alone
/// has rounded them by `rounding` (Primitives). Touching bounds a reach of eight units of what was
/// entered, of which each coordinate is off by one at most.
inline double off_lines(double touching, double rounding) {
  constexpr double kLargest = 0x1p-12;  // of the picture: no drawing shows less
  return std::max(4.0 * rounding, std::min(0.125 * touching, kLargest));
}

}  // namespace displayfile
