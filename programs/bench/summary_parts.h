#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "programs/bench/report.h"

namespace displayfile::bench {

/// What the tables of a report's summaries (programs/bench/summary.h) are put together from.

/// A ratio as it is read: 0.42, 3.2, 17.
std::string times(double ratio);
/// With a comma after the thousands.
std::string grouped(std::int64_t count);

inline constexpr const char* kSkipped = "skipped";

/// Why figures of a table are not there, after its text: a sentence for each.
class LeftOut {
 public:
  void add(const std::string& scene, const std::string& whose, const std::string& why);
  const std::string& words() const { return words_; }

 private:
  std::string words_;
};

/// Many times, few times or a count, of a comparison; kSkipped if it was left out, and empty if it
/// was not made.
std::string shown(const Report& report, const SceneRow& row, int threads, std::string_view other,
                  std::string_view what, LeftOut& left_out);

/// The numbers of threads that something was compared on.
std::vector<int> threads_of(const Report& report, std::string_view other);

std::string on_threads(std::string_view what, int threads);

}  // namespace displayfile::bench
