#pragma once

#include <glm/mat4x3.hpp>

#include "clip/point_row.h"

namespace displayfile {

/// A polygon as it was entered.
struct EnteredPolygon {
  PointRow points;  ///< before the modelling transformation
  const glm::dmat4x3* modelling =
      nullptr;  ///< null: the identity; the points are world coordinates
};

}  // namespace displayfile
