#include "programs/bench/summary_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "programs/bench/analysis.h"

namespace displayfile::bench {

std::string times(double ratio) {
  return fmt::format("{:.{}f}", ratio, ratio < 1.0 ? 2 : ratio < 9.95 ? 1 : 0);
}

std::string grouped(std::int64_t count) {
  const std::string digits = fmt::format("{}", count);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

void LeftOut::add(const std::string& scene, const std::string& whose, const std::string& why) {
  words_ += fmt::format("{} {}: {}, {}.", words_.empty() ? " Skipped:" : "", whose,
                        short_name(scene), why);
}

std::string shown(const Report& report, const SceneRow& row, int threads, std::string_view other,
                  std::string_view what, LeftOut& left_out) {
  const Beside* const found = find_beside(report, row.scene.id(), threads, other, what);
  if (found == nullptr) return "";
  if (!found->left_out.empty()) {
    left_out.add(row.scene.name, fmt::format("{} of {}", what, other), found->left_out);
    return kSkipped;
  }
  if (found->times_faster) return times(found->times_faster->median);
  return fmt::format("{:g}", *found->count);
}

std::vector<int> threads_of(const Report& report, std::string_view other) {
  std::vector<int> all;
  for (const Beside& b : report.beside) {
    if (b.other == other && std::ranges::find(all, b.threads) == all.end()) {
      all.push_back(b.threads);
    }
  }
  return all;
}

std::string on_threads(std::string_view what, int threads) {
  return threads == 1 ? std::string(what) : fmt::format("{}, {} threads", what, threads);
}

}  // namespace displayfile::bench
