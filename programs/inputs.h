#pragma once

#include <span>
#include <string>

#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/sorted_display_file.h"

namespace displayfile {

/// True for a drawing program: a file that ends in .draw, in letters of either case, or "-",
/// standard input. Anything else is a mesh.
bool is_drawing_program(const std::string& input);

/// Replays drawing programs and imports meshes, in order, into one system. Meshes that no
/// program before them gave a view get a fitted one, for a picture of this aspect ratio (width
/// over height). Throws Error, naming the file and the place.
void enter_inputs(std::span<const std::string> inputs, GraphicsSystem& system, double aspect = 1.0,
                  const MeshOptions& options = {});

/// The inputs' display file, in the order that is drawn.
DisplayFile as_drawn(std::span<const std::string> inputs, const HiddenSurfaceOptions& options,
                     const MeshOptions& meshes = {});

/// Says on standard error what of each mesh was left out, if anything was, with the file's name.
void report_skipped(std::span<const std::string> meshes, std::span<const Mesh::Skipped> skipped);

}  // namespace displayfile
