#include "programs/options/work_limits.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "clip/base/error.h"
#include "clip/base/memory.h"
#include "clip/base/unfinished_path.h"
#include "clip/geometry/unit.h"
#include "clip/system/process_memory.h"
#include "clip/system/stopping.h"
#include "programs/options/number_in.h"
#include "programs/options/option_groups.h"

namespace displayfile {

namespace {

constexpr double kShareOfMachine = 0.75;
constexpr double kMostSeconds = 1e8;

void end_when_time_is_over(double seconds) {
  constexpr double kGrace = 1.02;
  end_process_after(
      kGrace * seconds,
      fmt::format("displayfile: {} seconds are not enough: expected a higher limit of seconds\n",
                  seconds),
      UnfinishedPath::end_with_none);
}

std::size_t usual_memory() {
  static const auto usual =
      static_cast<std::size_t>(kShareOfMachine * static_cast<double>(memory_of_machine()));
  return usual;
}

WorkLimits limits_of(const WorkLimitWords& words) {
  WorkLimits limits;
  limits.pieces = words.pieces;
  if (words.seconds) limits.seconds = *words.seconds;
  if (!words.memory.empty()) {
    limits.bytes = bytes_of_word("--limit-memory", words.memory);
  } else if (const std::size_t usual = usual_memory(); usual > 0) {
    limits.bytes = usual;
  }
  return limits;
}

/// Limits this process's data segment to `bytes`: an allocation beyond that fails. Throws Error if
/// more is in use.
void limit_memory_of_process(std::uint64_t bytes) {
  if (const std::size_t now = memory_of_process(); now >= bytes) {
    throw Error(fmt::format("{} bytes of memory are not enough: {} are in use", bytes, now));
  }
  set_limit_of_data(bytes);
}

/// A default limit that the process has already exceeded, as with a sanitizer, is ignored.
void limit_memory(const WorkLimitWords& words, std::uint64_t bytes) {
  if (bytes == WorkLimits::kNone) return;
  if (words.memory.empty() && memory_of_process() >= bytes) return;
  limit_memory_of_process(bytes);
}

}  // namespace

std::size_t bytes_of_word(const std::string& option, const std::string& word) {
  constexpr std::string_view kUnits = "kMG";
  const char* const end = word.data() + word.size();
  double number = 0.0;
  const auto [stop, failure] = std::from_chars(word.data(), end, number);
  std::string_view unit(stop, static_cast<std::size_t>(end - stop));
  if (unit.ends_with('B')) unit.remove_suffix(1);
  double scale = 1.0;
  bool is_known = failure == std::errc{} && unit.size() <= 1;
  if (is_known && !unit.empty()) {
    const std::size_t at = kUnits.find(unit[0] == 'K' ? 'k' : unit[0]);
    is_known = at != std::string_view::npos;
    scale = std::pow(1024.0, static_cast<double>(at) + 1.0);
  }
  const double bytes = number * scale;
  if (!is_known || !(bytes >= 1.0) || !(bytes < 0x1p62)) {
    throw Error(fmt::format("{} {}: expected bytes, such as 500M or 2G", option, word));
  }
  return static_cast<std::size_t>(bytes);
}

void WorkLimitWords::add_to(CLI::App& command, bool for_this_machine) {
  const std::string here =
      for_this_machine
          ? fmt::format(", here {:.3g}G", static_cast<double>(usual_memory()) * 0x1p-30)
          : "";
  command
      .add_option("--limit-seconds", seconds,
                  "time limit of the command; at the limit nothing is written, except pictures of "
                  "many inputs or views that are already complete [none]")
      ->type_name("SECONDS")
      ->transform(number_in(1e-3, kMostSeconds))
      ->group(kLimitOptions);
  command
      .add_option(
          "--limit-memory", memory,
          "memory limit of the command: bytes, or with k, M or G appended [3/4 of the machine's" +
              here + "]")
      ->type_name("BYTES")
      ->group(kLimitOptions);
  command
      .add_option("--limit-pieces", pieces,
                  "limit on the pieces of cut polygons, on the visible pieces of lines, and on the "
                  "edges of the map; uncut input is always allowed")
      ->type_name("N")
      ->transform(number_in<std::size_t>(1, 4'000'000'000))
      ->capture_default_str()
      ->group(kLimitOptions);
}

WorkLimitsInForce::WorkLimitsInForce(const WorkLimitWords& words)
    : budget_(limits_of(words)), in_force_(budget_), is_timed_(words.seconds.has_value()) {
  limit_memory(words, budget_.limits().bytes);
  if (is_timed_) end_when_time_is_over(*words.seconds);
}

WorkLimitsInForce::~WorkLimitsInForce() {
  if (is_timed_) end_process_no_more();
}

}  // namespace displayfile
