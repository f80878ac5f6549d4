#pragma once

#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "hidden/exact/ball.h"
#include "hidden/exact/double_double.h"

namespace displayfile {

/// An interval as a Ball is, with a middle of some 106 digits: the true value lies within `radius`
/// of `middle`. The operations enclose the exact result where those of double_double.h err by no
/// more than they say: in rounding to nearest (is_double_double_sound), and if no number, nor
/// 2^28 times one, exceeds the doubles.
class WideBall {
 public:
  WideBall() = default;
  explicit WideBall(double value) : middle_{value, 0.0} {}

  /// The double nearest to the value, if the ball decides it: nothing if its ends round
  /// differently.
  std::optional<double> rounded() const {
    const double least = middle_.high + (middle_.low - radius_ * kInflate);
    const double most = middle_.high + (middle_.low + radius_ * kInflate);
    return least == most && std::isfinite(least) ? std::optional(least) : std::nullopt;
  }

  WideBall operator-() const { return {-middle_, radius_}; }
  friend WideBall operator+(const WideBall& a, const WideBall& b) {
    return {a.middle_ + b.middle_,
            a.radius_ + b.radius_ + kOfSum * (std::abs(a.middle_.high) + std::abs(b.middle_.high))};
  }
  friend WideBall operator-(const WideBall& a, const WideBall& b) { return a + (-b); }
  friend WideBall operator*(const WideBall& a, const WideBall& b) {
    const DoubleDouble product = a.middle_ * b.middle_;
    const double spread = std::abs(a.middle_.high) * b.radius_ +
                          std::abs(b.middle_.high) * a.radius_ + a.radius_ * b.radius_;
    return {product, spread + kOfProduct * std::abs(product.high)};
  }
  /// Nothing is known if b may be zero.
  friend WideBall operator/(const WideBall& a, const WideBall& b) {
    const double least = std::abs(b.middle_.high) * (1.0 - 4.0 * kUnit) - b.radius_ * kInflate;
    if (!(least > 0.0)) return {{}, std::numeric_limits<double>::infinity()};
    const DoubleDouble quotient = a.middle_ / b.middle_;
    const double spread = (a.radius_ + kTiny + std::abs(quotient.high) * b.radius_) / least;
    return {quotient, spread + kOfQuotient * std::abs(quotient.high)};
  }

 private:
  // Relative to operands or results: twice the bounds of double_double.h, which also covers the
  // rounding of radii. The error of an operation that underflows is below kTiny.
  static constexpr double kOfSum = 0x1p-103, kOfProduct = 0x1p-102, kOfQuotient = 0x1p-101;

  WideBall(const DoubleDouble& middle, double radius)
      : middle_(middle), radius_(radius * (1.0 + 0x1p-20) + kTiny) {
    assert(!(radius_ < 0.0));
  }

  DoubleDouble middle_;
  double radius_ = 0.0;
};

}  // namespace displayfile
