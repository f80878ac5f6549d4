#include "programs/command/dump_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "displayfile/files.h"
#include "displayfile/text/output_file.h"
#include "interp/draw/draw.h"
#include "programs/inputs/input_names.h"
#include "programs/inputs/inputs.h"
#include "programs/inputs/output_paths.h"

namespace displayfile {

CLI::App& DumpCommand::add_to(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("dump", "Print every segment's instructions as canonical text");
  add_inputs(command, "INPUT", inputs, "drawing programs and meshes");
  command.add_option("-o,--output", output, "output file; standard output by default")
      ->type_name("OUT.txt");
  hidden_surfaces.add_to(command, LineWords::Takes::styles);
  size.add_to(command);
  meshes.add_to(command);
  return command;
}

int DumpCommand::run() {
  const std::vector<std::string> lists = input_lists(inputs);
  inputs = input_names(inputs);
  require_files_of_their_own({output}, inputs, lists);
  if (std::ranges::find(picture_formats(), extension_of(output), &Choice::name) !=
      picture_formats().end()) {
    throw Error(fmt::format(
        "{}: dump writes text: expected a name that ends in .txt; displayfile draw writes pictures",
        output));
  }
  MeshWords entering = meshes;
  if (const auto& lines = hidden_surfaces.lines) {
    entering.lines = lines->selection();
    entering.line_styles = lines->styles({});
  }
  entering.touching = hidden_surfaces.touching;
  const DrawnFile drawn = as_drawn(inputs, hidden_surfaces.options(), entering, size.aspect());
  if (output.empty()) {
    dump(drawn.file, std::cout, drawn.fills);
    return 0;
  }
  OutputFile written(output);
  dump(drawn.file, written.stream(), drawn.fills);
  written.commit();
  return 0;
}

}  // namespace displayfile
