#include "tests/bench/lines_beside_peers/peer_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>

namespace displayfile::bench {

PeerProcess::PeerProcess(std::vector<std::string> command, double limit) : limit_(limit) {
  ::signal(SIGPIPE, SIG_IGN);  // a peer that has ended is told by its answer
  std::array<int, 2> questions{-1, -1}, answers{-1, -1};
  if (pipe2(questions.data(), O_CLOEXEC) != 0) throw PeerStopped("no pipe to a peer");
  to_ = questions[1];
  if (pipe2(answers.data(), O_CLOEXEC) != 0) {
    close(questions[0]);
    stop();
    throw PeerStopped("no pipe from a peer");
  }
  from_ = answers[0];
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, questions[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, answers[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::vector<char*> words;
  words.reserve(command.size() + 1);
  for (std::string& word : command) words.push_back(word.data());
  words.push_back(nullptr);
  const bool started = posix_spawnp(&child_, words[0], &files, nullptr, words.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&files);
  close(questions[0]);
  close(answers[1]);
  if (!started) child_ = -1;
  try {
    if (!started) throw PeerStopped(command[0] + " cannot be started");
    answer("ready");
  } catch (const PeerStopped&) {
    stop();
    throw;
  }
}

PeerProcess::~PeerProcess() { stop(); }

void PeerProcess::stop() {
  for (int* file : {&to_, &from_}) {
    if (*file >= 0) close(*file);
    *file = -1;
  }
  if (child_ < 0) return;
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
  child_ = -1;
}

std::string PeerProcess::ask(const std::string& question, const std::string& word) {
  if (child_ < 0) throw PeerStopped("it was stopped before");
  const std::string line = question + "\n";
  for (std::size_t written = 0; written < line.size();) {
    const ssize_t count = write(to_, line.data() + written, line.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw PeerStopped("it ended");
    written += static_cast<std::size_t>(count);
  }
  try {
    return answer(word);
  } catch (const PeerStopped&) {
    stop();
    throw;
  }
}

std::string PeerProcess::answer(const std::string& word) {
  const std::string wanted = "peer: " + word, failed = "peer: failed ";
  for (;;) {
    const std::string line = next_line();
    if (line.starts_with(failed)) throw PeerStopped(line.substr(failed.size()));
    if (!line.starts_with(wanted)) continue;
    return line.substr(std::min(line.size(), wanted.size() + 1));
  }
}

std::string PeerProcess::next_line() {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(limit_);
  for (;;) {
    if (const std::size_t found = read_.find('\n'); found != std::string::npos) {
      std::string line = read_.substr(0, found);
      read_.erase(0, found + 1);
      return line;
    }
    const std::chrono::duration<double> left = end - std::chrono::steady_clock::now();
    pollfd file{from_, POLLIN, 0};
    const int ready = poll(&file, 1, std::max(0, static_cast<int>(1000.0 * left.count())));
    if (ready < 0 && errno == EINTR) continue;
    if (ready == 0) throw PeerStopped(fmt::format("stopped after {:g} s", limit_));
    std::array<char, 4096> part;
    const ssize_t count = ready < 0 ? -1 : read(from_, part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw PeerStopped("it ended");
    read_.append(part.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace displayfile::bench
