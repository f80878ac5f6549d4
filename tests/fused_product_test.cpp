// The products and sums of a build for Windows, on this machine: rounded once, as by its C library.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

// Under another name: the library has the system's own under the first.
#define fused_product fused_product_of_windows
#include "clip/system/windows/fused_product.cpp"
#undef fused_product

namespace displayfile {
namespace {

void expect_rounded_once(double a, double b, double c) {
  const double expected = std::fma(a, b, c), found = fused_product_of_windows(a, b, c);
  if (std::isnan(expected) && std::isnan(found)) return;
  EXPECT_EQ(std::bit_cast<std::uint64_t>(expected), std::bit_cast<std::uint64_t>(found))
      << std::hexfloat << a << " * " << b << " + " << c;
}

constexpr int kTrials = 200'000;

TEST(FusedProducts, OfAnyNumbersAreRoundedOnce) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto a = std::bit_cast<double>(random()), b = std::bit_cast<double>(random());
    expect_rounded_once(a, b, std::bit_cast<double>(random()));
  }
}

/// The numbers overlap, or nearly cancel.
TEST(FusedProducts, OfNumbersOfOneSizeAreRoundedOnce) {
  std::mt19937_64 random(2);
  for (const int least : {-1080, -1022, -540, -60, 400, 480}) {
    for (int trial = 0; trial < kTrials; ++trial) {
      const auto number = [&](int exponent) {
        const double fraction = static_cast<double>(random() >> 11) * 0x1p-52 - 1.0;
        return std::ldexp(fraction, exponent + static_cast<int>(random() % 60));
      };
      const double a = number(least), b = number(trial % 2 == 0 ? 0 : least);
      const bool is_zero = a == 0.0 || b == 0.0;  // too small for a double
      expect_rounded_once(a, b, number(is_zero ? least : std::ilogb(a) + std::ilogb(b) - 60));
      expect_rounded_once(a, b, -a * b);
      expect_rounded_once(a, b, std::nextafter(-a * b, 0.0));
    }
  }
}

TEST(FusedProducts, OfTheLeastAndTheLargestAreRoundedOnce) {
  using Limits = std::numeric_limits<double>;
  const double numbers[] = {0.0,
                            Limits::denorm_min(),
                            0x1.8p-1074,
                            Limits::min(),
                            0x1p-537,
                            0.5,
                            1.0,
                            0x1.fffffffffffffp0,
                            3.0,
                            0x1p53,
                            0x1p512,
                            Limits::max(),
                            Limits::infinity(),
                            Limits::quiet_NaN()};
  for (const double a : numbers) {
    for (const double b : numbers) {
      for (const double c : numbers) {
        expect_rounded_once(a, b, c);
        expect_rounded_once(-a, b, c);
      }
    }
  }
}

}  // namespace
}  // namespace displayfile
