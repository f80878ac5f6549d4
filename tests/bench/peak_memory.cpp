#include "tests/bench/peak_memory.h"

#include <malloc.h>

#include <fstream>
#include <string>

namespace displayfile::bench {

namespace {

/// A figure of /proc/self/status, in bytes.
std::optional<std::size_t> status(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;) {
    std::size_t kilobytes = 0;
    if (word == name + ":" && file >> kilobytes) return 1024 * kilobytes;
  }
  return std::nullopt;
}

bool reset_peak() {
  std::ofstream file("/proc/self/clear_refs");
  file << "5" << std::flush;
  return file.good();
}

}  // namespace

std::optional<std::size_t> peak_bytes(const std::function<void()>& work) {
  malloc_trim(0);
  if (!reset_peak()) return std::nullopt;
  const auto before = status("VmRSS");
  work();
  const auto peak = status("VmHWM");
  if (!before || !peak) return std::nullopt;
  return *peak - *before;
}

}  // namespace displayfile::bench
