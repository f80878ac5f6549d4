// The command stopped in the middle of its work.

#include <fmt/format.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include "tests/command_fixture.h"

namespace {

class StoppedCommand : public Command {};

/// In the middle of writing, by a signal: of the file that is being written nothing stays.
TEST_F(StoppedCommand, LeavesNothingBehindWhenItIsStopped) {
  std::string triangles = "set-view-depth -2 2\nopen-segment 1\n";
  for (int k = 0; k < 300; ++k) {
    const double x = -0.9 + 0.005 * k, y = 0.8 - 0.003 * (k * 7 % 500);
    triangles += fmt::format("polygon-abs-3 {0} {1} {2}  {3} {1} 0  {0} {4} 0\n", x, y, 0.01 * k,
                             x + 0.3, y - 0.4);
  }
  write("t.draw", triangles + "close-segment\n");
  const auto has_unfinished = [&] {
    return std::ranges::any_of(fs::directory_iterator(folder_), [](const auto& entry) {
      const std::string name = entry.path().filename().string();
      return name.starts_with(".t") || fs::is_empty(entry.path());
    });
  };
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::signal(signal, SIG_DFL);  // one that is ignored would stay ignored
      fs::current_path(folder_);
      ::execl(DISPLAYFILE_COMMAND, DISPLAYFILE_COMMAND, "draw", "t.draw", "--turntable", "10000",
              "-o", "t.png", "--size", "700x700", "--hidden", "franklin", nullptr);
      ::_exit(127);
    }
    int status = 0;
    while (!fs::exists(folder_ / "t-0002.png")) {
      ASSERT_EQ(::waitpid(child, &status, WNOHANG), 0) << "it ended by itself";
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ::kill(child, signal);
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << signal;
    EXPECT_FALSE(has_unfinished()) << signal;
    for (int k = 0; fs::remove(folder_ / fmt::format("t-{:04}.png", k)); ++k) {
    }
  }
}

}  // namespace
