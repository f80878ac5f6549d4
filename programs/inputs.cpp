#include "programs/inputs.h"

#include <fmt/format.h>

#include <iostream>

#include "displayfile/file_extension.h"
#include "displayfile/text/drawing_program.h"
#include "programs/progress.h"

namespace displayfile {

bool is_drawing_program(const std::string& input) {
  return input == "-" || extension_of(input) == ".draw";
}

void report_skipped(const Mesh::Skipped& skipped) {
  if (skipped.points_and_lines + skipped.degenerate_faces == 0) return;
  std::cerr << fmt::format("left out: {} points and lines, {} faces of fewer than 3 positions\n",
                           skipped.points_and_lines, skipped.degenerate_faces);
}

void enter_inputs(std::span<const std::string> inputs, GraphicsSystem& system, double aspect) {
  for (std::size_t i = 0; i < inputs.size();) {
    if (is_drawing_program(inputs[i])) {
      const Progress progress("replaying " + inputs[i]);
      replay_file(inputs[i++], system);
      continue;
    }
    std::size_t end = i;  // meshes that follow each other share a fitted view
    while (end < inputs.size() && !is_drawing_program(inputs[end])) ++end;
    const Progress progress("reading " + inputs[i] + (end - i > 1 ? " and others" : ""));
    report_skipped(import_meshes(inputs.subspan(i, end - i), system, aspect));
    i = end;
  }
}

/// The inputs' display file, in the order that is drawn.
DisplayFile as_drawn(std::span<const std::string> inputs, const HiddenSurfaceOptions& options) {
  GraphicsSystem system;
  system.set_threads(options.threads);
  enter_inputs(inputs, system);
  return SortedDisplayFile{}.update(system, method_in_force(system, options), options);
}

}  // namespace displayfile
