#include "tests/bench/command/process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <string_view>
#include <utility>

#include "clip/base/error.h"

namespace displayfile::bench {

namespace {

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  all.reserve(texts.size() + 1);
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

/// Includes our own variables, except those that the process sets, unless it wants only its own.
std::vector<std::string> environment_of(const Process& process) {
  std::vector<std::string> all = process.variables;
  if (process.variables_alone) return all;
  for (char** ours = environ; *ours != nullptr; ++ours) {
    const std::string_view variable(*ours);
    const std::string_view name = variable.substr(0, variable.find('=') + 1);
    const bool is_its_own = std::ranges::any_of(
        process.variables, [&](const std::string& own) { return own.starts_with(name); });
    if (!is_its_own) all.emplace_back(variable);
  }
  return all;
}

std::string read_to_the_end(int file) {
  std::string text;
  std::array<char, 4096> part;
  for (;;) {
    const ssize_t count = read(file, part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(part.data(), static_cast<std::size_t>(count));
  }
}

double seconds_of(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

}  // namespace

Finished run(Process process) {
  const bool keeps = process.output == Process::Output::kept;
  std::array<int, 2> ends{-1, -1};
  if (keeps && pipe2(ends.data(), O_CLOEXEC) != 0) throw Error("no pipe for a process's output");
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  if (keeps) posix_spawn_file_actions_adddup2(&files, ends[1], STDOUT_FILENO);
  if (process.messages == Process::Messages::nowhere) {
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  } else if (process.messages == Process::Messages::with_output) {
    posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  }
  std::vector<std::string> variables = environment_of(process);
  const auto begun = std::chrono::steady_clock::now();
  pid_t child = 0;
  const bool started =
      posix_spawnp(&child, process.command.front().c_str(), &files, nullptr,
                   pointers(process.command).data(), pointers(variables).data()) == 0;
  posix_spawn_file_actions_destroy(&files);
  Finished finished{started, false, {}, {}};
  if (keeps) {
    close(ends[1]);
    if (started) finished.output = read_to_the_end(ends[0]);
    close(ends[0]);
  }
  if (!started) return finished;
  int status = 0;
  rusage used{};
  while (wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
  }
  finished.succeeded = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begun;
  finished.cost = {wall.count(), seconds_of(used.ru_utime) + seconds_of(used.ru_stime),
                   1024.0 * static_cast<double>(used.ru_maxrss)};
  return finished;
}

Cost cost_of(const std::vector<std::string>& command) {
  const Finished finished = run(Process{
      .command = command, .output = Process::Output::ours, .messages = Process::Messages::nowhere});
  if (!finished.succeeded) throw Error(command.front() + " failed");
  return finished.cost;
}

}  // namespace displayfile::bench
