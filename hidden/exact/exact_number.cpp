#include "hidden/exact/exact_number.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <utility>

#include "clip/base/error.h"
#include "hidden/exact/exact_digits.h"

namespace displayfile {

namespace {

constexpr int kLimbBits = 64;
constexpr int kMantissaBits = 53;
constexpr std::int64_t kLeastExponent = -1074;  // of a double's last digit
constexpr std::int64_t kMostExponent = 971;     // of the largest double's last digit

/// The integer m and exponent e with |value| = m 2^e, read from the bits.
std::pair<std::uint64_t, std::int64_t> mantissa_and_exponent(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << (kMantissaBits - 1)) - 1);
  const auto biased = static_cast<std::int64_t>((bits >> (kMantissaBits - 1)) & 0x7ff);
  if (biased == 0) return {fraction, kLeastExponent};
  return {fraction | (std::uint64_t{1} << (kMantissaBits - 1)), biased - 1 + kLeastExponent};
}

/// q 2^exponent rounded to nearest, ties to even, as the bits of a double that is not
/// negative. q has at least 62 digits, its last one set if anything was cut off below.
double round_to_nearest(std::uint64_t q, std::int64_t exponent) {
  assert(std::bit_width(q) >= 62);
  const auto top = exponent + static_cast<std::int64_t>(std::bit_width(q)) - 1;
  const std::int64_t last = std::max(top - (kMantissaBits - 1), kLeastExponent);
  const std::int64_t dropped = last - exponent;
  if (dropped > kLimbBits) return 0.0;
  const std::uint64_t kept = dropped == kLimbBits ? 0 : q >> dropped;
  const std::uint64_t rest = dropped == kLimbBits ? q : q & ((std::uint64_t{1} << dropped) - 1);
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
  const std::uint64_t m = kept + ((rest > half || (rest == half && (kept & 1) == 1)) ? 1 : 0);
  const bool too_large =
      last > kMostExponent || (last == kMostExponent && m == (std::uint64_t{1} << kMantissaBits));
  if (too_large) throw Error("a point made by a cut lies farther away than any double");
  // A carry out of the fraction correctly increments the exponent.
  constexpr std::uint64_t kHidden = std::uint64_t{1} << (kMantissaBits - 1);
  if (m < kHidden) return std::bit_cast<double>(m);  // subnormal: last is kLeastExponent
  const auto biased = static_cast<std::uint64_t>(last - kLeastExponent + 1);
  return std::bit_cast<double>((biased << (kMantissaBits - 1)) + (m - kHidden));
}

}  // namespace

ExactNumber::ExactNumber(double value) {
  const auto [mantissa, exponent] = mantissa_and_exponent(value);
  set_magnitude(mantissa);
  exponent_ += exponent;
  if (std::signbit(value)) sign_ = -sign_;
}

ExactNumber::ExactNumber(std::int64_t value) {
  const auto bits = static_cast<std::uint64_t>(value);
  set_magnitude(value < 0 ? 0 - bits : bits);
  if (value < 0) sign_ = -sign_;
}

ExactNumber::ExactNumber(const ExactNumber& other) { copy_limbs(other); }

ExactNumber::ExactNumber(ExactNumber&& other) noexcept { *this = std::move(other); }

ExactNumber& ExactNumber::operator=(const ExactNumber& other) {
  if (this != &other) copy_limbs(other);
  return *this;
}

ExactNumber& ExactNumber::operator=(ExactNumber&& other) noexcept {
  if (this == &other) return *this;
  sign_ = other.sign_;
  count_ = other.count_;
  exponent_ = other.exponent_;
  large_ = std::move(other.large_);
  if (!large_) std::copy_n(other.in_place_.data(), count_, in_place_.data());
  other.sign_ = other.count_ = 0;
  return *this;
}

void ExactNumber::copy_limbs(const ExactNumber& other) {
  std::copy_n(other.limbs(), other.count_, reserve(other.count_));
  sign_ = other.sign_;
  count_ = other.count_;
  exponent_ = other.exponent_;
}

// Trailing zeros go into the exponent: coordinates on a grid stay short.
void ExactNumber::set_magnitude(std::uint64_t magnitude) {
  if (magnitude == 0) return;
  exponent_ = std::countr_zero(magnitude);
  in_place_[0] = magnitude >> exponent_;
  count_ = 1;
  sign_ = 1;
}

ExactNumber::Leading ExactNumber::leading() const {
  if (sign_ == 0) return {0.0, 0, true};
  assert(count_ > 0 && limbs()[count_ - 1] != 0);
  const std::uint64_t* p = limbs() + count_;
  const int zeros = std::countl_zero(p[-1]);
  std::uint64_t digits = p[-1] << zeros;
  if (zeros > 0 && count_ > 1) digits |= p[-2] >> (kLimbBits - zeros);
  const auto mantissa = static_cast<double>(digits >> (kLimbBits - kMantissaBits)) * 0x1p-53;
  std::uint64_t rest = digits << kMantissaBits;
  if (count_ > 1) rest |= p[-2] << zeros;
  for (int k = 3; k <= count_; ++k) rest |= p[-k];
  return {sign_ * mantissa, exponent_ + std::int64_t{kLimbBits} * count_ - zeros, rest == 0};
}

ExactNumber ExactNumber::operator-() const {
  ExactNumber negated(*this);
  negated.sign_ = -sign_;
  return negated;
}

ExactNumber operator*(const ExactNumber& a, const ExactNumber& b) {
  ExactNumber product;
  if (a.sign_ == 0 || b.sign_ == 0) return product;
  std::uint64_t* const p = product.reserve(a.count_ + b.count_);
  digits::multiply(a.limbs(), a.count_, b.limbs(), b.count_, p);
  product.count_ = a.count_ + b.count_;
  product.drop_leading_zeros();
  product.sign_ = a.sign_ * b.sign_;
  product.exponent_ = a.exponent_ + b.exponent_;
  return product;
}

/// Adds at the lower of both exponents: the other number's digits are shifted up.
ExactNumber ExactNumber::sum(const ExactNumber& a, const ExactNumber& b, int sign_of_b) {
  if (sign_of_b == 0) return a;
  if (a.sign_ == 0) {
    ExactNumber only(b);
    only.sign_ = sign_of_b;
    return only;
  }
  return a.exponent_ > b.exponent_ ? sum_of(a, a.sign_, b, sign_of_b)
                                   : sum_of(b, sign_of_b, a, a.sign_);
}

ExactNumber ExactNumber::sum_of(const ExactNumber& higher, int sign_of_higher,
                                const ExactNumber& lower, int sign_of_lower) {
  assert(higher.count_ > 0 && lower.count_ > 0 && sign_of_higher != 0 && sign_of_lower != 0);
  assert(higher.exponent_ >= lower.exponent_);
  const std::int64_t shift = higher.exponent_ - lower.exponent_;
  const auto whole = static_cast<int>(shift / kLimbBits);
  const auto bits = static_cast<unsigned>(shift % kLimbBits);
  ExactNumber moved;
  int moved_count = higher.count_ + whole;
  const std::uint64_t* m = higher.limbs();
  if (shift != 0) {
    std::uint64_t* to = moved.reserve(moved_count + 1);
    std::fill_n(to, whole, 0);
    if (bits != 0) {
      to[moved_count] = digits::shift_up(m, higher.count_, bits, to + whole);
      if (to[moved_count] != 0) ++moved_count;
    } else {
      std::copy_n(m, higher.count_, to + whole);
    }
    m = to;
  }
  const std::uint64_t* l = lower.limbs();

  int m_against_l = moved_count - lower.count_;
  if (m_against_l == 0) m_against_l = digits::compare(m, l, moved_count);
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
    to[large_count] = digits::add(large, large_count, small, small_count, to);
    result.count_ = large_count + 1;
  } else {
    digits::subtract(large, large_count, small, small_count, to);
    result.count_ = large_count;
  }
  result.drop_leading_zeros();
  return result;
}

double rounded_quotient(const ExactNumber& a, const ExactNumber& b) {
  if (b.sign_ == 0) throw Error("a point made by a cut does not exist: the planes are parallel");
  if (a.sign_ == 0) return 0.0;
  const auto [q, exponent] = digits::quotient(a.limbs(), a.count_, b.limbs(), b.count_);
  const double magnitude = round_to_nearest(q, exponent + a.exponent_ - b.exponent_);
  return a.sign_ == b.sign_ ? magnitude : -magnitude;
}

}  // namespace displayfile
