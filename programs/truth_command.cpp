#include "programs/truth_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iostream>
#include <string_view>
#include <utility>

#include "clip/error.h"
#include "clip/nearest_word.h"
#include "displayfile/output_file.h"
#include "displayfile/retained_scene.h"
#include "interp/files/npy_file.h"
#include "interp/truth/truth.h"
#include "interp/truth/world_truth.h"
#include "programs/input_names.h"
#include "programs/inputs.h"
#include "programs/progress.h"

namespace displayfile {

CLI::App& TruthCommand::add_to(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "truth", "What is seen at each pixel, by exact arithmetic alone, whatever the methods do");
  add_inputs(command, "INPUT", inputs, "drawing programs and meshes");
  size.add_to(command);
  meshes.add_to(command);
  command.add_option("--ids", ids, "item buffer as .npy: the pick identifier seen, -1 for none");
  command.add_option("--depth", depth,
                     "depth as .npy: of the fill seen, rounded once, -inf for none");
  command.add_option("--from", from,
                     "display-file, whose coordinates viewing has rounded; or world: viewing in "
                     "exact arithmetic too, and how many pixels of the former differ from it");
  return command;
}

int TruthCommand::run() const {
  const bool from_world = is_from_world();
  if (ids.empty() && !from_world) {
    throw Error("truth: --ids is required: expected a file for the item buffer");
  }
  int width = 0, height = 0;
  size.read(width, height);
  RetainedScene retained;
  GraphicsSystem system;
  if (from_world) system.retain(&retained);
  enter_inputs(inputs, system, meshes, size.aspect());
  // Every output must be writable before the long work, and any is written.
  for (const std::string& output : {ids, depth}) {
    if (!output.empty()) OutputFile{output};
  }
  const DisplayFile& file = system.display_file();
  const auto with_progress = [&](const char* what, auto&& judge) {
    Progress progress(fmt::format("the truth of {} {}polygons", file.polygons(), what));
    return judge([&](std::size_t done, std::size_t polygons) { progress.update(done, polygons); });
  };
  Picture picture = with_progress("", [&](const WorkProgress& progress) {
    return truth(file, width, height, !depth.empty() && !from_world, progress);
  });
  std::string report;
  if (from_world) {
    Picture of_world = with_progress("world ", [&](const WorkProgress& progress) {
      return world_truth(retained, file, width, height, !depth.empty(), progress);
    });
    report = fmt::format("{} of {} pixels differ: there the rounding of viewing decides\n",
                         different_pixels(picture, of_world), picture.ids.size());
    picture = std::move(of_world);
  }
  if (!ids.empty()) write_npy(picture.ids, width, height, ids);
  if (!depth.empty()) write_npy(picture.depth, width, height, depth);
  std::cout << report;
  return 0;
}

bool TruthCommand::is_from_world() const {
  constexpr std::array<std::string_view, 2> kWords{"display-file", "world"};
  if (std::ranges::find(kWords, from) == kWords.end()) {
    throw Error(fmt::format("--from {}:{} expected display-file or world", from,
                            did_you_mean(from, kWords)));
  }
  return from == "world";
}

}  // namespace displayfile
