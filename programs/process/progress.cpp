#include "programs/process/progress.h"

#include <atomic>
#include <cstdio>

#include "clip/system/descriptors.h"

namespace displayfile {

namespace {
std::atomic<bool> one_is_shown = false;
}

/// Disables the display for good: only the first Progress is shown.
void Progress::show_none() { one_is_shown = true; }

Progress::Progress(const std::string& what)
    : what_(what), shown_(errors_are_on_terminal() && !one_is_shown.exchange(true)) {
  if (!shown_) return;
  std::fputs(("\r\x1b[K" + what + " ...").c_str(), stderr);
  std::fflush(stderr);
}

void Progress::update(std::size_t done, std::size_t all) {
  const std::size_t percent = all == 0 ? 100 : 100 * done / all;
  if (!shown_ || percent == percent_) return;
  percent_ = percent;
  std::fputs(("\r\x1b[K" + what_ + " ... " + std::to_string(percent) + "%").c_str(), stderr);
  std::fflush(stderr);
}

Progress::~Progress() {
  if (!shown_) return;
  std::fputs("\r\x1b[K", stderr);
  one_is_shown = false;
}

}  // namespace displayfile
