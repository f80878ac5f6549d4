#include "programs/progress.h"

#include <unistd.h>

#include <cstdio>

namespace displayfile {

Progress::Progress(const std::string& what) : terminal_(isatty(STDERR_FILENO) == 1) {
  if (!terminal_) return;
  std::fputs(("\r\x1b[K" + what + " ...").c_str(), stderr);
  std::fflush(stderr);
}

Progress::~Progress() {
  if (terminal_) std::fputs("\r\x1b[K", stderr);
}

}  // namespace displayfile
