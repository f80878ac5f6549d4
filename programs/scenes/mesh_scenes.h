#pragma once

#include <array>
#include <string_view>

#include "displayfile/mesh/mesh.h"
#include "programs/scenes/scene.h"

namespace displayfile {

/// The direction from which a mesh is viewed: the rows of the rotation before a parallel view along
/// z.
struct MeshDirection {
  std::string_view name;
  Point3 right, up, toward;
};

/// Along the axes, where many faces of usual models are edge-on or level, and from three corners.
const std::array<MeshDirection, 6>& mesh_directions();

/// All faces of the mesh, front and back, as large as the picture holds from any direction.
Scene mesh_scene(const Mesh& mesh, const MeshDirection& direction);

}  // namespace displayfile
