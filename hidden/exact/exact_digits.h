#pragma once

#include <cstdint>

namespace displayfile::digits {

// The digits of exact numbers: whole numbers of any size that are not negative, as arrays of limbs
// of 64 bits, the least significant first. Implemented by exact_digits_gmp.cpp, or in a build
// without GMP by exact_digits_boost.cpp.

/// Writes a 2^bits, for 0 < bits < 64; returns the limb above those.
std::uint64_t shift_up(const std::uint64_t* a, int count, unsigned bits, std::uint64_t* to);

/// -1, 0 or 1: which of two of the same length is larger.
int compare(const std::uint64_t* a, const std::uint64_t* b, int count);

/// Writes as many limbs of a + b as a has; returns the limb above. b is not longer than a.
std::uint64_t add(const std::uint64_t* a, int count_a, const std::uint64_t* b, int count_b,
                  std::uint64_t* to);

/// Writes a - b, which is not negative, with as many limbs as a has. b is not longer than a.
void subtract(const std::uint64_t* a, int count_a, const std::uint64_t* b, int count_b,
              std::uint64_t* to);

/// Writes a b, count_a + count_b limbs, which must be others than those of a and b.
void multiply(const std::uint64_t* a, int count_a, const std::uint64_t* b, int count_b,
              std::uint64_t* to);

/// digits 2^exponent: the integer part of a quotient scaled to 62 or 63 bits. The last bit is also
/// 1 if the division leaves a remainder.
struct Quotient {
  std::uint64_t digits;
  std::int64_t exponent;
};

/// The quotient a / b. The highest limbs must not be zero.
Quotient quotient(const std::uint64_t* a, int count_a, const std::uint64_t* b, int count_b);

}  // namespace displayfile::digits
