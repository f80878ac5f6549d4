#include "displayfile/mesh/gltf_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/mat3x3.hpp>

#include "clip/base/error.h"

namespace displayfile {

namespace {

const Json& nodes_of(const Json& file) { return array_in(file, "nodes"); }

/// A node's transformation to its parent.
glm::dmat4 local(const Json& node) {
  if (!member(node, "matrix").is_null()) {
    const std::vector<double> m = numbers_in(node, "matrix", 16);
    glm::dmat4 matrix(1.0);
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = m[static_cast<std::size_t>(i)];
    return matrix;
  }
  return gltf_placement(numbers_in<3>(node, "translation", {0.0, 0.0, 0.0}),
                        numbers_in<4>(node, "rotation", {0.0, 0.0, 0.0, 1.0}),
                        numbers_in<3>(node, "scale", {1.0, 1.0, 1.0}));
}

}  // namespace

glm::dmat4 gltf_placement(const std::array<double, 3>& translation,
                          const std::array<double, 4>& rotation,
                          const std::array<double, 3>& scale) {
  const auto [x, y, z, w] = rotation;
  const double square = x * x + y * y + z * z + w * w;
  const double n = square > 0.0 ? 2.0 / square : 0.0;  // dividing by it keeps turns exact
  const glm::dmat3 turn(1.0 - n * (y * y + z * z), n * (x * y + w * z), n * (x * z - w * y),
                        n * (x * y - w * z), 1.0 - n * (x * x + z * z), n * (y * z + w * x),
                        n * (x * z + w * y), n * (y * z - w * x), 1.0 - n * (x * x + y * y));
  glm::dmat4 placement(1.0);
  for (int column = 0; column < 3; ++column) {
    const auto at = static_cast<std::size_t>(column);
    placement[column] = glm::dvec4(turn[column] * scale[at], 0.0);
    placement[3][column] = translation[at];
  }
  return placement;
}

GltfScene::GltfScene(const std::string& path, const Json& file)
    : path_(path),
      file_(file),
      parents_(nodes_of(file).size(), kNone),
      to_world_(nodes_of(file).size()) {
  find_parents();
  collect();
}

void GltfScene::find_parents() {
  for (std::size_t i = 0; i < parents_.size(); ++i) {
    for (const Json& child : array_in(nodes_of(file_)[i], "children")) {
      const auto c = whole_number(child);
      if (!c || *c >= parents_.size()) fail(i, fmt::format("its child {} is none", child.dump()));
      if (parents_[*c] != kNone) fail(*c, "it is the child of two nodes");
      parents_[*c] = i;
    }
  }
}

void GltfScene::collect() {
  const Json& scenes = array_in(file_, "scenes");
  const std::size_t scene = whole_number_in(file_, "scene", 0);
  std::vector<std::size_t> waiting;
  if (scenes.empty()) {
    for (std::size_t i = parents_.size(); i-- > 0;) {
      if (parents_[i] == kNone) waiting.push_back(i);
    }
  } else {
    if (scene >= scenes.size()) {
      throw Error(fmt::format("{}: not a mesh that can be read: glTF: scene {}: there is none",
                              path_, scene));
    }
    for (const Json& root : array_in(scenes[scene], "nodes")) {
      waiting.push_back(whole_number(root).value_or(kNone));
    }
    std::ranges::reverse(waiting);
  }
  std::vector<bool> is_reached(parents_.size(), false);
  while (!waiting.empty()) {
    const std::size_t node = waiting.back();
    waiting.pop_back();
    if (node >= parents_.size()) fail(node, "it is in the scene, and there is none");
    if (is_reached[node]) fail(node, "it is in the scene twice");
    is_reached[node] = true;
    nodes_.push_back(node);
    const Json& children = member(nodes_of(file_)[node], "children");
    for (std::size_t i = children.size(); i-- > 0;) {
      waiting.push_back(*whole_number(children[i]));
    }
  }
}

const glm::dmat4& GltfScene::to_world(std::size_t node) {
  std::vector<std::size_t> way;  // up to a node whose transformation is known
  for (std::size_t at = node; at != kNone && !to_world_[at]; at = parents_[at]) {
    if (way.size() > parents_.size()) fail(node, "it is its own parent's parent");
    way.push_back(at);
  }
  while (!way.empty()) {
    const std::size_t at = way.back(), parent = parents_[at];
    way.pop_back();
    const glm::dmat4 in_parent = local(nodes_of(file_)[at]);
    to_world_[at] = parent == kNone ? in_parent : *to_world_[parent] * in_parent;
  }
  return *to_world_[node];
}

std::size_t GltfScene::meshes_elsewhere() const {
  const auto has_mesh = [&](std::size_t node) {
    return !member(nodes_of(file_)[node], "mesh").is_null();
  };
  const auto in_scene = std::ranges::count_if(nodes_, has_mesh);
  std::size_t all = 0;
  for (std::size_t i = 0; i < parents_.size(); ++i) all += has_mesh(i) ? 1 : 0;
  return all - static_cast<std::size_t>(in_scene);
}

void GltfScene::fail(std::size_t node, const std::string& what) const {
  throw Error(fmt::format("{}: not a mesh that can be read: glTF: node {}: {}", path_, node, what));
}

}  // namespace displayfile
