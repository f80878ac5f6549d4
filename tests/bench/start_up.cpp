// What it takes to start: drawing a cube by two builds of the command, in turn.
//   start_up A B [ROUNDS]     the time and the peak memory of B in those of A

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "programs/bench/process.h"
#include "programs/bench/side_by_side.h"
#include "programs/bench/temporary_folder.h"

namespace displayfile::bench {
namespace {

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
      rounds, b, a, spread(wall).median, spread(processor).median, spread(memory).median);
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
