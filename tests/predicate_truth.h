#pragma once

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "hidden/predicate_counts.h"
#include "tests/predicate_inputs.h"

// The truth by GMP rationals, straight from the definitions; it shares no code with the
// predicates.

namespace displayfile::test {

using Q = mpq_class;

/// The double times 2^shift, exactly. Every predicate of points and planes alone stays what
/// it is under such a scale, and whole numbers are quicker to judge.
inline Q scaled(double value, int shift) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  Q q(std::ldexp(fraction, 53));
  exponent += shift - 53;
  if (exponent >= 0) {
    mpq_mul_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return q;
}

struct QPoint {
  Q x, y, z;
};
inline QPoint operator+(const QPoint& a, const QPoint& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline QPoint operator-(const QPoint& a, const QPoint& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline QPoint operator*(const Q& k, const QPoint& a) { return {k * a.x, k * a.y, k * a.z}; }

inline Q turn(const QPoint& a, const QPoint& b, const QPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

struct QPlane {  // A x + B y + C z + D
  Q a, b, c, d;
  QPlane(const QPoint& p, const QPoint& q, const QPoint& r) {
    const QPoint u = q - p, v = r - p;
    a = u.y * v.z - u.z * v.y;
    b = u.z * v.x - u.x * v.z;
    c = u.x * v.y - u.y * v.x;
    d = -(a * p.x + b * p.y + c * p.z);
  }
  Q at(const QPoint& p) const { return a * p.x + b * p.y + c * p.z + d; }
  Q z(const Q& x, const Q& y) const { return -(a * x + b * y + d) / c; }
};

inline std::optional<QPoint> meet(const QPoint& a, const QPoint& b, const QPlane& h) {
  const Q at_a = h.at(a), at_b = h.at(b), drop = at_a - at_b;
  if (drop == 0) return std::nullopt;
  const Q t = at_a / drop;
  return a + t * (b - a);
}

inline std::optional<QPoint> meet(const QPlane& f, const QPlane& g, const QPlane& h) {
  // A line of f and g, found by solving with one coordinate free, is met by h.
  const std::array<Q, 3> along = {f.b * g.c - f.c * g.b, f.c * g.a - f.a * g.c,
                                  f.a * g.b - f.b * g.a};
  const auto solve = [](const Q& a, const Q& b, const Q& c, const Q& d, const Q& e, const Q& k,
                        Q& first, Q& second) {  // a X + b Y = c, d X + e Y = k
    const Q determinant = a * e - b * d;
    first = (c * e - b * k) / determinant;
    second = (a * k - c * d) / determinant;
  };
  QPoint on_line;
  if (along[2] != 0) {
    solve(f.a, f.b, -f.d, g.a, g.b, -g.d, on_line.x, on_line.y);
  } else if (along[1] != 0) {
    solve(f.a, f.c, -f.d, g.a, g.c, -g.d, on_line.x, on_line.z);
  } else if (along[0] != 0) {
    solve(f.b, f.c, -f.d, g.b, g.c, -g.d, on_line.y, on_line.z);
  } else {
    return std::nullopt;
  }
  return meet(on_line, on_line + QPoint{along[0], along[1], along[2]}, h);
}

/// By how much coordinates must be scaled up to be whole.
class Shift {
 public:
  void include(const Point3& p) {
    include(p.x);
    include(p.y);
    include(p.z);
  }
  void include(double v) {
    if (v == 0.0) return;
    int exponent = 0;
    std::frexp(v, &exponent);
    shift_ = std::max(shift_, std::min(53 - exponent, 1074));
  }
  int value() const { return shift_; }

 private:
  int shift_ = -400;
};
inline QPoint exact(const Point3& p, int shift) {
  return {scaled(p.x, shift), scaled(p.y, shift), scaled(p.z, shift)};
}

inline QPoint centre_of(const PixelCentre& c) {
  return {Q(2 * c.column + 1) / Q(2 * std::int64_t{c.size.width}),
          Q(2 * c.row + 1) / Q(2 * std::int64_t{c.size.height}), 0};
}
inline std::string text_of(const PixelCentre& c) {
  std::ostringstream out;
  out << " pixel " << c.column << "," << c.row << " of " << c.size.width << "x" << c.size.height;
  return out.str();
}

/// What the rationals said of one test's cases, kept for the next build to be held against the
/// same: judging takes far longer than the predicates do. Off unless
/// DISPLAYFILE_PREDICATE_VERDICTS names a folder; a test's first run writes, later ones read.
class Verdicts {
 public:
  Verdicts() {
    const char* const folder = std::getenv("DISPLAYFILE_PREDICATE_VERDICTS");
    if (folder == nullptr) return;
    const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::path(folder) /
            (std::string(test->name()) + "." + std::to_string(trials()) + ".verdicts");
    kept_.open(path_, std::ios::binary);
    if (!kept_.is_open()) fresh_.open(part(), std::ios::binary);
  }
  /// Once all of the test's cases have agreed.
  void keep() {
    if (!fresh_.is_open()) return;
    fresh_.close();
    std::filesystem::rename(part(), path_);
  }
  /// The sign of the truth, or nothing where there is none.
  template <class Case>
  std::optional<int> of(Case& c) {
    if (kept_.is_open()) {
      char verdict = 0;
      EXPECT_TRUE(kept_.get(verdict)) << path_ << " ends early";
      return verdict == kNone ? std::nullopt : std::optional<int>(verdict - kZero);
    }
    const std::optional<Q> truth = c.truth();
    const std::optional<int> sign = truth ? std::optional<int>(sgn(*truth)) : std::nullopt;
    if (fresh_.is_open()) fresh_.put(static_cast<char>(sign ? *sign + kZero : kNone));
    return sign;
  }

 private:
  static constexpr char kNone = 'n', kZero = '1';
  std::filesystem::path part() const { return path_.string() + ".part"; }

  std::filesystem::path path_;
  std::ifstream kept_;
  std::ofstream fresh_;
};

/// A Case makes itself from a Source (false: no such case), says the truth by rationals and
/// what the predicate says, and describes itself. `share` is of the trials, so that a test
/// stays short; it is not taken where the number of trials was asked for.
template <class Case>
void agrees(Predicate predicate, double share = 1.0) {
  reset_predicate_counts();
  Verdicts verdicts;
  if (trials_are_set()) share = 1.0;
  for (const Input input : {Input::random, Input::near_zero}) {
    Source s(input == Input::random ? 1 : 2);
    const auto count = static_cast<long>(static_cast<double>(trials()) * share);
    std::array<long, 3> seen{};
    for (long done = 0, tries = 0; done < count; ++tries) {
      ASSERT_LT(tries, 20 * count + 1000) << "the generator finds no cases";
      Case c;
      if (!c.make(s, input)) continue;
      const std::optional<int> truth = verdicts.of(c);
      if (!truth) continue;
      const int expected = *truth;
      const int mode = kModes[static_cast<std::size_t>(done % 4)];
      const int found = in_mode(mode, [&c] { return c.predicate(); });
      ++seen[static_cast<std::size_t>(expected + 1)];
      ++done;
      ASSERT_EQ(found, expected) << "mode " << mode << ", trial " << done << "\n" << c.text();
    }
    if (input == Input::near_zero && count >= 2000) {
      for (const long of_sign : seen) EXPECT_GT(of_sign, count / 100) << "too few of a sign";
    }
  }
  verdicts.keep();
  const StageCounts stages = predicate_counts()[static_cast<std::size_t>(predicate)];
  EXPECT_GT(stages.exact, 0u) << "the exact stage was never asked";
}

}  // namespace displayfile::test
