#pragma once

#include <optional>
#include <span>
#include <string>

#include "clip/base/error.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/sorted_display_file.h"
#include "programs/options/mesh_words.h"

namespace displayfile {

/// True for a drawing program: a file that ends in .draw, in letters of either case, or "-",
/// standard input. Anything else is a mesh.
bool is_drawing_program(const std::string& input);

/// Replays drawing programs and enters meshes, in order, into one system. Where no program before
/// the first mesh sets the window, a view is fitted to all meshes before which none does, and to
/// what programs draw in the same view: it is in force from the start, so that programs before a
/// mesh and after it share it. What programs say of the view before the first mesh stays (fit_view
/// in displayfile/mesh/fitted_view.h). Returns the axis that is up in a camera that was fitted;
/// nothing if none was. Throws Error, naming the file and the place.
std::optional<Upright> enter_inputs(std::span<const std::string> inputs, GraphicsSystem& system,
                                    const MeshOptions& options = {});
/// The same with the command's options, for pictures of an aspect ratio.
std::optional<Upright> enter_inputs(std::span<const std::string> inputs, GraphicsSystem& system,
                                    const MeshWords& meshes, double aspect,
                                    const HiddenSurfaceOptions& asked = {});

/// The inputs' display file, in the order that is drawn, and the colour of all fills by the colour
/// rule.
struct DrawnFile {
  DisplayFile file;
  std::optional<Colour> fills;
};
/// Throws Error for the colour rule without a background.
DrawnFile as_drawn(std::span<const std::string> inputs, const HiddenSurfaceOptions& options,
                   const MeshWords& meshes, double aspect);

/// Calls enter(), which enters a mesh. One that is read well may still be refused, by what else was
/// set: then its name is told too.
template <class Enter>
void naming_mesh(const std::string& mesh, Enter&& enter) {
  try {
    enter();
  } catch (const Error& error) {
    throw Error(mesh + ": " + error.what());
  }
}

/// Warns of what of each mesh was left out, if anything was, with the file's name
/// (programs/process/warnings.h).
void report_skipped(std::span<const std::string> meshes, std::span<const Mesh::Skipped> skipped);

}  // namespace displayfile
