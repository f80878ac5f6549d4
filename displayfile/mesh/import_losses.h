#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "clip/base/shared_library.h"

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

/// A glTF file, JSON or binary (.glb): Khronos Group, "glTF 2.0 Specification", 2021. Throws Error
/// if it requires an extension that the library does not read, as the specification demands; has
/// integer positions or normals; or has an invalid percent-encoded name or JSON.
ImportLosses losses_of_gltf(const std::string& path);

/// A 3MF file: 3MF Consortium, "3D Manufacturing Format, Core Specification & Reference Guide",
/// 1.3. Throws Error if its model is missing or requires an extension that the library does not
/// read, as the specification demands. `library` is the import library, which contains the archive
/// reader. Other archives have no findings.
ImportLosses losses_of_3mf(const std::string& path, const SharedLibrary& library);

/// Examines a file of any format, determined by its extension, or otherwise by its beginning,
/// unless the library supports the extension (`by_extension`).
ImportLosses losses_of(const std::string& path, bool by_extension, const SharedLibrary& library);

}  // namespace displayfile
