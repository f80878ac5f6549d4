#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "clip/point.h"
#include "displayfile/mesh/gltf_accessors.h"
#include "displayfile/mesh/mesh_file.h"

namespace displayfile {

/// A primitive of a glTF mesh: triangles of one material.
struct GltfPart {
  std::vector<Point3> positions, normals;  ///< no normals if there are none or none are wanted
  std::vector<Rgba> colours;               ///< parts of 1; none if there are none
  std::vector<std::uint32_t> corners;      ///< three a triangle
  std::size_t points_and_lines = 0;        ///< in the place of triangles
  double rounding = 0.0;                   ///< of its coordinates, for which 1 is 1
};

/// Reads a primitive, with its morph targets at these weights. Throws Error as GltfAccessors does,
/// and if an index is out of range or the mode is unknown.
GltfPart read_gltf_part(const Json& primitive, std::span<const double> weights, bool with_normals,
                        GltfAccessors& accessors);

/// Moves each vertex by the joints that have weights for it, which sum to 1. `joints` are the
/// transformations from the mesh to the world. False if the primitive has no weights: then the part
/// is as it was.
bool move_by_skin(const Json& primitive, std::span<const glm::dmat4> joints,
                  GltfAccessors& accessors, GltfPart& part);

/// Transforms positions and normals; the corners of a transformation that mirrors are turned round.
void move_part(const glm::dmat4& to_world, GltfPart& part);

}  // namespace displayfile
