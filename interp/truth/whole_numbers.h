#pragma once

#include <cstddef>
#include <span>

#include "interp/truth/integer.h"  // one of integer_*.h, which the build chooses

namespace displayfile {

// Doubles as whole numbers of any length, and quotients of these, for the truth alone: no method
// uses them.

/// How many binary digits the double, which is finite, has after its point.
int binary_places(double value);
/// As many as all of the doubles need.
int common_places(std::span<const double> values);

/// That many binary places, to shift by.
inline std::size_t bits(int places) { return static_cast<std::size_t>(places); }

/// value 2^places, which must be whole.
Integer scaled(double value, int places);

/// How many binary zeros the number ends with; the largest there is for 0.
std::size_t trailing_zeros(const Integer& n);

/// Quotients of whole numbers, with memory of their own.
class Division {
 public:
  /// The least whole number that is not less than a / b, but from 0 to `most`; b > 0.
  int ceiling(const Integer& a, const Integer& b, int most);

  /// The double nearest to a / b, of two equally near the even one; infinite beyond the largest
  /// double; b > 0. It grows with the quotient: where a / b < c / d, it is no greater for a / b.
  double nearest_double(const Integer& a, const Integer& b);

 private:
  Integer quotient_, rest_, shifted_;
};

}  // namespace displayfile
