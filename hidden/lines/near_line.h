#pragma once

#include <algorithm>
#include <cmath>

#include "clip/point.h"

namespace displayfile {

/// The distance within which a point counts as on a line, in device coordinates.
struct OffLines {
  double in_picture = 0.0;  ///< in the projection only: rounding by viewing
  double touching = 0.0;    ///< in the projection and in depth: rounding in files
};

/// Bounds on the displacement of points by `touching` and by viewing alone, `rounding`
/// (Primitives). Touching bounds a reach of eight units of the entered numbers, of which each
/// coordinate is off by at most one.
inline OffLines off_lines(double touching, double rounding) {
  constexpr double kUnitsOfTouching = 0.125, kLikeViewing = 1e-12, kMostOff = 0x1p-12;
  const double off = kUnitsOfTouching * touching;
  return {std::max(4.0 * rounding, std::min(off, kLikeViewing)), std::min(off, kMostOff)};
}

/// Decides which points are on a line up to rounding. A corner that close to a line is on it: two
/// polygons that meet along the line, one with a vertex where the other has none, leave no gap
/// there, and neither covers more than its own side. In doubles, device coordinates.
class NearLine {
 public:
  /// No point is near, unless it is on the line.
  NearLine() = default;
  /// The line between two points that differ in the projection. For a short line the distance is at
  /// most 2^-10 of its length.
  NearLine(const Point3& a, const Point3& b, const OffLines& off) : a_(a), way_(b - a) {
    constexpr double kLeast = 1e-290;  // of a square: dividing by less may overflow
    squared_ = way_.x * way_.x + way_.y * way_.y;
    if (!(squared_ > kLeast)) return;
    const double length = std::sqrt(squared_), most = 0x1p-10 * length;
    in_picture_ = off.in_picture > 0.0 ? std::min(off.in_picture, most) * length : -1.0;
    touching_ = off.touching > 0.0 ? std::min(off.touching, most) * length : -1.0;
    farthest_ = std::max(in_picture_, touching_);
    in_depth_ = 8.0 * off.touching * (1.0 + std::abs(way_.z) / length);
  }

  bool has(const Point3& p) const {
    const double off = std::abs(way_.x * (p.y - a_.y) - way_.y * (p.x - a_.x));
    if (!(off <= farthest_)) [[likely]]
      return false;
    return off <= in_picture_ ||
           (off <= touching_ && std::abs(p.z - a_.z - place(Point2(p)) * way_.z) <= in_depth_);
  }
  /// The parameter of the point, or of the closest one on the line: 0 at its start, 1 at its end.
  double place(const Point2& p) const {
    return (way_.x * (p.x - a_.x) + way_.y * (p.y - a_.y)) / squared_;
  }

 private:
  Point3 a_{0.0}, way_{0.0};
  double squared_ = 0.0, in_depth_ = 0.0;
  double in_picture_ = -1.0, touching_ = -1.0, farthest_ = -1.0;  // each times the length
};

}  // namespace displayfile
