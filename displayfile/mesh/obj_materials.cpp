#include "displayfile/mesh/obj_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "clip/base/files.h"
#include "displayfile/mesh/compressed_data.h"
#include "displayfile/mesh/text_cursor.h"

namespace displayfile {

namespace {

/// A word of a list of names; one in quotation marks may hold blanks.
struct NamePart {
  std::string_view text;
  bool quoted;
};

std::vector<NamePart> names_of(std::string_view list) {
  constexpr std::string_view kBlanks = " \t";
  std::vector<NamePart> words;
  for (;;) {
    list.remove_prefix(std::min(list.find_first_not_of(kBlanks), list.size()));
    if (list.empty()) return words;
    const std::size_t closing = list.front() == '"' ? list.find('"', 1) : list.npos;
    if (closing != list.npos) {
      words.push_back({list.substr(1, closing - 1), true});
      list.remove_prefix(closing + 1);
    } else {
      words.push_back({list.substr(0, list.find_first_of(kBlanks)), false});
      list.remove_prefix(words.back().text.size());
    }
  }
}

/// True if a word ends a name that may hold blanks: it has the extension of material libraries.
bool ends_name(std::string_view word) {
  const std::string_view end = word.substr(word.size() - std::min<std::size_t>(word.size(), 4));
  return std::ranges::equal(end, std::string_view(".mtl"), [](char c, char lower) {
    return c == lower || (c >= 'A' && c <= 'Z' && c - 'A' + 'a' == lower);
  });
}

/// The number of words of the first name: one in quotation marks, or all up to one that ends it.
std::size_t words_of_name(std::span<const NamePart> words) {
  if (words[0].quoted) return 1;
  std::size_t n = 1;
  while (n < words.size() && !words[n].quoted && !ends_name(words[n - 1].text)) ++n;
  return n;
}

/// The first of the names, and the number of others.
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
  const std::vector<NamePart> words = names_of(names);
  for (std::span<const NamePart> rest = words; !rest.empty();) {
    const auto name = rest.first(words_of_name(rest));
    rest = rest.subspan(name.size());
    const std::string_view first = name.front().text, last = name.back().text;
    const bool has_blanks =
        name.size() > 1 &&
        read_library(
            {first.data(), static_cast<std::size_t>(last.data() - first.data()) + last.size()});
    if (has_blanks) continue;
    for (const NamePart& word : name) {
      if (!read_library(word.text)) missing_.emplace_back(word.text);
    }
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

/// True if an OBJ file may refer to the path; it cannot cause a file elsewhere to be opened.
bool ObjMaterials::is_neighbour(const std::filesystem::path& path) {
  if (!neighbours_) neighbours_.emplace(path_.string());
  return neighbours_->allows(path.string());
}

void ObjMaterials::read_file(const std::filesystem::path& path) {
  const std::string name = path == "-" ? "./-" : path.string();
  known_.merge(read_material_library({name, read_text_file(name)}));
}

void ObjMaterials::tell(MeshBuilder& mesh) {
  const std::filesystem::path of_same_name = name_uncompressed(path_).replace_extension(".mtl");
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
