#include "programs/command/import_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "clip/base/error.h"
#include "displayfile/graphics_system.h"
#include "displayfile/text/output_file.h"
#include "programs/inputs/input_names.h"
#include "programs/inputs/inputs.h"
#include "programs/inputs/output_paths.h"
#include "programs/options/hidden_surface_words.h"
#include "programs/process/progress.h"
#include "programs/process/warnings.h"

namespace displayfile {

CLI::App& ImportCommand::add_to(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("import", "Write a drawing program from meshes");
  add_inputs(command, "MESH", meshes, "meshes").type_name("MESH");
  command.add_option("-o,--output", output, "the drawing program, .draw")
      ->type_name("OUT.draw")
      ->required();
  shading.add_to(command);
  size.add_to(command);
  options.add_to(command);
  add_touching_option(command, touching);
  return command;
}

int ImportCommand::run() {
  const std::vector<std::string> lists = input_lists(meshes);
  meshes = input_names(meshes);
  require_extension(output, ".draw", "a drawing program");
  require_files_of_their_own({output}, meshes, lists);
  const StartingShading start_with = shading.starting(true, false);
  const MeshOptions entering = options.options();
  const double aspect = size.aspect();
  OutputFile file(output);
  GraphicsSystem system;
  Recorder recorder(file.stream());
  system.set_recorder(&recorder);
  for (const std::string& mesh : meshes) {
    if (is_drawing_program(mesh)) throw Error(mesh + " is a drawing program: expected a mesh");
  }
  options.start(system, aspect);
  system.set_window_fit(WindowFit::widen);  // whatever the size that it will be drawn in
  start_with.start(system);
  if (touching) system.set_hidden_surfaces({.touching = *touching});
  const Progress progress("importing " + meshes.front());
  std::vector<Mesh::Skipped> skipped;
  {
    const NamedWarnings named(fmt::format("{}", fmt::join(meshes, ", ")));
    skipped = import_meshes(meshes, system, entering).skipped;
  }
  file.commit();
  report_skipped(meshes, skipped);
  return 0;
}

}  // namespace displayfile
