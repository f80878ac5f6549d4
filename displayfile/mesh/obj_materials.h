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

/// The materials that an OBJ file uses, and the libraries that tell what they look like. Either may
/// be named first.
class ObjMaterials {
 public:
  /// `path` is of the OBJ file.
  explicit ObjMaterials(const std::string& path) : path_(path) {}

  /// usemtl: the index of a material, which the builder has from now on.
  std::uint32_t named(std::string_view name, MeshBuilder& mesh);
  /// mtllib: a library's name, which may hold blanks, or several parted by blanks; each may stand
  /// in quotation marks, and one that ends in .mtl may hold blanks without. A library is looked for
  /// in the OBJ file's folder and below it, and nowhere else (neighbour_files.h); one that is not
  /// there gives way to the one that has the OBJ file's own name. Throws Error if it is bad.
  void add_library(std::string_view names);
  /// Tells the builder what the materials look like, and which of them are not known.
  void tell(MeshBuilder& mesh);

 private:
  /// False if there is none of that name.
  bool read_library(std::string_view name);
  bool is_neighbour(const std::filesystem::path& path);
  /// Materials that are known already stay what they are.
  void read_file(const std::filesystem::path& path);

  std::filesystem::path path_;
  std::optional<NeighbourFiles> neighbours_;  // once some were asked for
  std::map<std::string, std::uint32_t, std::less<>> used_;
  std::set<std::string, std::less<>> libraries_;  // as they were named
  MaterialLibrary known_;
  std::vector<std::string> missing_;  // libraries
};

}  // namespace displayfile
