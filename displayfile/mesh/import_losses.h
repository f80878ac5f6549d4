#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clip/point.h"

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

/// A warning about skipped contents: "left out: the skins of 2 objects". The singular and the
/// plural each have a {} for the count.
inline std::string left_out_sentence(std::size_t count, std::string_view one,
                                     std::string_view many) {
  return "left out: " + fmt::format(fmt::runtime(count == 1 ? one : many), count);
}

/// Detects whether a mesh read in single precision lost detail. A coordinate is rounded to a
/// multiple of the spacing of floats of its size. An edge loses detail if it is shorter than 64
/// such spacings at its largest coordinate: rounding may then rotate it and change its length by
/// more than 1 %. A mesh does if more than one in ten of its edges do, so that a few slivers do not
/// count.
class LostDetail {
 public:
  /// Adds an edge of a face, as read.
  void add_edge(const Point3& from, const Point3& to);
  /// A warning; nothing if no detail was lost.
  std::optional<std::string> sentence() const;

 private:
  std::size_t edges_ = 0, lost_ = 0;
  double largest_ = 0.0;  // of the edges that lost detail
};

}  // namespace displayfile
