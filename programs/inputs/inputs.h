#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/fitted_view.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/sorted_display_file.h"
#include "programs/options/mesh_words.h"

namespace displayfile {

/// True for a drawing program: a file that ends in .draw, in letters of either case, or "-",
/// standard input. Anything else is a mesh.
bool is_drawing_program(const std::string& input);

/// Replays drawing programs and enters meshes, in order, into one system. If no program before the
/// first mesh sets the window, a view is fitted to all meshes without a preceding program that sets
/// it, and to the programs' drawings in the same view: it is in force from the start, so that
/// programs before and after a mesh share it. View settings of programs before the first mesh are
/// kept (fit_view in displayfile/mesh/fitted_view.h). Returns the up axis of a fitted camera;
/// nothing if none was fitted. Throws Error, naming the file and the position.
std::optional<Upright> enter_inputs(std::span<const std::string> inputs, GraphicsSystem& system,
                                    const MeshOptions& options = {});
/// The same with the command's options, for pictures of an aspect ratio.
std::optional<Upright> enter_inputs(std::span<const std::string> inputs, GraphicsSystem& system,
                                    const MeshWords& meshes, double aspect,
                                    const HiddenSurfaceOptions& asked = {});

/// A view fitted to the meshes of several pictures together, as enter_inputs fits one to those of
/// each.
struct ViewOfAll {
  CameraAsSet before;  ///< by the programs before the first mesh of each picture
  View view;
  Upright upright;
};
/// Reads all inputs for that; `start` makes the settings of the options in a new system. Inputs
/// that cannot be read are left out: an Error is thrown when they are entered. Throws Error for
/// standard input, which cannot be read twice; if there is no mesh that a view is fitted to; and as
/// fit_view.
std::shared_ptr<const ViewOfAll> fit_to_all(std::span<const std::vector<std::string>> pictures,
                                            const MeshOptions& options,
                                            const std::function<void(GraphicsSystem&)>& start);

/// The inputs' display file, in the order that is drawn, and the colour of all fills by the colour
/// rule.
struct DrawnFile {
  DisplayFile file;
  std::optional<Colour> fills;
};
/// Throws Error for the colour rule without a background.
DrawnFile as_drawn(std::span<const std::string> inputs, const HiddenSurfaceOptions& options,
                   const MeshWords& meshes, double aspect);

/// Calls enter(), which enters a mesh. A valid mesh may still be refused because of other settings:
/// then the message gets its name.
template <class Enter>
void naming_mesh(const std::string& mesh, Enter&& enter) {
  try {
    enter();
  } catch (const Error& error) {
    throw Error(mesh + ": " + error.what());
  }
}

/// Warns of skipped contents of each mesh, with the file's name (programs/process/warnings.h).
void report_skipped(std::span<const std::string> meshes, std::span<const Mesh::Skipped> skipped);

}  // namespace displayfile
