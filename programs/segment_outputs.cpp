#include "programs/segment_outputs.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <set>
#include <span>

#include "clip/error.h"
#include "displayfile/output_file.h"
#include "displayfile/text/dump.h"
#include "displayfile/text/dump_compare.h"
#include "hidden/exact/precision.h"
#include "programs/inputs.h"

namespace displayfile {

namespace {

std::string golden_name(const std::string& input) {
  if (input == "-") throw Error("check needs files: the name of a golden file is its input's");
  return std::filesystem::path(input).stem().string() + ".txt";
}

/// The inputs' display file, in the order that is drawn.
DisplayFile as_drawn(std::span<const std::string> inputs, const HiddenSurfaceOptions& options) {
  GraphicsSystem system;
  system.set_threads(options.threads);
  enter_inputs(inputs, system);
  return SortedDisplayFile{}.update(system, method_in_force(system, options), options);
}

}  // namespace

void HiddenSurfaceWords::add_to(CLI::App& command) {
  std::string methods;
  for (const auto& entry : hidden_methods()) {
    if (entry.available) methods += " " + std::string(entry.name);
  }
  command.add_option("--hidden", hidden,
                     "hidden-surface method in place of the program's:" + methods);
  command.add_option("--scope", scope,
                     "sort each segment, or all visible ones together: segment all");
  command.add_option("--precision", precision,
                     "exact, roundoff or roundoff=EPS; exact unless a program sets another");
}

HiddenSurfaceOptions HiddenSurfaceWords::options(int threads) const {
  HiddenSurfaceOptions read;
  read.threads = threads;
  if (!hidden.empty()) read.method = hidden_method(hidden);
  if (!scope.empty()) read.scope = hidden_scope(scope);
  if (!precision.empty()) read.precision = displayfile::precision(precision);
  return read;
}

CLI::App& DumpCommand::add_to(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("dump", "Every segment's instructions, as canonical text");
  command.add_option("INPUT", inputs, "drawing programs and meshes")->required();
  command.add_option("-o,--output", output, "file to write; standard output if not given");
  hidden_surfaces.add_to(command);
  return command;
}

int DumpCommand::run() const {
  const DisplayFile file = as_drawn(inputs, hidden_surfaces.options(threads));
  if (output.empty()) {
    dump(file, std::cout);
    std::cout.flush();
    if (!std::cout) throw Error("standard output cannot be written");
    return 0;
  }
  OutputFile written(output);
  dump(file, written.stream());
  written.commit();
  return 0;
}

CLI::App& CheckCommand::add_to(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "check", "Compare each input's dump with a golden file; exit 1 and the first difference");
  command.add_option("INPUT", inputs, "drawing programs and meshes")->required();
  command.add_option("--golden", golden_folder, "folder of golden dumps, NAME.txt for NAME.draw")
      ->required();
  command.add_flag("--update", update, "write the golden files");
  hidden_surfaces.add_to(command);
  return command;
}

int CheckCommand::run() const {
  const HiddenSurfaceOptions options = hidden_surfaces.options(threads);
  std::set<std::string> names;
  for (const std::string& input : inputs) {
    if (!names.insert(golden_name(input)).second) {
      throw Error(fmt::format("{}: two inputs have the golden file {}", input, golden_name(input)));
    }
  }
  if (update) std::filesystem::create_directories(golden_folder);
  int status = 0;
  for (const std::string& input : inputs) {
    const DisplayFile file = as_drawn(std::span(&input, 1), options);
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
