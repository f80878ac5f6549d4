#pragma once

#include <cstddef>
#include <span>

#include "interp/truth/integer.h"  // one of integer_*.h, which the build chooses

namespace displayfile {

// Doubles as integers of any length, and quotients of these, for the truth alone: no method uses
// them.

/// The number of binary digits of a finite double after its point.
int binary_places(double value);
/// The number needed for all of the doubles.
int common_places(std::span<const double> values);

/// A number of binary places, as a shift.
inline std::size_t bits(int places) { return static_cast<std::size_t>(places); }

/// value 2^places, which must be whole.
Integer scaled(double value, int places);

/// The number of trailing binary zeros; the largest std::size_t for 0.
std::size_t trailing_zeros(const Integer& n);

/// Quotients of integers, with reused memory.
class Division {
 public:
  /// The least integer that is not less than a / b, clamped to 0 to `most`; b > 0.
  int ceiling(const Integer& a, const Integer& b, int most);

  /// The double nearest to a / b, of two equally near the even one; infinite beyond the largest
  /// double; b > 0. Monotonic in the quotient: where a / b < c / d, it is no greater for a / b.
  double nearest_double(const Integer& a, const Integer& b);

 private:
  Integer quotient_, rest_, shifted_;
};

}  // namespace displayfile
