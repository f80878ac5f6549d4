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

Integer scaled(double value, int places) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  Integer digits(std::ldexp(fraction, kMantissaBits));
  const int shift = exponent - kMantissaBits + places;
  if (shift >= 0) {
    digits <<= static_cast<mp_bitcnt_t>(shift);
  } else {
    digits >>= static_cast<mp_bitcnt_t>(-shift);  // zeros
  }
  return digits;
}

mp_bitcnt_t trailing_zeros(const Integer& n) {
  return n == 0 ? std::numeric_limits<mp_bitcnt_t>::max() : mpz_scan1(n.get_mpz_t(), 0);
}

int Division::ceiling(const Integer& a, const Integer& b, int most) {
  mpz_cdiv_q(quotient_.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  if (quotient_ <= 0) return 0;
  return quotient_ >= most ? most : static_cast<int>(quotient_.get_si());
}

double Division::nearest_double(const Integer& a, const Integer& b) {
  constexpr int kLeastPlaces = 1074;  // of the smallest double's digit
  const auto bits = [](const Integer& n) {
    return static_cast<int>(mpz_sizeinbase(n.get_mpz_t(), 2));
  };
  if (a == 0) return 0.0;
  // |a / b| 2^places has 62 or 63 binary digits before the point, or, if a double does not
  // reach as far, two digits more than it does.
  const int places = std::min(62 - bits(a) + bits(b), kLeastPlaces + 2);
  if (places >= 0) {
    mpz_mul_2exp(shifted_.get_mpz_t(), a.get_mpz_t(), static_cast<mp_bitcnt_t>(places));
    mpz_tdiv_qr(quotient_.get_mpz_t(), rest_.get_mpz_t(), shifted_.get_mpz_t(), b.get_mpz_t());
  } else {
    mpz_mul_2exp(shifted_.get_mpz_t(), b.get_mpz_t(), static_cast<mp_bitcnt_t>(-places));
    mpz_tdiv_qr(quotient_.get_mpz_t(), rest_.get_mpz_t(), a.get_mpz_t(), shifted_.get_mpz_t());
  }
  // The last digit says whether anything follows it.
  std::uint64_t digits = 0;
  mpz_export(&digits, nullptr, -1, sizeof digits, 0, 0, quotient_.get_mpz_t());
  if (rest_ != 0) digits |= 1;
  const int dropped =
      std::max(static_cast<int>(std::bit_width(digits)) - kMantissaBits, places - kLeastPlaces);
  const std::uint64_t cut = digits & ((std::uint64_t{1} << dropped) - 1);
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
  std::uint64_t kept = digits >> dropped;
  if (cut > half || (cut == half && kept % 2 == 1)) ++kept;
  const double magnitude = std::ldexp(static_cast<double>(kept), dropped - places);
  return a < 0 ? -magnitude : magnitude;
}

}  // namespace displayfile
