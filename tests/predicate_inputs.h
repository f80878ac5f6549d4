#pragma once

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <sstream>
#include <string>

#include "clip/geometry/unit.h"
#include "hidden/exact/pixel_centre.h"

// Input for the tests of the predicates: at random, and whole-numbered constructions that are
// exact zeros, put on to doubles and nudged by a few ulps.

namespace displayfile::test {

/// The number of each kind, for each predicate.
inline const char* trials_as_set() { return std::getenv("DISPLAYFILE_PREDICATE_TRIALS"); }
inline bool trials_are_set() { return trials_as_set() != nullptr; }
inline long trials() { return trials_are_set() ? std::atol(trials_as_set()) : 30000; }

enum class Input { random, near_zero };

class Source {
 public:
  explicit Source(std::uint64_t seed) : random_(seed) {}
  std::uint64_t bits() { return random_(); }
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 random_;
};

/// How random coordinates are drawn in one trial. `strong` styles reach the ends of the range.
struct Style {
  int kind;
  double scale, offset;
  Style(Source& s, bool strong) : kind(s.below(strong ? 7 : 4)), scale(1.0), offset(0.0) {
    if (kind == 1) scale = std::pow(10.0, s.between(-3, 3));
    if (kind == 2) scale = 1e-3, offset = std::pow(10.0, s.between(3, 9));
    if (kind == 6) scale = 1e100;
  }
  double draw(Source& s) const {
    switch (kind) {
      case 0: return s.unit();
      case 3: return static_cast<float>(2.0 * s.unit() - 1.0);
      case 4: {
        const int exponent = s.between(-1074, 330);
        return std::ldexp(2.0 * s.unit() - 1.0, exponent);
      }
      case 5: {
        const int exponent = -1074 + s.below(3);
        return std::ldexp(s.between(-9, 9), exponent);
      }
      default: return offset + scale * (2.0 * s.unit() - 1.0);
    }
  }
  Point3 point(Source& s) const {
    const double x = draw(s), y = draw(s), z = draw(s);
    return {x, y, z};
  }
};

/// Whole-numbered constructions, put exactly on to doubles and nudged by a few ulps. Each axis may
/// have a unit of its own: collinear or coplanar points stay so.
struct Grid {
  std::array<int, 3> exponent;  ///< the units are these powers of two
  std::array<std::int64_t, 3> offset{};
  int nudged_of_8;  ///< the number of coordinates in eight

  explicit Grid(Source& s) : nudged_of_8(s.below(4) == 0 ? 0 : s.between(1, 8)) {
    // Some for which the products are among the smallest doubles, of two factors or of three.
    constexpr std::array<int, 12> kExponents = {-1074, -1060, -700, -540, -537, -525,
                                                -358,  -352,  0,    20,   90,   300};
    const auto any = [&] { return kExponents[static_cast<std::size_t>(s.below(12))]; };
    exponent.fill(s.below(3) == 0 ? any() : -10);
    if (s.below(12) == 0) exponent = {any(), any(), any()};
    if (s.below(2) == 0) {
      for (std::int64_t& o : offset) {
        const int sign = s.between(-1, 1);
        o = sign * (std::int64_t{1} << s.below(30));
      }
    }
  }
  /// A few ulps of the value; of a zero, of the unit, a hair that differences round away.
  double nudge(Source& s, double value, int unit = 0) const {
    if (s.below(8) >= nudged_of_8) return value;
    const int ulps = s.between(-3, 3);
    if (value == 0.0 && s.below(2) == 0) return std::ldexp(ulps, unit - 54);
    for (int k = 0; k < std::abs(ulps); ++k) {
      value = std::nextafter(value, ulps > 0 ? 1e300 : -1e300);
    }
    return value;
  }
  Point3 place(Source& s, const std::array<std::int64_t, 3>& g) const {
    Point3 p;
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      p[k] = nudge(s, std::ldexp(static_cast<double>(g[i] + offset[i]), exponent[i]), exponent[i]);
    }
    return p;
  }
};

using Step = std::array<std::int64_t, 3>;
inline Step operator+(const Step& a, const Step& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Step operator*(std::int64_t k, const Step& a) { return {k * a[0], k * a[1], k * a[2]}; }
inline Step step(Source& s, int size) {
  return {s.between(-size, size), s.between(-size, size), s.between(-size, size)};
}
inline std::int64_t factor(Source& s) {  // not zero
  const int k = s.between(1, 7);
  return s.below(2) == 0 ? k : -k;
}
inline int step_size(Source& s) { return s.below(2) == 0 ? 3 : 1000; }

/// Three points of a plane through g, none of them g itself.
inline std::array<Point3, 3> plane_through(Source& s, const Grid& grid, const Step& g, int size) {
  const Step u = step(s, size), v = step(s, size);
  return {grid.place(s, g + u), grid.place(s, g + v), grid.place(s, g + -1 * u + -1 * v)};
}

/// A pixel centre that doubles can hold if the picture's size is 2^k times its odd part, and
/// the grid of doubles around it.
struct CentreGrid {
  PictureSize size{1, 1};
  std::int32_t column = 0, row = 0;
  std::int64_t x = 0, y = 0;  // the centre, in steps of the grid
  double x_step = 1.0, y_step = 1.0;

  explicit CentreGrid(Source& s) {
    constexpr std::array<std::int32_t, 12> kSizes = {1,   2,    3,    7,    32,      48,
                                                     100, 1024, 1080, 1920, 1000003, 1 << 28};
    size = {kSizes[static_cast<std::size_t>(s.below(12))],
            kSizes[static_cast<std::size_t>(s.below(12))]};
    axis(s, size.width, column, x, x_step);
    axis(s, size.height, row, y, y_step);
  }
  PixelCentre centre() const { return {column, row, size}; }
  /// Any of the picture, as a rule none that doubles can hold.
  PixelCentre any_centre(Source& s) const {
    return {s.below(size.width), s.below(size.height), size};
  }

 private:
  static void axis(Source& s, std::int32_t pixels, std::int32_t& index, std::int64_t& at,
                   double& step) {
    std::int32_t odd = pixels;
    while (odd % 2 == 0) odd /= 2;
    at = 2 * s.below(pixels / odd) + 1;
    if (s.below(8) == 0) at -= 2 * (pixels / odd);  // outside of the picture
    index = static_cast<std::int32_t>((odd * at - 1) / 2);
    step = 1.0 / (2.0 * (pixels / odd));
  }
};

constexpr std::array<int, 4> kModes = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

/// Calls it with the rounding mode changed around the call, and nothing else moved into it.
template <class Call>
[[gnu::noinline]] int in_mode(int mode, const Call& call) {
  std::fesetround(mode);
  asm volatile("" ::: "memory");
  volatile int result = call();
  asm volatile("" ::: "memory");
  std::fesetround(FE_TONEAREST);
  return result;
}

inline std::string hex(const Point3& p) {
  std::ostringstream out;
  out << std::hexfloat << "(" << p.x << ", " << p.y << ", " << p.z << ")";
  return out.str();
}

}  // namespace displayfile::test
