#pragma once

#include "displayfile/looks/style.h"

namespace displayfile {

/// The data from which PhongShade (interp/raster/phong_shade.h) paints a row of pixels.
struct PhongRow {
  Point3 normal;  ///< at column x0
  Point3 step;    ///< increment per column
  Point3 low, high;
  Point3 toward;  ///< the light, unit
  Colour colour;
  double x0, ambient;
};

}  // namespace displayfile
