#include "programs/progress.h"

#include <unistd.h>

#include <cstdio>

namespace displayfile {

Progress::Progress(const std::string& what) : what_(what), terminal_(isatty(STDERR_FILENO) == 1) {
  if (!terminal_) return;
  std::fputs(("\r\x1b[K" + what + " ...").c_str(), stderr);
  std::fflush(stderr);
}

void Progress::update(std::size_t done, std::size_t all) {
  const std::size_t percent = all == 0 ? 100 : 100 * done / all;
  if (!terminal_ || percent == percent_) return;
  percent_ = percent;
  std::fputs(("\r\x1b[K" + what_ + " ... " + std::to_string(percent) + "%").c_str(), stderr);
  std::fflush(stderr);
}

Progress::~Progress() {
  if (terminal_) std::fputs("\r\x1b[K", stderr);
}

}  // namespace displayfile
