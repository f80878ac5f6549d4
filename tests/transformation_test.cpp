#include "clip/view/transformation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "clip/geometry/crease_angle.h"
#include "programs/scenes/random.h"

namespace displayfile {
namespace {

// The doubles nearest to the true values. A C library may return a neighbour, and at some of these
// angles one does.
TEST(SineAndCosine, AreRoundedOnceWhateverTheLibraryGives) {
  EXPECT_EQ(sine_cosine_of_degrees(28.47936335046218).sine, 0x1.e849524b5c405p-2);
  EXPECT_EQ(sine_cosine_of_degrees(-10.982804909075277).sine, -0x1.862c688a1d0c5p-3);
  EXPECT_EQ(sine_cosine_of_degrees(1.0).sine, 0x1.1df0b2b89dd1ep-6);
  EXPECT_EQ(sine_cosine_of_degrees(30.0).sine, 0x1.fffffffffffffp-2);
  EXPECT_EQ(sine_cosine_of_degrees(33.3).sine, 0x1.191984d01e95bp-1);
  EXPECT_EQ(sine_cosine_of_degrees(-42.84398515595658).cosine, 0x1.77670bafa20c5p-1);
  EXPECT_EQ(sine_cosine_of_degrees(-40.03697883264064).cosine, 0x1.8800948b2f4c9p-1);
  EXPECT_EQ(sine_cosine_of_degrees(1.0).cosine, 0x1.ffec097f5af8ap-1);
  EXPECT_EQ(sine_cosine_of_degrees(30.0).cosine, 0x1.bb67ae8584cabp-1);
}

// A long double has room for ten more bits at least: half a unit in the last place, and no more.
TEST(SineAndCosine, ErrByHalfAUnitInTheLastPlace) {
  if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "no longer type to judge by";
  Random random(1);
  for (int i = 0; i < 100000; ++i) {
    const double degrees = random.between(-45.0, 45.0);
    const double radians = degrees * (std::numbers::pi / 180.0);
    const auto [sine, cosine] = sine_cosine_of_degrees(degrees);
    const auto units = [](double value, long double truth) {
      const double size = std::abs(value);
      const double unit = std::nextafter(size, 2.0) - size;
      return std::abs(static_cast<double>((value - truth) / unit));
    };
    ASSERT_LE(units(sine, std::sin(static_cast<long double>(radians))), 0.502) << degrees;
    ASSERT_LE(units(cosine, std::cos(static_cast<long double>(radians))), 0.502) << degrees;
  }
}

TEST(SineAndCosine, AreExactAtMultiplesOf90AndTheSameAfterFullTurns) {
  for (int turn = -3; turn <= 3; ++turn) {
    EXPECT_EQ(sine_cosine_of_degrees(turn * 360.0).sine, 0.0);
    EXPECT_EQ(sine_cosine_of_degrees(turn * 360.0 + 90.0).sine, 1.0);
    EXPECT_EQ(sine_cosine_of_degrees(turn * 360.0 + 180.0).cosine, -1.0);
    EXPECT_EQ(sine_cosine_of_degrees(turn * 360.0 - 90.0).sine, -1.0);
    EXPECT_EQ(sine_cosine_of_degrees(turn * 360.0 + 33.0).sine, sine_cosine_of_degrees(33.0).sine);
  }
}

// The directions are of any length, nearly along each other and nearly opposite too.
TEST(AngleBetween, IsWithinEightUnitsInTheLastPlace) {
  if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "no longer type to judge by";
  Random random(2);
  for (int i = 0; i < 100000; ++i) {
    // In a plane of the axes, so that the sine and the cosine are products rounded once.
    const double turn = random.between(-1.0, 1.0) * std::ldexp(1.0, -(i % 60));
    const double far = std::ldexp(1.0, i % 200 - 100);
    const Point3 along(far, 0, 0), aside((i % 2 == 0 ? 1.0 : -1.0) / far, turn / far, 0);
    const long double truth =
        std::atan2(std::abs(static_cast<long double>(aside.y)), static_cast<long double>(aside.x));
    const double angle = angle_between(along, aside);
    const double unit = std::nextafter(angle, 4.0) - angle;
    ASSERT_LE(std::abs(static_cast<double>((angle - truth) / unit)), 8.0) << turn;
    ASSERT_EQ(angle, angle_between(aside, along));
  }
}

TEST(AngleBetween, IsZeroWithoutADirectionAndExactOnTheAxes) {
  EXPECT_EQ(angle_between({0, 0, 0}, {1, 2, 3}), 0.0);
  EXPECT_EQ(angle_between({1, 2, 3}, {2, 4, 6}), 0.0);
  EXPECT_EQ(angle_between({1, 0, 0}, {-3, 0, 0}), std::numbers::pi);
  EXPECT_NEAR(angle_between({1, 0, 0}, {0, 5, 0}), std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(angle_between({1, 0, 0}, {1, 1, 0}), std::numbers::pi / 4, 1e-15);
}

}  // namespace
}  // namespace displayfile
