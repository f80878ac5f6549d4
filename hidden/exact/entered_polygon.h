#pragma once

#include <cstddef>
#include <glm/mat4x3.hpp>
#include <glm/vec4.hpp>

#include "clip/geometry/point_row.h"

namespace displayfile {

/// Error of world coordinates in units of 2^-53 of the largest sum of magnitudes: after a modelling
/// transformation, and after up to six cutting planes, each of which interpolates and rounds twice.
inline constexpr double kRoundingsInWorld = 4.0, kRoundingsWhereCut = 128.0;

/// A polygon as entered.
struct EnteredPolygon {
  PointRow points;  ///< before the modelling transformation
  const glm::dmat4x3* modelling =
      nullptr;  ///< null: the identity; the points are world coordinates

  /// A point in world coordinates, in doubles.
  Point3 in_world(std::size_t i) const {
    const Point3& p = points[i];
    return modelling == nullptr ? p : Point3(*modelling * glm::dvec4(p, 1.0));
  }
};

}  // namespace displayfile
