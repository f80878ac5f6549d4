#include "clip/system/fused_product.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace displayfile {

namespace {

__extension__ using Digits = unsigned __int128;

constexpr int kTop = 125;  // a sum of two numbers with this highest bit has at most 128 bits

/// digits * 2^exponent. The lowest bit is also set if anything was shifted out below it.
struct Magnitude {
  Digits digits;
  int exponent;
};

int highest_bit(Digits digits) {
  const auto high = static_cast<std::uint64_t>(digits >> 64);
  return high != 0 ? 127 - std::countl_zero(high)
                   : 63 - std::countl_zero(static_cast<std::uint64_t>(digits));
}

Magnitude shifted_down(const Magnitude& m, int places) {
  if (places <= 0) return m;
  if (places > 127) return {1, m.exponent + places};
  const bool lost = (m.digits & ((Digits{1} << places) - 1)) != 0;
  return {(m.digits >> places) | (lost ? 1 : 0), m.exponent + places};
}

Magnitude with_highest_bit(const Magnitude& m, int top) {
  const int up = top - highest_bit(m.digits);
  return up >= 0 ? Magnitude{m.digits << up, m.exponent - up} : shifted_down(m, -up);
}

/// The magnitude of a finite number other than 0: 53 digits or fewer.
Magnitude magnitude_of(double x) {
  constexpr int kDigits = 53;
  int exponent = 0;
  const double fraction = std::frexp(std::abs(x), &exponent);
  return {static_cast<std::uint64_t>(std::ldexp(fraction, kDigits)), exponent - kDigits};
}

/// Rounds to nearest, ties to even. Converting the integer rounds a normal number; a subnormal one
/// has fewer digits, and is rounded to them first.
double rounded(const Magnitude& m) {
  constexpr int kLeastExponent = -1074, kLeastNormal = -1022;
  const Magnitude short_one = with_highest_bit(m, 62);
  if (short_one.exponent + 62 >= kLeastNormal) {
    return std::ldexp(static_cast<double>(static_cast<std::int64_t>(short_one.digits)),
                      short_one.exponent);
  }
  constexpr int kGuards = 2;
  const Magnitude fixed = shifted_down(short_one, kLeastExponent - kGuards - short_one.exponent);
  const auto digits = static_cast<std::uint64_t>(fixed.digits);
  const std::uint64_t rest = digits & 3, whole = digits >> kGuards;
  const bool up = rest == 3 || (rest == 2 && (whole & 1) != 0);
  return std::ldexp(static_cast<double>(whole + (up ? 1 : 0)), kLeastExponent);
}

}  // namespace

/// Integer arithmetic. Both numbers are scaled to the same highest bit; if anything was shifted
/// out, a difference loses at most one digit, and 70 are to spare.
double fused_product(double a, double b, double c) {
  if (!std::isfinite(a) || !std::isfinite(b) || a == 0.0 || b == 0.0) return a * b + c;
  if (!std::isfinite(c)) return c;  // whatever the product rounds to
  if (c == 0.0) return a * b;       // the product is not 0, even if it rounds to 0
  const Magnitude of_a = magnitude_of(a), of_b = magnitude_of(b);
  Magnitude large =
      with_highest_bit({of_a.digits * of_b.digits, of_a.exponent + of_b.exponent}, kTop);
  Magnitude small = with_highest_bit(magnitude_of(c), kTop);
  bool large_is_negative = std::signbit(a) != std::signbit(b), small_is_negative = std::signbit(c);
  if (small.exponent > large.exponent ||
      (small.exponent == large.exponent && small.digits > large.digits)) {
    std::swap(large, small);
    std::swap(large_is_negative, small_is_negative);
  }
  small = shifted_down(small, large.exponent - small.exponent);
  const Digits digits = large_is_negative == small_is_negative ? large.digits + small.digits
                                                               : large.digits - small.digits;
  if (digits == 0) return 0.0;
  const double magnitude = rounded({digits, large.exponent});
  return large_is_negative ? -magnitude : magnitude;
}

}  // namespace displayfile
