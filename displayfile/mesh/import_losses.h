#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace displayfile {

/// Findings about a file before the import library reads it, since the library silently skips what
/// its readers do not support.
struct ImportLosses {
  std::vector<std::string> left_out;  ///< one sentence each: "left out: the instances of 1 object"
  /// Names of other files, as written in this file and as meant.
  std::map<std::string, std::string> meant_names;

  /// Adds a sentence in the singular or in the plural, each with a {} for the count, if it is not
  /// 0.
  void add(std::size_t count, const std::string& one, const std::string& many);
};

/// A glTF file that the import library reads: of version 1.0, or with meshes compressed by Draco.
/// Throws Error if it requires an extension that the library does not read, as the specification
/// demands; has integer positions or normals; or has an invalid percent-encoded name or JSON.
ImportLosses losses_of_gltf(const std::string& path);

/// Formats that are read in the import process, as far as they can be, not by the library.
enum class ForeignFormat { gltf, three_mf, other };

/// A file's format, determined by its extension, or otherwise by its beginning, unless the library
/// supports the extension (`by_extension`).
ForeignFormat foreign_format(const std::string& path, bool by_extension);

}  // namespace displayfile
