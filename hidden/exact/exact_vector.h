#pragma once

#include "clip/point.h"
#include "hidden/exact/exact_number.h"

namespace displayfile {

/// Three exact numbers, for the exact stages.
struct ExactVector {
  ExactNumber x, y, z;
};

inline ExactVector exact_difference(const Point3& a, const Point3& b) {
  return {ExactNumber(a.x) - ExactNumber(b.x), ExactNumber(a.y) - ExactNumber(b.y),
          ExactNumber(a.z) - ExactNumber(b.z)};
}

inline ExactVector cross(const ExactVector& u, const ExactVector& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

inline ExactNumber dot(const ExactVector& u, const ExactVector& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

inline ExactVector operator+(const ExactVector& u, const ExactVector& v) {
  return {u.x + v.x, u.y + v.y, u.z + v.z};
}

inline ExactVector operator-(const ExactVector& u, const ExactVector& v) {
  return {u.x - v.x, u.y - v.y, u.z - v.z};
}

inline ExactVector operator*(const ExactVector& u, const ExactNumber& factor) {
  return {u.x * factor, u.y * factor, u.z * factor};
}

}  // namespace displayfile
