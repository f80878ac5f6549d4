#pragma once

#include <cfenv>
#include <cfloat>
#include <cmath>

namespace displayfile {

/// A number as the unevaluated sum of two doubles, the first of which is the sum rounded: some 106
/// bits. In rounding to nearest, without overflow and underflow, and if each operation rounds to a
/// double, the errors of operations are within the bounds stated here, with u = 2^-53 (Joldes,
/// Muller and Popescu, Tight and rigorous error bounds for basic building blocks of double-word
/// arithmetic, ACM TOMS 44, 2017).
struct DoubleDouble {
  double high = 0.0, low = 0.0;
};

/// True if the error bounds stated here hold: in rounding to nearest, to doubles.
inline bool is_double_double_sound() {
  return FLT_EVAL_METHOD == 0 && std::fegetround() == FE_TONEAREST;
}

/// a + b, exactly, if |a| >= |b| or a is 0.
inline DoubleDouble sum_of_ordered(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b, exactly (Knuth's TwoSum).
inline DoubleDouble exact_sum(double a, double b) {
  const double sum = a + b;
  const double a_part = sum - b, b_part = sum - a_part;
  return {sum, (a - a_part) + (b - b_part)};
}

/// a - b, exactly.
inline DoubleDouble exact_difference(double a, double b) { return exact_sum(a, -b); }

/// a b, exactly (Dekker's product of halves, by Veltkamp's splitting).
inline DoubleDouble exact_product(double a, double b) {
  constexpr double kSplitter = 0x1p27 + 1.0;
  const double in_a = kSplitter * a, in_b = kSplitter * b;
  const double a_high = in_a - (in_a - a), b_high = in_b - (in_b - b);
  const double a_low = a - a_high, b_low = b - b_high;
  const double product = a * b;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

inline DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }

/// Off by at most 4 u^2 of |a| + |b|.
inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble sum = exact_sum(a.high, b.high);
  return sum_of_ordered(sum.high, sum.low + (a.low + b.low));
}
inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + (-b); }

/// Off by at most 5 u^2 of the product.
inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = exact_product(a.high, b.high);
  return sum_of_ordered(high.high, high.low + (a.high * b.low + a.low * b.high));
}

/// Off by at most 16 u^2 of the quotient: the rounded quotient of the leading parts, plus that of
/// the remainder.
inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double first = a.high / b.high;
  const DoubleDouble taken = exact_product(first, b.high);
  const double rest = ((a.high - taken.high) - taken.low) + (a.low - first * b.low);
  return sum_of_ordered(first, rest / b.high);
}

}  // namespace displayfile
