#include "programs/check_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <set>
#include <span>

#include "clip/error.h"
#include "displayfile/text/dump_compare.h"
#include "programs/inputs.h"

namespace displayfile {

namespace {

std::string golden_name(const std::string& input) {
  if (input == "-") throw Error("check needs files: the name of a golden file is its input's");
  return std::filesystem::path(input).stem().string() + ".txt";
}

}  // namespace

CLI::App& CheckCommand::add_to(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "check", "Compare each input's dump with a golden file; exit 1 and the first difference");
  command.add_option("INPUT", inputs, "drawing programs and meshes")->required();
  command.add_option("--golden", golden_folder, "folder of golden dumps, NAME.txt for NAME.draw")
      ->required();
  command.add_flag("--update", update, "write the golden files");
  hidden_surfaces.add_to(command);
  meshes.add_to(command);
  return command;
}

int CheckCommand::run() const {
  const HiddenSurfaceOptions options = hidden_surfaces.options(threads);
  const MeshOptions entering = meshes.options();
  std::set<std::string> names;
  for (const std::string& input : inputs) {
    if (!names.insert(golden_name(input)).second) {
      throw Error(fmt::format("{}: two inputs have the golden file {}", input, golden_name(input)));
    }
  }
  if (update) std::filesystem::create_directories(golden_folder);
  int status = 0;
  for (const std::string& input : inputs) {
    const DisplayFile file = as_drawn(std::span(&input, 1), options, entering);
    const std::string golden = (std::filesystem::path(golden_folder) / golden_name(input)).string();
    if (update) {
      update_golden(file, golden);
    } else if (const auto difference = check_golden(file, golden)) {
      std::cout << input << ": " << *difference << '\n';
      status = 1;
    }
  }
  return status;
}

}  // namespace displayfile
