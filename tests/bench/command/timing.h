#pragma once

#include <time.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/bench/command/side_by_side.h"

namespace displayfile::bench {

/// The repetitions and the time of a ratio.
struct Effort {
  int rounds = 5;                ///< of both, in turn
  double least_seconds = 0.002;  ///< of a round's side: shorter work is repeated
  double most_seconds = 1.0;     ///< for all rounds of a ratio, of which there is at least one
};

/// Processor time excludes other work of the machine; but for several threads it is their sum,
/// which is not what a user waits for.
enum class Clock { processor, wall };
inline Clock clock_of(int threads) { return threads == 1 ? Clock::processor : Clock::wall; }

inline double now(Clock clock) {
  timespec t{};
  clock_gettime(clock == Clock::processor ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

inline double seconds_each(Clock clock, int times, const auto& work) {
  const double start = now(clock);
  for (int i = 0; i < times; ++i) work();
  return (now(clock) - start) / times;
}

/// The least time of `rounds`, as other work only adds to it.
inline double least_seconds_each(Clock clock, int rounds, const auto& work) {
  double least = seconds_each(clock, 1, work);
  for (int i = 1; i < rounds; ++i) least = std::min(least, seconds_each(clock, 1, work));
  return least;
}

/// The least of a few times for short work: a single one may include a wait, and the time
/// determines how often the work is repeated.
inline double seconds_once(const auto& work) {
  constexpr double kLong = 0.001;
  constexpr int kMostRounds = 5;
  double least = seconds_each(Clock::processor, 1, work);
  for (int i = 1; i < kMostRounds && least < kLong; ++i) {
    least = std::min(least, seconds_each(Clock::processor, 1, work));
  }
  return least;
}

/// As often as fills the time that is the least of a round's side.
inline int repetitions(double once, double least_seconds) {
  return static_cast<int>(std::clamp(std::ceil(least_seconds / std::max(once, 1e-9)), 1.0, 1e5));
}

/// The work's time over the reference's, in turn; `once` and `reference_once` are their approximate
/// times.
inline Spread ratio(const Effort& effort, Clock clock, double once, const auto& work,
                    double reference_once, const auto& reference) {
  const int times = repetitions(once, effort.least_seconds);
  const int reference_times = repetitions(reference_once, effort.least_seconds);
  const double round = once * times + reference_once * reference_times;
  const int rounds = std::clamp(static_cast<int>(effort.most_seconds / round), 1, effort.rounds);
  std::vector<double> ratios;
  for (int i = 0; i < rounds; ++i) {
    const double reference_seconds = seconds_each(clock, reference_times, reference);
    ratios.push_back(seconds_each(clock, times, work) / reference_seconds);
  }
  return spread(std::move(ratios));
}

/// The same for work of unknown duration; both are done before they are timed, so that both are
/// warm.
inline Spread warm_ratio(const Effort& effort, int threads, const auto& work,
                         const auto& reference) {
  work();
  reference();
  const double once = seconds_once(work), reference_once = seconds_once(reference);
  return ratio(effort, clock_of(threads), once, work, reference_once, reference);
}

}  // namespace displayfile::bench
