#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace displayfile::bench {

inline double seconds(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Least, middle and greatest of some figures.
struct Spread {
  double least, median, greatest;
};
inline Spread spread(std::vector<double> values) {
  std::ranges::sort(values);
  return {values.front(), values[values.size() / 2], values.back()};
}

/// Measures the seconds of a and of b, in turn, after one round that is not counted: b's over a's.
inline Spread ratio_of_seconds(int rounds, const auto& seconds_a, const auto& seconds_b) {
  std::vector<double> ratios;
  for (int i = 0; i <= rounds; ++i) {
    const double ta = seconds_a(), tb = seconds_b();
    if (i > 0) ratios.push_back(tb / ta);
  }
  return spread(ratios);
}

/// Times a against b, in turn, after one round that is not counted: b's time over a's, so
/// that more than 1 means that a is faster.
inline Spread times_faster(int rounds, const auto& a, const auto& b) {
  return ratio_of_seconds(
      rounds, [&] { return seconds(a); }, [&] { return seconds(b); });
}

}  // namespace displayfile::bench
