// In a build without GMP the digits are handled by Boost.Multiprecision's integers, which are
// headers alone.

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <memory>

#include "hidden/exact/exact_number.h"

namespace displayfile {

namespace {

namespace mp = boost::multiprecision;

constexpr int kBitsOfLimb = 64;
static_assert(sizeof(mp::limb_type) * 8 == kBitsOfLimb, "limbs are handed to Boost as they are");

/// Holds products of numbers that are in place, in place too.
using Whole = mp::number<mp::cpp_int_backend<2 * 20 * kBitsOfLimb, 0, mp::signed_magnitude,
                                             mp::unchecked, std::allocator<mp::limb_type>>,
                         mp::et_off>;

/// The limbs, of which the highest is not zero, times 2^shift.
Whole whole(const std::uint64_t* limbs, int count, std::int64_t shift = 0) {
  const auto zeros = static_cast<unsigned>(shift / kBitsOfLimb);
  const auto size = zeros + static_cast<unsigned>(count);
  Whole n;
  n.backend().resize(size, size);
  std::fill_n(n.backend().limbs(), zeros, 0);
  std::copy_n(limbs, count, n.backend().limbs() + zeros);
  return n <<= shift % kBitsOfLimb;
}

int count_of(const Whole& n) { return static_cast<int>(n.backend().size()); }

/// Writes count_of(n) limbs.
void write_limbs(const Whole& n, std::uint64_t* to) {
  std::copy_n(n.backend().limbs(), n.backend().size(), to);
}

std::int64_t digits_of(const Whole& n) { return static_cast<std::int64_t>(mp::msb(n)) + 1; }

}  // namespace

void ExactNumber::multiply(const ExactNumber& a, const ExactNumber& b, ExactNumber& product) {
  const Whole n = whole(a.limbs(), a.count_) * whole(b.limbs(), b.count_);
  product.count_ = count_of(n);
  write_limbs(n, product.reserve(product.count_));
}

ExactNumber ExactNumber::sum_of(const ExactNumber& higher, int sign_of_higher,
                                const ExactNumber& lower, int sign_of_lower) {
  Whole n = whole(higher.limbs(), higher.count_, higher.exponent_ - lower.exponent_);
  if (sign_of_higher == sign_of_lower) {
    n += whole(lower.limbs(), lower.count_);
  } else {
    n -= whole(lower.limbs(), lower.count_);
  }
  ExactNumber result;
  result.exponent_ = lower.exponent_;
  result.sign_ = sign_of_higher * n.sign();
  result.count_ = count_of(n);
  write_limbs(n, result.reserve(result.count_));
  result.drop_leading_zeros();
  return result;
}

ExactNumber::Quotient ExactNumber::quotient(const ExactNumber& a, const ExactNumber& b) {
  Whole numerator = whole(a.limbs(), a.count_), denominator = whole(b.limbs(), b.count_);
  // Scaled so that the whole part of the quotient has 62 or 63 digits.
  const std::int64_t shift = 62 - (digits_of(numerator) - digits_of(denominator));
  if (shift >= 0) {
    numerator <<= shift;
  } else {
    denominator <<= -shift;
  }
  Whole whole_part, rest;
  mp::divide_qr(numerator, denominator, whole_part, rest);
  auto digits = static_cast<std::uint64_t>(whole_part);
  if (!rest.is_zero()) digits |= 1;
  return {digits, a.exponent_ - b.exponent_ - shift};
}

}  // namespace displayfile
