#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/mesh_builder.h"
#include "displayfile/mesh/mesh_file.h"
#include "displayfile/mesh/neighbour_files.h"

namespace displayfile {

/// Materials by their names.
using MaterialLibrary = std::map<std::string, Mesh::Material, std::less<>>;

/// Reads a material library of OBJ files (.mtl): for each material the diffuse colour Kd, clamped
/// to [0,1], unless it is black beside a texture; whether it has a texture (map_Kd); whether it is
/// transparent (d below 1, or Tr above 0 and below 1 without d, or map_d). A repeated material is
/// continued, and of repeated values the last holds. Throws Error with file, line and column: an
/// invalid or non-finite number, binary data.
MaterialLibrary read_material_library(const MeshFile& file);

/// The materials used by an OBJ file, and the libraries that define them. Either may be named
/// first.
class ObjMaterials {
 public:
  /// `path` is of the OBJ file.
  explicit ObjMaterials(const std::string& path) : path_(path) {}

  /// usemtl: returns the index of a material, which it adds to the builder.
  std::uint32_t named(std::string_view name, MeshBuilder& mesh);
  /// mtllib: a library's name, which may hold blanks, or several separated by blanks; names may be
  /// in quotation marks, and one that ends in .mtl may hold blanks without them. Libraries are
  /// searched for only in the OBJ file's folder and below (neighbour_files.h); a missing one is
  /// replaced by the one with the OBJ file's own name. Throws Error if it is invalid.
  void add_library(std::string_view names);
  /// Passes the materials to the builder, and warns of unknown ones.
  void tell(MeshBuilder& mesh);

 private:
  /// False if there is no library of that name.
  bool read_library(std::string_view name);
  bool is_neighbour(const std::filesystem::path& path);
  /// Does not change known materials.
  void read_file(const std::filesystem::path& path);

  std::filesystem::path path_;
  std::optional<NeighbourFiles> neighbours_;  // set on first use
  std::map<std::string, std::uint32_t, std::less<>> used_;
  std::set<std::string, std::less<>> libraries_;  // as they were named
  MaterialLibrary known_;
  std::vector<std::string> missing_;  // libraries
};

}  // namespace displayfile
