#include "programs/command/steps_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "clip/surfaces.h"
#include "displayfile/graphics_system.h"
#include "displayfile/text/output_file.h"
#include "interp/steps/steps.h"
#include "programs/inputs/input_names.h"
#include "programs/inputs/inputs.h"
#include "programs/inputs/output_paths.h"
#include "programs/options/hidden_surface_words.h"
#include "programs/options/number_in.h"
#include "programs/options/option_groups.h"
#include "programs/options/title_words.h"
#include "programs/page/one_file_page.h"
#include "programs/process/progress.h"

namespace displayfile {

CLI::App& StepsCommand::add_to(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "steps", "Write a page that shows the steps of a hidden-surface algorithm");
  add_inputs(command, "INPUT", inputs, "drawing programs and meshes");
  command.add_option("-o,--output", output, "the page (.html), or its data (.json)")
      ->type_name("OUT.{html,json}")
      ->required()
      ->group(kOutputOptions);
  command.add_option("--title", title, "title of the page; by default the first input's name")
      ->type_name("TEXT")
      ->group(kOutputOptions);
  std::string methods;
  for (const HiddenMethod method : methods_with_steps())
    methods.append(" ").append(name_of(method));
  std::string forms;
  for (const HiddenMethod form : plain_forms_with_steps())
    forms.append(forms.empty() ? "" : " ").append(name_of(form));
  command
      .add_option(
          "--hidden", hidden,
          fmt::format("the algorithm:{}; or the plain form that is shown: {}", methods, forms))
      ->type_name("STEPPED-METHOD")
      ->required()
      ->group(kHiddenSurfaceOptions);
  size.add_to(command);
  command.add_option("--limit-steps", most_steps, "maximum number of steps")
      ->type_name("N")
      ->transform(any_number<std::size_t>())
      ->capture_default_str()
      ->group(kLimitOptions);
  meshes.add_to(command);
  return command;
}

int StepsCommand::run() {
  const std::vector<std::string> lists = input_lists(inputs);
  inputs = input_names(inputs);
  const bool is_page = extension_of(output) == ".html";
  if (!is_page && extension_of(output) != ".json") {
    throw Error(fmt::format("{}: expected a file that ends in .html or .json", output));
  }
  require_files_of_their_own({output}, inputs, lists);
  StepsOptions options;
  std::vector<HiddenMethod> methods = methods_with_steps();
  std::ranges::copy(plain_forms_with_steps(), std::back_inserter(methods));
  options.method = method_among(hidden, methods, "has no steps");
  options.most_steps = most_steps;
  size.read(options.width, options.height);
  const PageFiles files;
  OutputFile file(output);
  GraphicsSystem system;
  // Methods of lines draw the sides of bare meshes.
  HiddenSurfaceOptions surfaces;
  if (finds_lines(options.method)) surfaces.method = options.method;
  enter_inputs(inputs, system, meshes, size.aspect(), surfaces);
  const Progress progress(fmt::format("the steps of {}", hidden));
  std::string text = steps_as_json(system, options);
  if (is_page) {
    const std::string name = std::filesystem::path(inputs.front()).filename().string();
    text = one_file_page(files, "steps.html", {title_or_name(title, name), text});
  }
  file.stream() << text;
  file.commit();
  return 0;
}

}  // namespace displayfile
