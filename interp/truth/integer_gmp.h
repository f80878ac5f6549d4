#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>

namespace displayfile {

// The truth's integers, by GMP: with operators, and in-place functions for other operations.

using Integer = mpz_class;
using Rational = mpq_class;

/// over / under; under is not 0.
inline Rational ratio(const Integer& over, const Integer& under) {
  Rational quotient(over, under);
  quotient.canonicalize();
  return quotient;
}

inline void add_product(Integer& to, const Integer& a, unsigned b) {
  mpz_addmul_ui(to.get_mpz_t(), a.get_mpz_t(), b);
}
inline void set_shifted_left(Integer& to, const Integer& n, std::size_t places) {
  mpz_mul_2exp(to.get_mpz_t(), n.get_mpz_t(), places);
}
/// Truncated quotient a / b and remainder; neither result is an argument.
inline void divide(const Integer& a, const Integer& b, Integer& quotient, Integer& rest) {
  mpz_tdiv_qr(quotient.get_mpz_t(), rest.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
}
/// The least integer that is not less than a / b.
inline void divide_up(const Integer& a, const Integer& b, Integer& quotient) {
  mpz_cdiv_q(quotient.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
}
/// The number of binary digits of a number other than 0.
inline int digits_of(const Integer& n) {
  return static_cast<int>(mpz_sizeinbase(n.get_mpz_t(), 2));
}
/// The number of trailing binary zeros of a number other than 0.
inline std::size_t zeros_at_end(const Integer& n) { return mpz_scan1(n.get_mpz_t(), 0); }
/// The magnitude of a number of at most 64 binary digits.
inline std::uint64_t magnitude(const Integer& n) {
  std::uint64_t digits = 0;
  mpz_export(&digits, nullptr, -1, sizeof digits, 0, 0, n.get_mpz_t());
  return digits;
}

}  // namespace displayfile
