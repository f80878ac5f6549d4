#pragma once

#include <bit>
#include <cassert>
#include <cfloat>
#include <cstdint>
#include <limits>

namespace displayfile {

// The model of arithmetic from which every bound of the predicates is derived (predicates.md,
// section 2): for finite a, b without overflow, the computed a op b is
//   (a op b)(1 + d) + h  with |d| <= kUnit, |h| <= 2^-1074, and h = 0 for + and -.
// kUnit is 2^-52, twice the unit of rounding to nearest, so that the bounds hold in every
// rounding mode that a caller may have set, and with excess precision too.
static_assert(std::numeric_limits<double>::is_iec559 && FLT_RADIX == 2 && DBL_MANT_DIG == 53);

inline constexpr double kUnit = 0x1p-52;

/// Far more than the underflow error of products, also after the factors that follow; and not
/// itself subnormal, which would be slow.
inline constexpr double kTiny = 0x1p-1000;

/// Covers the rounding of a bound's own computation: up to 24 operations on non-negative numbers.
inline constexpr double kInflate = 1.0 + 32.0 * kUnit;

constexpr int sign_of(double x) { return (x > 0.0) - (x < 0.0); }

/// The sign of an x that is not zero, from its sign bit: once a filter has decided. 1 or -1;
/// decided_sign(-x) = -decided_sign(x).
constexpr int decided_sign(double x) {
  assert(x != 0.0);
  return static_cast<int>(std::bit_cast<std::int64_t>(x) >> 63) | 1;
}

/// The sign of a product x y of which neither is zero, from the sign bits of both.
constexpr int decided_sign(double x, double y) {
  assert(x != 0.0 && y != 0.0);
  return static_cast<int>((std::bit_cast<std::int64_t>(x) ^ std::bit_cast<std::int64_t>(y)) >> 63) |
         1;
}

}  // namespace displayfile
