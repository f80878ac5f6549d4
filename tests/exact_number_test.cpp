// Exact numbers against GMP's whole numbers times powers of two, on random expressions: products
// and sums that cancel, of the largest and the smallest doubles, zero among them; and quotients
// against the definition of rounding, ties, subnormal doubles and overflow among them; in every
// rounding mode. Compiled with each of the files that handle the digits (tests/CMakeLists.txt).
// DISPLAYFILE_PREDICATE_TRIALS sets the numbers of expressions and of quotients.

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "clip/base/error.h"
#include "hidden/exact/exact_number.h"
#include "tests/from_environment.h"

namespace displayfile {
namespace {

const int kTrials = test::from_environment("DISPLAYFILE_PREDICATE_TRIALS", 20000);

/// m 2^e: the value of an exact number, by its definition.
struct Reference {
  mpz_class m;
  std::int64_t e = 0;
};

Reference reference(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return {mpz_class(std::ldexp(fraction, 53)), exponent - 53};
}

/// Both to the lower exponent.
void align(Reference& a, Reference& b) {
  const std::int64_t e = std::min(a.e, b.e);
  a.m <<= static_cast<mp_bitcnt_t>(a.e - e);
  b.m <<= static_cast<mp_bitcnt_t>(b.e - e);
  a.e = b.e = e;
}
Reference operator+(Reference a, Reference b) {
  align(a, b);
  return {a.m + b.m, a.e};
}
Reference operator-(Reference a, Reference b) {
  align(a, b);
  return {a.m - b.m, a.e};
}
Reference operator*(const Reference& a, const Reference& b) { return {a.m * b.m, a.e + b.e}; }
Reference magnitude(const Reference& a) { return {abs(a.m), a.e}; }
int compare(Reference a, Reference b) {
  align(a, b);
  return cmp(a.m, b.m);
}

/// An exact number and its reference value.
struct Pair {
  ExactNumber number;
  Reference is;
};
Pair pair(double value) { return {ExactNumber(value), reference(value)}; }
Pair operator+(const Pair& a, const Pair& b) { return {a.number + b.number, a.is + b.is}; }
Pair operator-(const Pair& a, const Pair& b) { return {a.number - b.number, a.is - b.is}; }
Pair operator*(const Pair& a, const Pair& b) { return {a.number * b.number, a.is * b.is}; }

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  int below(int n) { return static_cast<int>(bits_() % static_cast<std::uint64_t>(n)); }
  bool one_in(int n) { return below(n) == 0; }
  std::uint64_t bits() { return bits_(); }

  /// Any finite double, or one of a kind.
  double value() {
    const double sign = one_in(2) ? 1.0 : -1.0;
    const auto mantissa = static_cast<double>(bits_() >> 11);
    switch (below(8)) {
      case 0: return 0.0 * sign;
      case 1: return sign * below(1000);
      case 2: return sign * std::ldexp(1.0, below(2098) - 1074);
      case 3: return sign * std::ldexp(mantissa, -1074 - below(50));  // subnormal, some of them
      case 4: return sign * std::numeric_limits<double>::max();
      case 5: return sign * std::ldexp(mantissa, below(2000) - 1070);
      default: return sign * std::ldexp(mantissa, -53 - below(6));
    }
  }

 private:
  std::mt19937_64 bits_;
};

void round_some_way(Random& random) {
  constexpr std::array kModes{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
  std::fesetround(kModes[static_cast<std::size_t>(random.below(4))]);
}
class RoundsAgain {
 public:
  RoundsAgain() = default;
  RoundsAgain(const RoundsAgain&) = delete;
  RoundsAgain& operator=(const RoundsAgain&) = delete;
  ~RoundsAgain() { std::fesetround(FE_TONEAREST); }
};

// ---- Numbers -------------------------------------------------------------------------------

bool leading_is_right(const ExactNumber& number, const Reference& is) {
  if (number.sign() != sgn(is.m)) return false;
  const auto [mantissa, exponent, is_all] = number.leading();
  if (is.m == 0) return mantissa == 0.0 && is_all;
  long places = 0;
  const double truncated = mpz_get_d_2exp(&places, is.m.get_mpz_t());
  const std::size_t digits = mpz_sizeinbase(is.m.get_mpz_t(), 2) - mpz_scan1(is.m.get_mpz_t(), 0);
  return mantissa == truncated && exponent == places + is.e && is_all == (digits <= 53);
}

/// value 2^exponent.
Pair scaled(double value, std::int64_t exponent) {
  constexpr int kMost = 1000;
  Pair product = pair(value);
  for (; exponent > kMost; exponent -= kMost) product = product * pair(std::ldexp(1.0, kMost));
  for (; exponent < -kMost; exponent += kMost) product = product * pair(std::ldexp(1.0, -kMost));
  return product * pair(std::ldexp(1.0, static_cast<int>(exponent)));
}

/// True if all digits are right, with the leading ones subtracted again and again.
bool digits_are_right(Pair p) {
  for (;;) {
    if (!leading_is_right(p.number, p.is)) return false;
    const auto [mantissa, exponent, is_all] = p.number.leading();
    if (is_all) return true;
    p = p - scaled(mantissa, exponent);
  }
}

TEST(ExactNumber, IsWhatGmpSaysOfRandomExpressions) {
  const RoundsAgain after;
  Random random(1);
  for (int trial = 0; trial < kTrials; ++trial) {
    round_some_way(random);
    std::array<Pair, 6> pool;
    for (Pair& p : pool) p = pair(random.value());
    const auto any = [&]() -> Pair& { return pool[static_cast<std::size_t>(random.below(6))]; };
    for (int step = 0; step < 8; ++step) {
      const Pair a = any(), b = any(), c = any();
      Pair& result = any();
      switch (random.below(6)) {
        case 0: result = a + b; break;
        case 1: result = a - b; break;
        case 2: result = a * b; break;
        case 3: result = a * b - b * c; break;
        case 4: result = (a + b) - a; break;                       // the remainder is b
        default: result = (a * b + pair(random.value())) - b * a;  // nearly all cancels
      }
      ASSERT_TRUE(leading_is_right(result.number, result.is)) << "trial " << trial;
    }
    if (trial % 16 == 0) {
      ASSERT_TRUE(digits_are_right(any())) << "trial " << trial;
    }
    const Pair a = any(), b = any();
    ASSERT_EQ(((a * b) - (b * a)).number.sign(), 0) << "trial " << trial;
    ASSERT_TRUE(leading_is_right(-a.number, Reference{-a.is.m, a.is.e})) << "trial " << trial;
  }
}

TEST(ExactNumber, IsEveryWholeNumberOf64Digits) {
  Random random(2);
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto value = static_cast<std::int64_t>(random.bits()) >> random.below(64);
    ASSERT_TRUE(digits_are_right({ExactNumber(value), {mpz_class(value), 0}})) << value;
  }
  for (const std::int64_t value : {std::int64_t{0}, std::numeric_limits<std::int64_t>::min(),
                                   std::numeric_limits<std::int64_t>::max()}) {
    EXPECT_TRUE(digits_are_right({ExactNumber(value), {mpz_class(value), 0}})) << value;
  }
}

TEST(ExactNumber, GrowsToThousandsOfDigitsAndBack) {
  Random random(3);
  for (int trial = 0; trial < 1 + kTrials / 2000; ++trial) {
    Pair product = pair(1.0);
    for (int k = 0; k < 60; ++k) {
      double factor = random.value();
      while (factor == 0.0) factor = random.value();
      product = product * pair(factor) + pair(1.0);
      ASSERT_TRUE(leading_is_right(product.number, product.is));
    }
    ASSERT_TRUE(digits_are_right(product));
    const Pair copy = product;
    product = product - copy;
    EXPECT_EQ(product.number.sign(), 0);
    EXPECT_TRUE(digits_are_right(copy));
  }
}

// ---- Quotients -----------------------------------------------------------------------------

/// The double's neighbours and itself, of which 2^1024 is one.
Reference place(double value) {
  if (std::isinf(value)) return {value > 0 ? 1 : -1, 1024};
  return reference(value);
}

/// By the definition: no double is nearer to a / b than r, and if one is as near, r is even.
bool is_nearest(const Reference& a, const Reference& b, double r) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const Reference off = magnitude(a - reference(r) * b);
  for (const double other : {std::nextafter(r, kInfinite), std::nextafter(r, -kInfinite)}) {
    const int nearer = compare(off, magnitude(a - place(other) * b));
    const bool is_even = (std::bit_cast<std::uint64_t>(r) & 1) == 0;
    if (nearer > 0 || (nearer == 0 && !is_even)) return false;
  }
  return true;
}

/// |a / b| is at least halfway from the largest double to 2^1024.
bool exceeds_doubles(const Reference& a, const Reference& b) {
  const Reference halfway{(mpz_class(1) << 54) - 1, 970};
  return compare(magnitude(a), halfway * magnitude(b)) >= 0;
}

void expect_right_quotient(const Pair& a, const Pair& b) {
  double quotient = 0.0;
  try {
    quotient = rounded_quotient(a.number, b.number);
  } catch (const Error&) {
    ASSERT_TRUE(b.is.m == 0 || exceeds_doubles(a.is, b.is));
    return;
  }
  ASSERT_NE(b.is.m, 0);
  ASSERT_TRUE(std::isfinite(quotient));
  ASSERT_FALSE(exceeds_doubles(a.is, b.is));
  ASSERT_TRUE(is_nearest(a.is, b.is, quotient)) << quotient;
  if (quotient != 0.0) {
    ASSERT_EQ(quotient < 0.0, sgn(a.is.m) * sgn(b.is.m) < 0);
  }
}

TEST(ExactNumber, QuotientsAreTheNearestDoubles) {
  const RoundsAgain after;
  Random random(4);
  for (int trial = 0; trial < kTrials; ++trial) {
    round_some_way(random);
    Pair a = pair(random.value()), b = pair(random.value());
    if (random.one_in(2)) a = a * pair(random.value()) + pair(random.value());
    if (random.one_in(2)) b = b * pair(random.value()) - pair(random.value());
    if (random.one_in(4)) a = a * b + pair(random.value());  // near a double
    expect_right_quotient(a, b);
    if (HasFatalFailure()) FAIL() << "trial " << trial;
  }
}

/// Halfway between neighbours, where they are far apart, subnormal or the largest; or a crumb off.
TEST(ExactNumber, TiesOfQuotientsGoToTheEvenDouble) {
  const RoundsAgain after;
  Random random(5);
  for (int trial = 0; trial < kTrials; ++trial) {
    round_some_way(random);
    double below = std::abs(random.value());
    if (random.one_in(4)) below = std::ldexp(random.below(8), -1074);
    const double above = std::nextafter(below, std::numeric_limits<double>::infinity());
    const Pair half_step =
        std::isinf(above) ? pair(0x1p970) : (pair(above) - pair(below)) * pair(0.5);
    Pair quotient = pair(below) + half_step, divisor = pair(random.value());
    if (random.one_in(2)) divisor = divisor * pair(random.value());
    Pair dividend = quotient * divisor;
    if (random.one_in(3)) dividend = dividend + pair(random.value()) * pair(0x1p-1074);
    expect_right_quotient(dividend, divisor);
    if (HasFatalFailure()) FAIL() << "trial " << trial;
  }
}

TEST(ExactNumber, QuotientsBeyondDoublesAreErrors) {
  const Pair largest = pair(std::numeric_limits<double>::max()), tiny = pair(0x1p-1074);
  EXPECT_THROW(rounded_quotient(largest.number, tiny.number), Error);
  EXPECT_THROW(rounded_quotient(ExactNumber(0.0), ExactNumber(0.0)), Error);
  EXPECT_THROW(rounded_quotient(ExactNumber(1.0), ExactNumber(0.0)), Error);
  const Pair halfway = largest + pair(0x1p970);
  EXPECT_THROW(rounded_quotient(halfway.number, ExactNumber(-1.0)), Error);
  EXPECT_EQ(rounded_quotient((halfway - tiny).number, ExactNumber(1.0)),
            std::numeric_limits<double>::max());
  EXPECT_EQ(rounded_quotient((tiny * tiny).number, ExactNumber(1.0)), 0.0);
  EXPECT_EQ(rounded_quotient(ExactNumber(0.0), ExactNumber(-3.0)), 0.0);
}

}  // namespace
}  // namespace displayfile
