#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "clip/base/shared_library.h"

namespace displayfile {

/// What is known of a file before the import library reads it: that library passes over, without a
/// word, what its readers do not know.
struct ImportLosses {
  std::vector<std::string> left_out;  ///< a sentence each: "left out: the instances of 1 object"
  /// Names of other files, as this file writes them and as they are meant.
  std::map<std::string, std::string> meant_names;

  /// Adds a sentence in the singular or in the plural, each with a {} for the count, if it is not
  /// 0.
  void add(std::size_t count, const std::string& one, const std::string& many);
};

/// A glTF file, JSON or binary (.glb): Khronos Group, "glTF 2.0 Specification", 2021. Throws Error
/// if it requires an extension that the library does not read, as the specification demands; has
/// positions or normals of integers; has a percent-encoded name that is none, or JSON that is bad.
ImportLosses losses_of_gltf(const std::string& path);

/// A 3MF file: 3MF Consortium, "3D Manufacturing Format, Core Specification & Reference
/// Guide", 1.3. Throws Error if its model requires an extension that the library does not read, as
/// the specification demands, or is not in it. `library` is the import library, which brings along
/// what reads archives. Of an archive that is no 3MF file nothing is known.
ImportLosses losses_of_3mf(const std::string& path, const SharedLibrary& library);

/// Looks at a file of any format, which is found by its name's extension, or else by how the file
/// begins, unless the extension is one that the library knows (`by_extension`).
ImportLosses losses_of(const std::string& path, bool by_extension, const SharedLibrary& library);

}  // namespace displayfile
