#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/mesh_files.h"

namespace displayfile::test {

/// The check sum that ZIP and PNG have (ISO 3309), bit by bit.
inline std::uint32_t crc32(std::string_view data) {
  std::uint32_t sum = 0xFFFFFFFFu;
  for (const char c : data) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xEDB88320u : 0);
  }
  return ~sum;
}

using ArchiveFiles = std::vector<std::pair<std::string, std::string>>;

/// A ZIP archive of files, by name and content, that are not compressed.
inline std::string archive(const ArchiveFiles& files) {
  const auto two = [](std::size_t n) { return bytes(static_cast<std::uint16_t>(n)); };
  const auto four = [](std::size_t n) { return bytes(static_cast<std::uint32_t>(n)); };
  std::string all, directory;
  for (const auto& [name, content] : files) {
    const std::string sizes = four(crc32(content)) + four(content.size()) + four(content.size());
    const std::string head =
        two(20) + two(0) + two(0) + four(0) + sizes + two(name.size()) + two(0);
    directory += "PK\1\2" + two(20) + head + two(0) + two(0) + two(0) + four(0) + four(all.size());
    directory += name;
    all += "PK\3\4" + head + name + content;
  }
  const std::string end = two(0) + two(0) + two(files.size()) + two(files.size()) +
                          four(directory.size()) + four(all.size()) + two(0);
  return all + directory + "PK\5\6" + end;
}

/// The parts of a 3MF file with this model.
inline ArchiveFiles parts_of_3mf(const std::string& model) {
  return {
      {"[Content_Types].xml",
       "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"/>"},
      {"_rels/.rels",
       "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
       "<Relationship Target=\"/3D/a.png\" Id=\"r\" Type=\"http://thumbnail\"/>"
       "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
       "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
      {"3D/3dmodel.model", model}};
}

/// A 3MF file with this model.
inline std::string file_of_3mf(const std::string& model) { return archive(parts_of_3mf(model)); }

}  // namespace displayfile::test
