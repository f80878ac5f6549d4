#include "displayfile/mesh/import_losses.h"

#include <array>
#include <fstream>
#include <string_view>

#include "clip/base/file_extension.h"
#include "displayfile/mesh/left_out_sentence.h"

namespace displayfile {

void ImportLosses::add(std::size_t count, const std::string& one, const std::string& many) {
  if (count > 0) left_out.push_back(left_out_sentence(count, one, many));
}

ForeignFormat foreign_format(const std::string& path, bool by_extension) {
  const std::string extension = extension_of(path);
  if (extension == ".gltf" || extension == ".glb") return ForeignFormat::gltf;
  if (extension == ".3mf") return ForeignFormat::three_mf;
  if (by_extension) return ForeignFormat::other;
  std::array<char, 4> bytes{};
  std::ifstream(path, std::ios::binary).read(bytes.data(), bytes.size());
  const std::string_view beginning(bytes.data(), bytes.size());
  if (beginning == "glTF" || beginning.starts_with('{')) return ForeignFormat::gltf;
  return beginning.starts_with("PK") ? ForeignFormat::three_mf : ForeignFormat::other;
}

}  // namespace displayfile
