#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "hidden/exact/predicate_counts.h"
#include "tests/predicate_inputs.h"
#include "tests/rational_points.h"

// The truth by GMP rationals, straight from the definitions; it shares no code with the
// predicates.

namespace displayfile::test {

inline QPoint centre_of(const PixelCentre& c) {
  return {Q(2 * c.column + 1) / Q(2 * std::int64_t{c.size.width}),
          Q(2 * c.row + 1) / Q(2 * std::int64_t{c.size.height}), 0};
}
inline std::string text_of(const PixelCentre& c) {
  std::ostringstream out;
  out << " pixel " << c.column << "," << c.row << " of " << c.size.width << "x" << c.size.height;
  return out.str();
}

/// The rational verdicts on one test's cases, kept for comparison with the next build: judging
/// takes far longer than the predicates do. Off unless DISPLAYFILE_PREDICATE_VERDICTS names a
/// folder; a test's first run writes, later ones read.
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

/// A Case makes itself from a Source (false: no such case), returns the truth by rationals and the
/// predicate's result, and describes itself. `share` is the fraction of the trials, so that a test
/// stays short; it is ignored where the number of trials is set.
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
