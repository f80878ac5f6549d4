#include "programs/command/page_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "clip/base/collected_text.h"
#include "clip/base/error.h"
#include "clip/base/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/text/output_file.h"
#include "interp/draw/draw.h"
#include "programs/inputs/input_names.h"
#include "programs/inputs/inputs.h"
#include "programs/inputs/output_paths.h"
#include "programs/options/option_groups.h"
#include "programs/options/title_words.h"
#include "programs/process/progress.h"
#include "programs/process/version.h"

namespace displayfile {

using nlohmann::ordered_json;

namespace {

std::string text_of(const ordered_json& data) {
  return data.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

ordered_json scene_data(const std::string& name, const std::string& program) {
  return {{"name", name}, {"program", program}};
}

}  // namespace

CLI::App& PageCommand::add_to(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "page", "Write a scene as an interactive page in one file: rotate, pick, save");
  add_inputs(
      command, "INPUT", inputs,
      "drawing programs and meshes of the scene; by default the project's page, with the gallery")
      .required(false);
  command.add_option("-o,--output", output, "the page")
      ->type_name("OUT.html")
      ->required()
      ->group(kOutputOptions);
  command.add_option("--title", title, "title of the page; by default the first input's name")
      ->type_name("TEXT")
      ->group(kOutputOptions);
  command
      .add_option("--package", package, "folder of the WebAssembly package, if it is not installed")
      ->type_name("FOLDER")
      ->group(kOutputOptions);
  size.add_to(command);
  shading.add_to(command);
  hidden_surfaces.add_to(command);
  meshes.add_to(command);
  return command;
}

PageContents PageCommand::product(ordered_json data, const PageFiles& files) const {
  for (const auto& program : files.gallery()) {
    data["scenes"].push_back(
        scene_data(program.filename().string(), read_text_file(program.string())));
  }
  // The page fills it with the steps of the scene that is shown.
  data["stepsPage"] = one_file_page(files, "steps.html", {"", "{}"});
  return {title, text_of(data)};
}

PageContents PageCommand::scene(ordered_json data, DrawOptions options) const {
  GraphicsSystem system;
  CollectedText program;
  Recorder recorder(program);
  system.set_recorder(&recorder);
  starting_shading().start(system);
  if (const auto lines = hidden_surfaces.line_selection())
    system.set_hidden_surfaces({.lines = *lines});
  if (hidden_surfaces.touching) {
    system.set_hidden_surfaces({.touching = *hidden_surfaces.touching});
  }
  enter_inputs(inputs, system, meshes, size.aspect(), options.surfaces);
  const std::string name = std::filesystem::path(input_name(inputs.front())).filename().string();
  data["scenes"].push_back(scene_data(name, program.str()));
  const HiddenSurfaceOptions& set = options.surfaces;
  if (set.method) data["method"] = name_of(*set.method);
  if (set.precision) data["precision"] = word_of(*set.precision);
  if (set.scope) data["scope"] = name_of(*set.scope);
  if (set.hidden_lines) data["hiddenLines"] = name_of(*set.hidden_lines);
  Progress progress("drawing " + output);
  options.surfaces.progress = progress.told();
  return {title_or_name(title, name), text_of(data), draw_as(system, "svg", options)};
}

StartingShading PageCommand::starting_shading() const {
  const bool has_meshes = !std::ranges::all_of(inputs, is_drawing_program);
  return shading.starting(has_meshes, std::ranges::any_of(inputs, is_drawing_program));
}

DrawOptions PageCommand::drawing() const {
  DrawOptions drawing;
  size.read(drawing.width, drawing.height);
  drawing.surfaces = hidden_surfaces.options();
  if (!drawing.surfaces.method && std::ranges::none_of(inputs, is_drawing_program)) {
    drawing.surfaces.method = HiddenMethod::automatic;  // as `draw` draws bare meshes
  }
  return drawing;
}

int PageCommand::run() {
  require_drawable("--title", title);
  const std::vector<std::string> lists = input_lists(inputs);
  inputs = input_names(inputs);
  require_extension(output, ".html", "a page");
  require_files_of_their_own({output}, inputs, lists);
  starting_shading();
  const PageFiles files(package);
  const DrawOptions options = drawing();
  const bool is_product = inputs.empty();
  const std::string wasm = is_product ? "displayfile-module.wasm" : "displayfile-viewer.wasm";
  const ordered_json data{{"version", version_number()},
                          {"width", options.width},
                          {"height", options.height},
                          {"wasm", files.text(wasm + ".lzma.base64")}};
  OutputFile file(output);
  const PageContents page = is_product ? product(data, files) : scene(data, options);
  file.stream() << one_file_page(files, is_product ? "index.html" : "viewer.html", page);
  file.commit();
  return 0;
}

}  // namespace displayfile
