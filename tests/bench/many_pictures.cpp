// Many pictures in one call of the command, against one call each, in turn.
//   many_pictures COMMAND MESH... [--pictures N] [--size WxH] [--rounds N] [--threads N]

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "clip/error.h"
#include "programs/bench/process.h"
#include "programs/bench/side_by_side.h"
#include "programs/bench/temporary_folder.h"

namespace displayfile::bench {
namespace {

struct Work {
  std::string command;
  std::vector<std::string> meshes;
  std::size_t pictures = 300;
  std::string size = "128x128";
  std::vector<std::string> threads;  // as options of the command
  int rounds = 5;
};

/// The arguments that draw these inputs into names that may have fields.
std::vector<std::string> drawing(const Work& work, std::vector<std::string> inputs,
                                 const std::string& output) {
  std::vector<std::string> arguments{work.command, "draw"};
  arguments.insert(arguments.end(), inputs.begin(), inputs.end());
  arguments.insert(arguments.end(), {"-o", output, "--size", work.size});
  arguments.insert(arguments.end(), work.threads.begin(), work.threads.end());
  return arguments;
}

/// As many inputs as there are to be pictures, the meshes that can be drawn in turn.
std::vector<std::string> inputs_of(const Work& work, const TemporaryFolder& folder) {
  std::vector<std::string> drawable, inputs;
  for (const std::string& mesh : work.meshes) {
    if (run(drawing(work, {mesh}, folder.file("first.png"))).succeeded) drawable.push_back(mesh);
  }
  if (drawable.empty()) throw Error("none of the meshes can be drawn");
  fmt::print("{} meshes, {} more cannot be drawn\n", drawable.size(),
             work.meshes.size() - drawable.size());
  for (std::size_t k = 0; k < work.pictures; ++k) inputs.push_back(drawable[k % drawable.size()]);
  return inputs;
}

std::string content(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void compare(const Work& work) {
  const TemporaryFolder folder;
  const std::vector<std::string> inputs = inputs_of(work, folder);
  const auto by_itself = [&](std::size_t k) { return folder.file(fmt::format("each-{}.png", k)); };
  std::vector<double> wall, processor;
  for (int round = 0; round < work.rounds; ++round) {
    const Cost together = cost_of(drawing(work, inputs, folder.file("one-{number}.png")));
    Cost each{};
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const Cost one = cost_of(drawing(work, {inputs[k]}, by_itself(k)));
      each.wall += one.wall;
      each.processor += one.processor;
    }
    wall.push_back(each.wall / together.wall);
    processor.push_back(each.processor / together.processor);
  }
  std::size_t same = 0;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const std::string name = fmt::format("one-{:0{}}.png", k, inputs.size() > 1000 ? 4 : 3);
    same += content(folder.file(name)) == content(by_itself(k)) ? 1 : 0;
  }
  const auto row = [](const char* what, const std::vector<double>& ratios) {
    fmt::print("  time, {:<10} {:.2f}  ({:.2f} to {:.2f})\n", what, spread(ratios).median,
               std::ranges::min(ratios), std::ranges::max(ratios));
  };
  fmt::print("{} pictures of {}, one call each in those of one call, median of {} rounds:\n",
             inputs.size(), work.size, work.rounds);
  row("wall", wall);
  row("processor", processor);
  fmt::print("  the same pictures: {} of {}\n", same, inputs.size());
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  displayfile::bench::Work work;
  std::string threads;
  CLI::App app("Many pictures in one call of the command, against one call each.", "many_pictures");
  app.add_option("COMMAND", work.command, "displayfile, as built")->required();
  app.add_option("MESH", work.meshes, "drawn in turn; those that cannot be are left out")
      ->required();
  app.add_option("--pictures", work.pictures)->check(CLI::Range(1, 9999))->capture_default_str();
  app.add_option("--size", work.size)->capture_default_str();
  app.add_option("--rounds", work.rounds)->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--threads", threads, "of both; all processors unless said otherwise");
  CLI11_PARSE(app, argc, argv);
  if (!threads.empty()) work.threads = {"--threads", threads};
  try {
    displayfile::bench::compare(work);
  } catch (const std::exception& error) {
    fmt::print(stderr, "many_pictures: {}\n", error.what());
    return 2;
  }
}
