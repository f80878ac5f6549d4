#include "displayfile/mesh/obj_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "displayfile/input_file.h"
#include "displayfile/mesh/text_cursor.h"

namespace displayfile {

namespace {

std::vector<std::string_view> words(std::string_view text) {
  TextCursor cursor({}, text);
  std::vector<std::string_view> found;
  for (auto f = cursor.field(); !f.empty(); f = cursor.field()) found.push_back(f);
  return found;
}

/// The first of the names, and how many others there are.
std::string listed(const std::vector<std::string>& names) {
  std::string text = TextCursor::quoted(names.front());
  if (names.size() > 1) text += fmt::format(" and {} more", names.size() - 1);
  return text;
}

}  // namespace

std::uint32_t ObjMaterials::named(std::string_view name, MeshBuilder& mesh) {
  const auto known = used_.find(name);
  if (known != used_.end()) return known->second;
  return used_.emplace(std::string(name), mesh.add_material()).first->second;
}

void ObjMaterials::add_library(std::string_view names) {
  if (!libraries_.emplace(names).second || read_library(names)) return;
  for (const std::string_view name : words(names)) {
    if (!read_library(name)) missing_.emplace_back(name);
  }
}

bool ObjMaterials::read_library(std::string_view name) {
  std::string local(name);  // paths of other systems have backslashes
  std::ranges::replace(local, '\\', '/');
  const std::filesystem::path folder = path_.parent_path(), path(local);
  for (const auto& candidate : {folder / path, folder / path.filename()}) {
    if (!is_neighbour(candidate)) continue;
    read_file(candidate);
    return true;
  }
  return false;
}

/// What an OBJ file names is no reason to open anything elsewhere.
bool ObjMaterials::is_neighbour(const std::filesystem::path& path) {
  if (!neighbours_) neighbours_.emplace(path_.string());
  return neighbours_->allows(path.string());
}

void ObjMaterials::read_file(const std::filesystem::path& path) {
  const std::string name = path == "-" ? "./-" : path.string();
  known_.merge(read_material_library({name, read_text_file(name)}));
}

void ObjMaterials::tell(MeshBuilder& mesh) {
  const std::filesystem::path of_same_name = std::filesystem::path(path_).replace_extension(".mtl");
  if (!missing_.empty() && is_neighbour(of_same_name)) {
    read_file(of_same_name);
    missing_.clear();
  }
  std::vector<std::string> unknown;
  for (const auto& [name, index] : used_) {
    const auto found = known_.find(name);
    if (found != known_.end()) {
      mesh.set_material(index, found->second);
    } else {
      unknown.push_back(name);
    }
  }
  if (unknown.empty()) return;
  if (!missing_.empty()) {
    mesh.warn(fmt::format("no material library {} beside it", listed(missing_)));
  } else {
    mesh.warn(fmt::format("no library has its material {}", listed(unknown)));
  }
}

}  // namespace displayfile
