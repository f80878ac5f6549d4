#include "programs/truth_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "displayfile/output_file.h"
#include "interp/files/npy_file.h"
#include "interp/truth/truth.h"
#include "programs/inputs.h"
#include "programs/progress.h"

namespace displayfile {

CLI::App& TruthCommand::add_to(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "truth", "What is seen at each pixel, by exact arithmetic alone, whatever the methods do");
  command.add_option("INPUT", inputs, "drawing programs and meshes")->required();
  size.add_to(command);
  meshes.add_to(command);
  command.add_option("--ids", ids, "item buffer as .npy: the pick identifier seen, -1 for none")
      ->required();
  command.add_option("--depth", depth,
                     "depth as .npy: of the fill seen, rounded once, -inf for none");
  return command;
}

int TruthCommand::run() const {
  int width = 0, height = 0;
  size.read(width, height);
  GraphicsSystem system;
  enter_inputs(inputs, system, meshes, size.aspect());
  // Every output must be writable before the long work, and any is written.
  OutputFile{ids};
  if (!depth.empty()) OutputFile{depth};
  Picture picture;
  {
    Progress progress(fmt::format("the truth of {} polygons", system.display_file().polygons()));
    picture =
        truth(system.display_file(), width, height, !depth.empty(),
              [&](std::size_t done, std::size_t polygons) { progress.update(done, polygons); });
  }
  write_npy(picture.ids, width, height, ids);
  if (!depth.empty()) write_npy(picture.depth, width, height, depth);
  return 0;
}

}  // namespace displayfile
