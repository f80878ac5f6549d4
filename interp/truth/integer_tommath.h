#pragma once

#include <boost/multiprecision/tommath.hpp>
#include <cstddef>
#include <cstdint>

namespace displayfile {

// The truth's integers, by LibTomMath with Boost's operators, in a build without GMP: a library
// that the methods do not use. The interface of integer_gmp.h, with the same meaning.

using Integer = boost::multiprecision::number<boost::multiprecision::tommath_int,
                                              boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<
    boost::multiprecision::rational_adaptor<boost::multiprecision::tommath_int>,
    boost::multiprecision::et_off>;

inline Rational ratio(const Integer& over, const Integer& under) { return Rational(over, under); }
inline int sgn(const Integer& n) { return n.sign(); }

inline void add_product(Integer& to, const Integer& a, unsigned b) { to += a * b; }
inline void set_shifted_left(Integer& to, const Integer& n, std::size_t places) {
  to = n;
  to <<= places;
}
inline void divide(const Integer& a, const Integer& b, Integer& quotient, Integer& rest) {
  boost::multiprecision::divide_qr(a, b, quotient, rest);
}
inline void divide_up(const Integer& a, const Integer& b, Integer& quotient) {
  Integer rest;
  divide(a, b, quotient, rest);
  if (rest.sign() == b.sign()) ++quotient;
}
inline int digits_of(const Integer& n) { return mp_count_bits(&n.backend().data()); }
inline std::size_t zeros_at_end(const Integer& n) {
  return static_cast<std::size_t>(mp_cnt_lsb(&n.backend().data()));
}
inline std::uint64_t magnitude(const Integer& n) { return mp_get_mag_u64(&n.backend().data()); }

}  // namespace displayfile
