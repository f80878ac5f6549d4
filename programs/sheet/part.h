#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "displayfile/entered/kept_annotation.h"
#include "displayfile/looks/style.h"
#include "displayfile/mesh/mesh.h"
#include "programs/sheet/turned_shape.h"

namespace displayfile {

/// One of the parts that are drawn together: an object of a mesh, or a segment of a drawing
/// program.
struct NamedPart {
  std::string input;  ///< its file's name without folder and extension
  std::string name;   ///< the same if it is the only part of the input
};

/// The part drawn on a sheet: polygons in the coordinates of a viewer in front of it, x to the
/// right, y up, z toward the viewer.
struct Part {
  Mesh mesh;                               ///< its objects are its closed_pieces
  std::vector<std::uint8_t> is_closed;     ///< of each object
  std::vector<std::uint8_t> side_visible;  ///< of each corner, for the side that ends there
  std::vector<FillStyle> fills;
  std::vector<std::uint32_t> fill_of_face;  ///< in fills
  std::vector<NamedPart> parts;             ///< in order of entry
  std::vector<std::uint32_t> part_of;       ///< of each object, in parts
  std::vector<CentreAxis> axes;             ///< of shapes made by turning routines
  std::vector<KeptAnnotation> annotations;  ///< of drawing programs, in order of entry
};

/// The polygons of drawing programs and the faces of meshes, entered in order as for a picture:
/// settings of a program apply to later meshes, and invisible parts are omitted. `up` is an axis as
/// in --up; if empty, the axis of the first input that states one. Throws Error if there are no
/// polygons, and as read_mesh and replay_file do.
Part read_part(std::span<const std::string> inputs, const std::string& up,
               const ImportLimits& limits);

}  // namespace displayfile
