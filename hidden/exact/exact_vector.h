#pragma once

#include "clip/point.h"
#include "hidden/exact/exact_number.h"

namespace displayfile {

/// Three numbers: exact ones, for the exact stages, or balls.
template <class Number>
struct VectorOf {
  Number x, y, z;
};
using ExactVector = VectorOf<ExactNumber>;

/// a - b.
template <class Number>
VectorOf<Number> difference_of(const Point3& a, const Point3& b) {
  return {Number(a.x) - Number(b.x), Number(a.y) - Number(b.y), Number(a.z) - Number(b.z)};
}
inline ExactVector exact_difference(const Point3& a, const Point3& b) {
  return difference_of<ExactNumber>(a, b);
}

/// cross(u, v) = -cross(v, u); zero if u and v are parallel.
template <class Number>
VectorOf<Number> cross(const VectorOf<Number>& u, const VectorOf<Number>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

template <class Number>
Number dot(const VectorOf<Number>& u, const VectorOf<Number>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

template <class Number>
VectorOf<Number> operator+(const VectorOf<Number>& u, const VectorOf<Number>& v) {
  return {u.x + v.x, u.y + v.y, u.z + v.z};
}

template <class Number>
VectorOf<Number> operator-(const VectorOf<Number>& u, const VectorOf<Number>& v) {
  return {u.x - v.x, u.y - v.y, u.z - v.z};
}

template <class Number>
VectorOf<Number> operator*(const VectorOf<Number>& u, const Number& factor) {
  return {u.x * factor, u.y * factor, u.z * factor};
}

}  // namespace displayfile
