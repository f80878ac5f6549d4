#include "displayfile/mesh/skins.h"

#include <assimp/mesh.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <string_view>

#include "clip/point.h"

namespace displayfile {

namespace {

/// The transformations of nodes by name; of nodes with equal names, the first.
using Places = std::map<std::string_view, const glm::dmat4*>;

Point3 placed(const glm::dmat4& m, const aiVector3D& v) {
  return Point3(m * HomogeneousPoint(v.x, v.y, v.z, 1.0));
}

/// The diagonal of the box around the mesh's vertices in the world.
double size_of(const aiMesh& mesh, const glm::dmat4& to_world) {
  if (mesh.mNumVertices == 0) return 0.0;
  Point3 low = placed(to_world, mesh.mVertices[0]), high = low;
  for (const aiVector3D& v : std::span(mesh.mVertices, mesh.mNumVertices)) {
    const Point3 p = placed(to_world, v);
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return glm::distance(low, high);
}

bool moves(const aiBone& bone, const aiMesh& mesh, const glm::dmat4& to_world, const Places& places,
           double most) {
  const auto place = places.find(bone.mName.C_Str());
  if (place == places.end()) return bone.mNumWeights > 0;
  const glm::dmat4 by_bone = *place->second * matrix(bone.mOffsetMatrix);
  return std::ranges::any_of(
      std::span(bone.mWeights, bone.mNumWeights), [&](const aiVertexWeight& weight) {
        if (!(weight.mWeight > 0.0f) || weight.mVertexId >= mesh.mNumVertices) return false;
        const aiVector3D& v = mesh.mVertices[weight.mVertexId];
        return !(glm::distance(placed(by_bone, v), placed(to_world, v)) <= most);
      });
}

bool is_moved(const aiMesh& mesh, const glm::dmat4& to_world, const Places& places) {
  if (mesh.mNumBones == 0) return false;
  constexpr double kLeast = 1e-3;
  const double most = kLeast * size_of(mesh, to_world);
  return std::ranges::any_of(std::span(mesh.mBones, mesh.mNumBones), [&](const aiBone* bone) {
    return moves(*bone, mesh, to_world, places, most);
  });
}

}  // namespace

glm::dmat4 matrix(const aiMatrix4x4& m) {
  glm::dmat4 result(1.0);  // [column][row]
  for (unsigned row = 0; row < 4; ++row) {
    for (unsigned column = 0; column < 4; ++column) {
      result[static_cast<int>(column)][static_cast<int>(row)] = m[row][column];
    }
  }
  return result;
}

std::size_t skins_that_move(const aiScene& scene, std::span<const MeshNode> nodes) {
  Places places;
  for (const MeshNode& node : nodes) places.emplace(node.node->mName.C_Str(), &node.to_world);
  return static_cast<std::size_t>(std::ranges::count_if(nodes, [&](const MeshNode& node) {
    return std::ranges::any_of(
        std::span(node.node->mMeshes, node.node->mNumMeshes), [&](unsigned m) {
          return m < scene.mNumMeshes && is_moved(*scene.mMeshes[m], node.to_world, places);
        });
  }));
}

std::size_t animations_that_move(const aiScene& scene) {
  const auto moves_a_node = [](const aiNodeAnim* channel) {
    return channel->mNumPositionKeys > 1 || channel->mNumRotationKeys > 1 ||
           channel->mNumScalingKeys > 1;
  };
  return static_cast<std::size_t>(std::ranges::count_if(
      std::span(scene.mAnimations, scene.mNumAnimations), [&](const aiAnimation* animation) {
        return animation->mNumMeshChannels > 0 || animation->mNumMorphMeshChannels > 0 ||
               std::ranges::any_of(std::span(animation->mChannels, animation->mNumChannels),
                                   moves_a_node);
      }));
}

}  // namespace displayfile
