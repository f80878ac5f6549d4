#pragma once

#include <assimp/scene.h>

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <span>

namespace displayfile {

/// A node of the import library's scene.
struct MeshNode {
  const aiNode* node;
  glm::dmat4 to_world;
};

/// The library's matrix, whose rows are this one's.
glm::dmat4 matrix(const aiMatrix4x4& m);

/// How many nodes have meshes that a skin would move: one whose bones, where the scene has them,
/// put a vertex elsewhere than the mesh's node does, by more than a thousandth of the mesh's size.
/// Skins are not read.
std::size_t skins_that_move(const aiScene& scene, std::span<const MeshNode> nodes);

}  // namespace displayfile
