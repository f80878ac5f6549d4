// For builds without GMP. Boost.Multiprecision's header-only integers divide, and multiply long
// numbers. Most numbers have few limbs, and copying these into such an integer takes longer than
// multiplying: they are multiplied digit by digit here, like sums and shifts.

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cassert>

#include "hidden/exact/exact_digits.h"

namespace displayfile::digits {

namespace {

namespace mp = boost::multiprecision;

constexpr int kBitsOfLimb = 64;
constexpr int kBitsOfHalf = 32;
static_assert(sizeof(mp::limb_type) * 8 == kBitsOfLimb, "limbs are handed to Boost as they are");

/// Products of numbers with at least this many limbs use Boost.
constexpr int kLong = 20;

mp::cpp_int whole(const std::uint64_t* limbs, int count) {
  mp::cpp_int n;
  n.backend().resize(static_cast<unsigned>(count), static_cast<unsigned>(count));
  std::copy_n(limbs, count, n.backend().limbs());
  return n;
}

std::int64_t digits_of(const mp::cpp_int& n) { return static_cast<std::int64_t>(mp::msb(n)) + 1; }

void multiply_long(const std::uint64_t* a, int count_a, const std::uint64_t* b, int count_b,
                   std::uint64_t* to) {
  const mp::cpp_int product = whole(a, count_a) * whole(b, count_b);
  const auto count = static_cast<int>(product.backend().size());
  std::copy_n(product.backend().limbs(), count, to);
  std::fill(to + count, to + count_a + count_b, 0);
}

/// Writes the limbs as digits of 32 bits, so that a product of two fits in a limb; returns the
/// number of digits.
int split(const std::uint64_t* limbs, int count, std::uint32_t* halves) {
  for (int k = 0; k < count; ++k) {
    halves[2 * k] = static_cast<std::uint32_t>(limbs[k]);
    halves[2 * k + 1] = static_cast<std::uint32_t>(limbs[k] >> kBitsOfHalf);
  }
  return halves[2 * count - 1] == 0 ? 2 * count - 1 : 2 * count;
}

}  // namespace

std::uint64_t shift_up(const std::uint64_t* a, int count, unsigned bits, std::uint64_t* to) {
  std::uint64_t out = 0;
  for (int k = 0; k < count; ++k) {
    const std::uint64_t limb = a[k];
    to[k] = limb << bits | out;
    out = limb >> (kBitsOfLimb - bits);
  }
  return out;
}

int compare(const std::uint64_t* a, const std::uint64_t* b, int count) {
  for (int k = count; k-- > 0;) {
    if (a[k] != b[k]) return a[k] < b[k] ? -1 : 1;
  }
  return 0;
}

std::uint64_t add(const std::uint64_t* a, int count_a, const std::uint64_t* b, int count_b,
                  std::uint64_t* to) {
  assert(count_b <= count_a);
  std::uint64_t carry = 0;
  for (int k = 0; k < count_a; ++k) {
    const std::uint64_t carried = a[k] + carry;
    carry = carried < carry ? 1 : 0;
    to[k] = carried + (k < count_b ? b[k] : 0);
    carry += to[k] < carried ? 1 : 0;
  }
  return carry;
}

void subtract(const std::uint64_t* a, int count_a, const std::uint64_t* b, int count_b,
              std::uint64_t* to) {
  assert(count_b <= count_a);
  std::uint64_t borrow = 0;
  for (int k = 0; k < count_a; ++k) {
    const std::uint64_t borrowed = a[k] - borrow;
    borrow = borrowed > a[k] ? 1 : 0;
    const std::uint64_t taken = k < count_b ? b[k] : 0;
    to[k] = borrowed - taken;
    borrow += borrowed < taken ? 1 : 0;
  }
}

void multiply(const std::uint64_t* a, int count_a, const std::uint64_t* b, int count_b,
              std::uint64_t* to) {
  if (std::max(count_a, count_b) > kLong) {
    multiply_long(a, count_a, b, count_b, to);
    return;
  }
  std::array<std::uint32_t, 8 * kLong> room;
  std::uint32_t* const x = room.data();
  std::uint32_t* const y = x + 2 * kLong;
  std::uint32_t* const product = y + 2 * kLong;
  const int count_x = split(a, count_a, x), count_y = split(b, count_b, y);
  std::fill_n(product, 2 * (count_a + count_b), 0);
  for (int i = 0; i < count_x; ++i) {
    std::uint64_t carry = 0;
    for (int j = 0; j < count_y; ++j) {  // at most 2^64 - 1
      carry += std::uint64_t{x[i]} * y[j] + product[i + j];
      product[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= kBitsOfHalf;
    }
    product[i + count_y] = static_cast<std::uint32_t>(carry);
  }
  for (int k = 0; k < count_a + count_b; ++k) {
    to[k] = std::uint64_t{product[2 * k + 1]} << kBitsOfHalf | product[2 * k];
  }
}

Quotient quotient(const std::uint64_t* a, int count_a, const std::uint64_t* b, int count_b) {
  assert(count_a > 0 && a[count_a - 1] != 0 && count_b > 0 && b[count_b - 1] != 0);
  mp::cpp_int numerator = whole(a, count_a), denominator = whole(b, count_b);
  const std::int64_t shift = 62 - (digits_of(numerator) - digits_of(denominator));
  if (shift >= 0) {
    numerator <<= shift;
  } else {
    denominator <<= -shift;
  }
  mp::cpp_int whole_part, rest;
  mp::divide_qr(numerator, denominator, whole_part, rest);
  auto digits = static_cast<std::uint64_t>(whole_part);
  if (!rest.is_zero()) digits |= 1;
  return {digits, -shift};
}

}  // namespace displayfile::digits
