#pragma once

#include <optional>
#include <span>

#include "clip/point.h"

namespace displayfile {

/// Device coordinates as a light sees them that is infinitely far away in the world: parallel
/// projectors along z, larger z nearer to the light (displayfile/segments/lit_parts.md). Lines stay
/// lines and planes stay planes.
class LightProjection {
 public:
  /// The light as FillShadow::light has it. None if some of the points have no place in front of
  /// it, which does not happen to what the clip pipeline left.
  static std::optional<LightProjection> of(const HomogeneousPoint& light,
                                           std::span<const Point3> points);

  Point3 operator()(const Point3& device) const;
  /// Points of a line are weighted so: (p / weight(p) + q / weight(q)) / (the sum of both 1 /
  /// weight) is seen half way between p and q.
  double weight(const Point3& device) const { return value(weight_, device); }

 private:
  /// Linear, of the point and 1.
  using Row = HomogeneousPoint;
  static double value(const Row& row, const Point3& p) {
    return row.x * p.x + row.y * p.y + row.z * p.z + row.w;
  }
  static LightProjection from_afar(const HomogeneousPoint& light);
  static LightProjection from_nearby(const HomogeneousPoint& light);
  bool is_before(std::span<const Point3> points) const;

  Row across_{0.0}, up_{0.0}, depth_{0.0}, weight_{0.0};
};

}  // namespace displayfile
