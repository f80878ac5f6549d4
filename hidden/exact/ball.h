#pragma once

#include <cassert>
#include <cmath>
#include <limits>

#include "hidden/exact/rounding.h"

namespace displayfile {

/// An interval as its middle and radius: the true value lies within `radius` of `middle`. The
/// operations enclose the exact result in every rounding mode, because each adds its own rounding
/// by the model of rounding.h (predicates.md, section 3). A radius is not negative; an infinite or
/// NaN radius means that nothing is known.
struct Ball {
  double middle = 0.0;
  double radius = 0.0;
};

/// The enclosure of a - b for exact doubles.
inline Ball ball_of_difference(double a, double b) {
  const double d = a - b;
  return {d, kUnit * std::abs(d) * kInflate + kTiny};
}

inline Ball operator-(const Ball& a) { return {-a.middle, a.radius}; }

inline Ball operator+(const Ball& a, const Ball& b) {
  const double m = a.middle + b.middle;
  return {m, (a.radius + b.radius + kUnit * std::abs(m)) * kInflate + kTiny};
}

inline Ball operator-(const Ball& a, const Ball& b) { return a + (-b); }

inline Ball operator*(const Ball& a, const Ball& b) {
  const double m = a.middle * b.middle;
  const double spread = std::abs(a.middle) * b.radius + std::abs(b.middle) * a.radius +
                        a.radius * b.radius + kUnit * std::abs(m);
  return {m, spread * kInflate + kTiny};
}

/// The quotient; nothing is known if b may be zero.
inline Ball operator/(const Ball& a, const Ball& b) {
  const double least = (std::abs(b.middle) - b.radius) * (1.0 - 4.0 * kUnit);
  if (!(least > 0.0)) return {0.0, std::numeric_limits<double>::infinity()};
  const double m = a.middle / b.middle;
  const double spread = (a.radius + std::abs(m) * b.radius + kTiny) / least + kUnit * std::abs(m);
  return {m, spread * kInflate + kTiny};
}

/// True if the ball decides the value's sign; decided(-a) = decided(a).
inline bool decided(const Ball& a) {
  assert(!(a.radius < 0.0));
  return std::abs(a.middle) > a.radius;
}

}  // namespace displayfile
