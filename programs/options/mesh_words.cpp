#include "programs/options/mesh_words.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "clip/base/error.h"
#include "displayfile/looks/colour_words.h"
#include "displayfile/user_routines/system_inside.h"
#include "programs/options/colour_word.h"
#include "programs/options/option_groups.h"

namespace displayfile {

void MeshWords::add_to(CLI::App& command, bool many) {
  CameraWords::add_to(command, {.many = many});
  import.add_to(command);
  command
      .add_option("--colour", colour,
                  "colour of all mesh faces, overriding files and a program's fill style: R,G,B, "
                  "each 0 to 1, #rrggbb or a CSS name")
      ->type_name("R,G,B|#rrggbb|white|black")
      ->group(kPictureOptions);
}

MeshOptions MeshWords::options() const {
  MeshOptions options{.camera = camera(), .import_limits = import.limits()};
  if (colour.empty()) return options;
  options.colour = colour_of(colour);
  if (!options.colour) {
    throw Error(fmt::format(
        "--colour {}:{} expected red, green and blue, each 0 to 1, such as 0.8,0.2,0.1; #rrggbb or "
        "a CSS name",
        colour, nearest_colour_name(colour)));
  }
  return options;
}

void MeshWords::start(GraphicsSystem& system, double aspect) const {
  CameraWords::start(system, aspect);
  if (scale) SystemInside::set_scale(system, scale);
  if (lines) SystemInside::replace_lines(system, *lines);
  if (line_width) SystemInside::replace_line_width(system, *line_width);
  for (const auto& [kind, style] : line_styles) {
    SystemInside::replace_line_kind_style(system, kind, style);
  }
  if (touching) SystemInside::replace_touching(system, *touching);
  // Lines are selected from the retained scene, also after a program's segments.
  if (lines_of_meshes) system.retain();
}

}  // namespace displayfile
