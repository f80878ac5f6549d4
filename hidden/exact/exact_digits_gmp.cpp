#include <gmp.h>

#include <algorithm>
#include <type_traits>

#include "hidden/exact/exact_number.h"

namespace displayfile {

static_assert(std::is_same_v<mp_limb_t, std::uint64_t> && GMP_NAIL_BITS == 0,
              "the limbs are handed to GMP as they are");

namespace {

constexpr int kBitsOfLimb = 64;

/// An integer of GMP's high-level kind, freed at the end of the scope.
class Integer {
 public:
  Integer() { mpz_init(value_); }
  Integer(const std::uint64_t* limbs, int count) : Integer() {
    mpz_import(value_, static_cast<std::size_t>(count), -1, sizeof(std::uint64_t), 0, 0, limbs);
  }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  ~Integer() { mpz_clear(value_); }
  operator mpz_ptr() { return value_; }

 private:
  mpz_t value_;
};

}  // namespace

void ExactNumber::multiply(const ExactNumber& a, const ExactNumber& b, ExactNumber& product) {
  const ExactNumber& longer = a.count_ >= b.count_ ? a : b;
  const ExactNumber& shorter = a.count_ >= b.count_ ? b : a;
  std::uint64_t* p = product.reserve(a.count_ + b.count_);
  mpn_mul(p, longer.limbs(), longer.count_, shorter.limbs(), shorter.count_);
  product.count_ = a.count_ + b.count_;
  product.drop_leading_zeros();
}

ExactNumber ExactNumber::sum_of(const ExactNumber& higher, int sign_of_higher,
                                const ExactNumber& lower, int sign_of_lower) {
  const std::int64_t shift = higher.exponent_ - lower.exponent_;
  const auto whole = static_cast<int>(shift / kBitsOfLimb);
  const auto bits = static_cast<unsigned>(shift % kBitsOfLimb);
  ExactNumber moved;
  int moved_count = higher.count_ + whole;
  const std::uint64_t* m = higher.limbs();
  if (shift != 0) {
    std::uint64_t* to = moved.reserve(moved_count + 1);
    std::fill_n(to, whole, 0);
    if (bits != 0) {
      to[moved_count] = mpn_lshift(to + whole, m, higher.count_, bits);
      if (to[moved_count] != 0) ++moved_count;
    } else {
      std::copy_n(m, higher.count_, to + whole);
    }
    m = to;
  }
  const std::uint64_t* l = lower.limbs();

  int m_against_l = moved_count - lower.count_;
  if (m_against_l == 0) m_against_l = mpn_cmp(m, l, moved_count);
  const bool m_is_larger = m_against_l >= 0;
  const std::uint64_t* large = m_is_larger ? m : l;
  const std::uint64_t* small = m_is_larger ? l : m;
  const int large_count = m_is_larger ? moved_count : lower.count_;
  const int small_count = m_is_larger ? lower.count_ : moved_count;

  ExactNumber result;
  result.exponent_ = lower.exponent_;
  result.sign_ = m_is_larger ? sign_of_higher : sign_of_lower;
  std::uint64_t* to = result.reserve(large_count + 1);
  if (sign_of_higher == sign_of_lower) {
    to[large_count] = mpn_add(to, large, large_count, small, small_count);
    result.count_ = large_count + 1;
  } else {
    mpn_sub(to, large, large_count, small, small_count);
    result.count_ = large_count;
  }
  result.drop_leading_zeros();
  return result;
}

ExactNumber::Quotient ExactNumber::quotient(const ExactNumber& a, const ExactNumber& b) {
  Integer numerator(a.limbs(), a.count_), denominator(b.limbs(), b.count_), rest;
  // Scaled so that the whole part of the quotient has 62 or 63 digits.
  const std::int64_t shift = 62 - (static_cast<std::int64_t>(mpz_sizeinbase(numerator, 2)) -
                                   static_cast<std::int64_t>(mpz_sizeinbase(denominator, 2)));
  if (shift >= 0) {
    mpz_mul_2exp(numerator, numerator, static_cast<mp_bitcnt_t>(shift));
  } else {
    mpz_mul_2exp(denominator, denominator, static_cast<mp_bitcnt_t>(-shift));
  }
  mpz_tdiv_qr(numerator, rest, numerator, denominator);
  std::uint64_t q = mpz_get_ui(numerator);
  if (mpz_sgn(static_cast<mpz_ptr>(rest)) != 0) q |= 1;
  return {q, a.exponent_ - b.exponent_ - shift};
}

}  // namespace displayfile
