#include "programs/inputs.h"

#include <fmt/format.h>

#include <iostream>
#include <string_view>

#include "displayfile/file_extension.h"
#include "displayfile/text/drawing_program.h"
#include "programs/progress.h"

namespace displayfile {

bool is_drawing_program(const std::string& input) {
  return input == "-" || extension_of(input) == ".draw";
}

namespace {

std::string left_out(const Mesh::Skipped& skipped) {
  std::string text;
  const auto add = [&](std::size_t n, std::string_view what) {
    if (n > 0) text += (text.empty() ? "" : ", ") + fmt::format(fmt::runtime(what), n);
  };
  add(skipped.points_and_lines, "{} points and lines");
  add(skipped.degenerate_faces, "{} faces of fewer than 3 positions");
  add(skipped.textured_faces, "the textures of {} faces");
  add(skipped.transparent_faces, "the transparency of {} faces");
  return text;
}

}  // namespace

void report_skipped(std::span<const std::string> meshes, std::span<const Mesh::Skipped> skipped) {
  for (std::size_t i = 0; i < skipped.size(); ++i) {
    if (const std::string text = left_out(skipped[i]); !text.empty()) {
      std::cerr << fmt::format("{}: left out: {}\n", meshes[i], text);
    }
    for (const std::string& warning : skipped[i].warnings) {
      std::cerr << fmt::format("{}: {}\n", meshes[i], warning);
    }
  }
}

void enter_inputs(std::span<const std::string> inputs, GraphicsSystem& system, double aspect,
                  const MeshOptions& options) {
  for (std::size_t i = 0; i < inputs.size();) {
    if (is_drawing_program(inputs[i])) {
      const Progress progress("replaying " + inputs[i]);
      replay_file(inputs[i++], system);
      continue;
    }
    std::size_t end = i;  // meshes that follow each other share a fitted view
    while (end < inputs.size() && !is_drawing_program(inputs[end])) ++end;
    const Progress progress("reading " + inputs[i] + (end - i > 1 ? " and others" : ""));
    const auto meshes = inputs.subspan(i, end - i);
    report_skipped(meshes, import_meshes(meshes, system, aspect, options));
    i = end;
  }
}

/// The inputs' display file, in the order that is drawn.
DisplayFile as_drawn(std::span<const std::string> inputs, const HiddenSurfaceOptions& options,
                     const MeshOptions& meshes) {
  GraphicsSystem system;
  system.set_threads(options.threads);
  enter_inputs(inputs, system, 1.0, meshes);
  return SortedDisplayFile{}.update(system, method_in_force(system, options), options);
}

}  // namespace displayfile
