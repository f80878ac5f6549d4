#include <gmp.h>

#include <cassert>
#include <type_traits>

#include "hidden/exact/exact_digits.h"

namespace displayfile::digits {

static_assert(std::is_same_v<mp_limb_t, std::uint64_t> && GMP_NAIL_BITS == 0,
              "the limbs are handed to GMP as they are");

namespace {

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

std::uint64_t shift_up(const std::uint64_t* a, int count, unsigned bits, std::uint64_t* to) {
  return mpn_lshift(to, a, count, bits);
}

int compare(const std::uint64_t* a, const std::uint64_t* b, int count) {
  return mpn_cmp(a, b, count);
}

std::uint64_t add(const std::uint64_t* a, int count_a, const std::uint64_t* b, int count_b,
                  std::uint64_t* to) {
  assert(count_b <= count_a);
  return mpn_add(to, a, count_a, b, count_b);
}

void subtract(const std::uint64_t* a, int count_a, const std::uint64_t* b, int count_b,
              std::uint64_t* to) {
  assert(count_b <= count_a);
  mpn_sub(to, a, count_a, b, count_b);
}

void multiply(const std::uint64_t* a, int count_a, const std::uint64_t* b, int count_b,
              std::uint64_t* to) {
  if (count_a >= count_b) {
    mpn_mul(to, a, count_a, b, count_b);
  } else {
    mpn_mul(to, b, count_b, a, count_a);
  }
}

Quotient quotient(const std::uint64_t* a, int count_a, const std::uint64_t* b, int count_b) {
  assert(count_a > 0 && a[count_a - 1] != 0 && count_b > 0 && b[count_b - 1] != 0);
  Integer numerator(a, count_a), denominator(b, count_b), rest;
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
  return {q, -shift};
}

}  // namespace displayfile::digits
