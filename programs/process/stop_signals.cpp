#include "programs/process/stop_signals.h"

#include <csignal>

#include "clip/base/unfinished_path.h"

namespace displayfile {

namespace {

/// The signal's own action is in force again by then.
extern "C" void on_stop(int signal) {
  UnfinishedPath::end_naming();
  UnfinishedPath::remove_all();
  std::raise(signal);
}

}  // namespace

void leave_nothing_when_stopped() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU}) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action.sa_handler = on_stop;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigaction(signal, &action, nullptr);
  }
  std::signal(SIGXFSZ, SIG_IGN);  // what cannot be written is said, as of a full disk
}

}  // namespace displayfile
