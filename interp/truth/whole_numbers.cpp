#include "interp/truth/whole_numbers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace displayfile {

namespace {

constexpr int kMantissaBits = 53;

}  // namespace

int binary_places(double value) {
  if (value == 0.0) return 0;
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  const auto digits = static_cast<std::int64_t>(std::ldexp(fraction, kMantissaBits));
  const int trailing_zeros = std::countr_zero(static_cast<std::uint64_t>(digits));
  return std::max(0, kMantissaBits - exponent - trailing_zeros);
}

int common_places(std::span<const double> values) {
  int places = 0;
  for (const double v : values) places = std::max(places, binary_places(v));
  return places;
}

Integer scaled(double value, int places) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  Integer digits(std::ldexp(fraction, kMantissaBits));
  const int shift = exponent - kMantissaBits + places;
  if (shift >= 0) {
    digits <<= static_cast<std::size_t>(shift);
  } else {
    digits >>= static_cast<std::size_t>(-shift);  // zeros
  }
  return digits;
}

std::size_t trailing_zeros(const Integer& n) {
  return n == 0 ? std::numeric_limits<std::size_t>::max() : zeros_at_end(n);
}

int Division::ceiling(const Integer& a, const Integer& b, int most) {
  divide_up(a, b, quotient_);
  if (quotient_ <= 0) return 0;
  return quotient_ >= most ? most : static_cast<int>(magnitude(quotient_));
}

double Division::nearest_double(const Integer& a, const Integer& b) {
  constexpr int kLeastPlaces = 1074;  // of the smallest double's digit
  if (a == 0) return 0.0;
  // |a / b| 2^places has 62 or 63 binary digits before the point, or, if a double does not
  // reach as far, two digits more than it does.
  const int places = std::min(62 - digits_of(a) + digits_of(b), kLeastPlaces + 2);
  if (places >= 0) {
    set_shifted_left(shifted_, a, static_cast<std::size_t>(places));
    divide(shifted_, b, quotient_, rest_);
  } else {
    set_shifted_left(shifted_, b, static_cast<std::size_t>(-places));
    divide(a, shifted_, quotient_, rest_);
  }
  // The last digit is set if anything follows it.
  std::uint64_t digits = magnitude(quotient_);
  if (rest_ != 0) digits |= 1;
  const int dropped =
      std::max(static_cast<int>(std::bit_width(digits)) - kMantissaBits, places - kLeastPlaces);
  const std::uint64_t cut = digits & ((std::uint64_t{1} << dropped) - 1);
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
  std::uint64_t kept = digits >> dropped;
  if (cut > half || (cut == half && kept % 2 == 1)) ++kept;
  const double size = std::ldexp(static_cast<double>(kept), dropped - places);
  return a < 0 ? -size : size;
}

}  // namespace displayfile
