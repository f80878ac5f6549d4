#pragma once

#include <optional>
#include <string_view>

#include "clip/view/transformation.h"
#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// The axis nearest to a direction; y in ties.
Upright nearest_upright(const Point3& direction);

/// True if files of this format (".ogex") state the up axis in their text.
bool text_says_upright(std::string_view extension);

/// Sets a mesh's up axis from its file's format, if that is in README.md's table. The text may be
/// empty where text_says_upright is false.
void set_upright_of_format(Mesh& mesh, std::string_view extension, std::string_view text);

/// The up axis of the world in a picture of meshes. A modelling transformation rotates a mesh's up
/// axis: the nearest axis counts.
class CommonUpright {
 public:
  /// A camera's up axis takes precedence.
  explicit CommonUpright(const Camera& camera) : camera_(camera) {}
  void add(const Mesh& mesh, const ModellingTransformation& modelling);

  /// The up axis of the camera, or else of the meshes that state one, or y.
  Upright upright() const;
  /// The camera with that up axis.
  Camera camera() const;
  /// True if the camera states none and the meshes disagree.
  bool differ() const { return differ_; }

 private:
  Camera camera_;
  std::optional<Upright> of_meshes_;
  bool differ_ = false;
};

/// The warning if they differ.
inline constexpr std::string_view kStandDifferently =
    "inputs drawn together have different up axes: y is used for all unless --up is set";

}  // namespace displayfile
