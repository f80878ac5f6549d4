#pragma once

#include "clip/point.h"

namespace displayfile {

/// The angle between two directions of any length, 0 to pi, within 8 units in the last place;
/// 0 if one has none. It is a function of its arguments alone, which the C library's arctangents
/// are not: these differ from one library to the next. angle_between(a, b) = angle_between(b, a).
double angle_between(const Point3& a, const Point3& b);

}  // namespace displayfile
