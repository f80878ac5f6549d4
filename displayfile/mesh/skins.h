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

/// Converts the library's matrix, with the same rows.
glm::dmat4 matrix(const aiMatrix4x4& m);

/// The number of nodes with meshes that a skin would move: whose bones, in the scene's pose, put a
/// vertex elsewhere than the mesh's node does, by more than 1/1000 of the mesh's size. Skins are
/// not read.
std::size_t skins_that_move(const aiScene& scene, std::span<const MeshNode> nodes);

/// The number of animations with more than one place of a node, or with meshes that change. Some of
/// the library's readers make one of a single place where a file has none.
std::size_t animations_that_move(const aiScene& scene);

}  // namespace displayfile
