// What it takes to start: drawing a cube by two builds of the command, in turn.
//   start_up A B [ROUNDS]     the time and the peak memory of B in those of A

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "clip/error.h"
#include "tests/bench/process.h"

namespace displayfile::bench {
namespace {

/// The cost of a whole process. The memory is at least this program's own, which is small.
struct Cost {
  double wall, processor;  // seconds
  double peak_memory;      // bytes
};

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

Cost cost_of(std::vector<std::string> arguments) {
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const auto begun = std::chrono::steady_clock::now();
  pid_t child = 0;
  int status = 0;
  rusage used{};
  if (posix_spawn(&child, argv[0], nullptr, nullptr, argv.data(), environ) != 0 ||
      wait4(child, &status, 0, &used) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw Error(arguments[0] + " failed");
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begun;
  return {wall.count(), seconds(used.ru_utime) + seconds(used.ru_stime),
          1024.0 * static_cast<double>(used.ru_maxrss)};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

void compare(const std::string& a, const std::string& b, int rounds) {
  const TemporaryFolder folder;
  const auto draw = [&](const std::string& command) {
    return cost_of({command, "draw", DISPLAYFILE_CUBE, "-o", folder.file("cube.png")});
  };
  std::vector<double> wall, processor, memory;
  for (int round = 0; round < rounds; ++round) {
    const Cost first = draw(a), second = draw(b);
    wall.push_back(second.wall / first.wall);
    processor.push_back(second.processor / first.processor);
    memory.push_back(second.peak_memory / first.peak_memory);
  }
  fmt::print(
      "drawing a cube, medians of {} rounds, {} in those of {}:\n"
      "  time, wall       {:.3f}\n"
      "  time, processor  {:.3f}\n"
      "  peak memory      {:.3f}\n",
      rounds, b, a, median(wall), median(processor), median(memory));
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  const int rounds = argc == 4 ? std::atoi(argv[3]) : 51;
  if (argc < 3 || argc > 4 || rounds < 1) {
    fmt::print(stderr, "usage: start_up COMMAND-A COMMAND-B [ROUNDS]\n");
    return 2;
  }
  try {
    displayfile::bench::compare(argv[1], argv[2], rounds);
  } catch (const std::exception& error) {
    fmt::print(stderr, "start_up: {}\n", error.what());
    return 2;
  }
}
