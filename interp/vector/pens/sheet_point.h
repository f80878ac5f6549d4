#pragma once

#include <cmath>

#include "clip/point.h"
#include "interp/vector/pens/stroke.h"

namespace displayfile {

/// The nearest point in integer units, of millimetres on a sheet.
inline SheetPoint sheet_point(const Point2& p) {
  return {static_cast<std::int32_t>(std::lround(p.x * kUnitsOfMillimetre)),
          static_cast<std::int32_t>(std::lround(p.y * kUnitsOfMillimetre))};
}

}  // namespace displayfile
