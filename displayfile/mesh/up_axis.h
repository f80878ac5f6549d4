#pragma once

#include <optional>
#include <string_view>

#include "clip/transformation.h"
#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// The axis nearest to a direction; y where no other is nearer.
Upright nearest_upright(const Point3& direction);

/// True if a file of this format (".ogex") says in its text which axis is up.
bool text_says_upright(std::string_view extension);

/// Sets which axis is up in a mesh by the format of its file, if that is one of README.md's table.
/// The file's text may be empty where text_says_upright is false.
void set_upright_of_format(Mesh& mesh, std::string_view extension, std::string_view text);

/// The axis of the world that is up in a picture of meshes. A modelling transformation that turns a
/// mesh turns what is up in it: the nearest axis counts.
class CommonUpright {
 public:
  /// A camera that says what is up has its way.
  explicit CommonUpright(const Camera& camera) : camera_(camera) {}
  void add(const Mesh& mesh, const ModellingTransformation& modelling);

  /// That of the camera, or else of the meshes that say one, or y.
  Upright upright() const;
  /// The camera, which says so.
  Camera camera() const;
  /// True if the camera does not say it, and the meshes not the same.
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
