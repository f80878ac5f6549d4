#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "clip/point.h"

// Points and planes in GMP rationals; shares no code with the predicates.

namespace displayfile::test {

using Q = mpq_class;

/// The double times 2^shift, exactly. Every predicate of points and planes alone is unchanged by
/// such a scale, and whole numbers are quicker to judge.
inline Q scaled(double value, int shift) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  Q q(std::ldexp(fraction, 53));
  exponent += shift - 53;
  if (exponent >= 0) {
    mpq_mul_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return q;
}

struct QPoint {
  Q x, y, z;
};
inline QPoint operator+(const QPoint& a, const QPoint& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline QPoint operator-(const QPoint& a, const QPoint& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline QPoint operator*(const Q& k, const QPoint& a) { return {k * a.x, k * a.y, k * a.z}; }

inline Q turn(const QPoint& a, const QPoint& b, const QPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

struct QPlane {  // A x + B y + C z + D
  Q a, b, c, d;
  QPlane(const QPoint& p, const QPoint& q, const QPoint& r) {
    const QPoint u = q - p, v = r - p;
    a = u.y * v.z - u.z * v.y;
    b = u.z * v.x - u.x * v.z;
    c = u.x * v.y - u.y * v.x;
    d = -(a * p.x + b * p.y + c * p.z);
  }
  Q at(const QPoint& p) const { return a * p.x + b * p.y + c * p.z + d; }
  Q z(const Q& x, const Q& y) const { return -(a * x + b * y + d) / c; }
};

inline std::optional<QPoint> meet(const QPoint& a, const QPoint& b, const QPlane& h) {
  const Q at_a = h.at(a), at_b = h.at(b), drop = at_a - at_b;
  if (drop == 0) return std::nullopt;
  const Q t = at_a / drop;
  return a + t * (b - a);
}

inline std::optional<QPoint> meet(const QPlane& f, const QPlane& g, const QPlane& h) {
  // A line of f and g, found by solving with one coordinate free, is met by h.
  const std::array<Q, 3> along = {f.b * g.c - f.c * g.b, f.c * g.a - f.a * g.c,
                                  f.a * g.b - f.b * g.a};
  const auto solve = [](const Q& a, const Q& b, const Q& c, const Q& d, const Q& e, const Q& k,
                        Q& first, Q& second) {  // a X + b Y = c, d X + e Y = k
    const Q determinant = a * e - b * d;
    first = (c * e - b * k) / determinant;
    second = (a * k - c * d) / determinant;
  };
  QPoint on_line;
  if (along[2] != 0) {
    solve(f.a, f.b, -f.d, g.a, g.b, -g.d, on_line.x, on_line.y);
  } else if (along[1] != 0) {
    solve(f.a, f.c, -f.d, g.a, g.c, -g.d, on_line.x, on_line.z);
  } else if (along[0] != 0) {
    solve(f.b, f.c, -f.d, g.b, g.c, -g.d, on_line.y, on_line.z);
  } else {
    return std::nullopt;
  }
  return meet(on_line, on_line + QPoint{along[0], along[1], along[2]}, h);
}

/// The power of two by which coordinates must be scaled to be whole.
class Shift {
 public:
  void include(const Point3& p) {
    include(p.x);
    include(p.y);
    include(p.z);
  }
  void include(double v) {
    if (v == 0.0) return;
    int exponent = 0;
    std::frexp(v, &exponent);
    shift_ = std::max(shift_, std::min(53 - exponent, 1074));
  }
  int value() const { return shift_; }

 private:
  int shift_ = -400;
};
inline QPoint exact(const Point3& p, int shift) {
  return {scaled(p.x, shift), scaled(p.y, shift), scaled(p.z, shift)};
}

}  // namespace displayfile::test
