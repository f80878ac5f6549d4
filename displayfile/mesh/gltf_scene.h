#pragma once

#include <array>
#include <cstddef>
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "displayfile/mesh/gltf_json.h"

namespace displayfile {

/// Scales, then turns by a quaternion x y z w, then moves. Turns by quarters and thirds are exact,
/// also where the quaternion's length is not quite 1.
glm::dmat4 gltf_placement(const std::array<double, 3>& translation,
                          const std::array<double, 4>& rotation,
                          const std::array<double, 3>& scale);

/// The nodes of a glTF 2.0 file, at rest: no animation moves them.
class GltfScene {
 public:
  /// References must outlive it. Throws Error if a node is reached twice, or is not there.
  GltfScene(const std::string& path, const Json& file);

  /// The nodes of the default scene, or the first, or all if the file has none, parents first.
  const std::vector<std::size_t>& nodes() const { return nodes_; }
  /// A node's transformation to the world.
  const glm::dmat4& to_world(std::size_t node);
  /// The number of nodes with meshes that are not among nodes().
  std::size_t meshes_elsewhere() const;

 private:
  void find_parents();
  void collect();
  [[noreturn]] void fail(std::size_t node, const std::string& what) const;

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  const std::string& path_;
  const Json& file_;
  std::vector<std::size_t> parents_;  // kNone for roots
  std::vector<std::size_t> nodes_;
  std::vector<std::optional<glm::dmat4>> to_world_;
};

}  // namespace displayfile
