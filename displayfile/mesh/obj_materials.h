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

#include "displayfile/mesh/material_library.h"
#include "displayfile/mesh/mesh_builder.h"
#include "displayfile/mesh/neighbour_files.h"

namespace displayfile {

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
