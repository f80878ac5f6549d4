#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "displayfile/looks/style.h"
#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// What is put on a sheet: polygons in the coordinates of who stands before it, x to the right, y
/// up, z toward the viewer.
struct Part {
  Mesh mesh;                               ///< its objects are its closed_pieces
  std::vector<std::uint8_t> is_closed;     ///< of each object
  std::vector<std::uint8_t> side_visible;  ///< of each corner, for the side that ends there
  std::vector<FillStyle> fills;
  std::vector<std::uint32_t> fill_of_face;  ///< in fills
};

/// The polygons that drawing programs draw and the faces of meshes, entered one after another as
/// for a picture: what a program says before a mesh acts on it, and what is invisible is left out.
/// `up` is an axis as --up has it; empty: as the first input says that says one. Throws Error if
/// there are no polygons, and as read_mesh and replay_file do.
Part read_part(std::span<const std::string> inputs, const std::string& up,
               const ImportLimits& limits);

}  // namespace displayfile
