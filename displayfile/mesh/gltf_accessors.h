#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "displayfile/mesh/gltf_json.h"
#include "displayfile/mesh/neighbour_files.h"

namespace displayfile {

/// An accessor's elements, each of `components` components, in the order of the file. Normalized
/// integers are parts of 1.
struct GltfValues {
  std::size_t count = 0, components = 0;
  std::vector<double> values;
  bool are_floats = true;  ///< in single precision; else whole numbers or parts of 1
  double unit = 0.0;       ///< of whole numbers: 1, or 1 over the largest if normalized

  const double* operator[](std::size_t i) const { return &values[components * i]; }
};

/// The accessors of a glTF 2.0 file, and the buffers that hold their data.
class GltfAccessors {
 public:
  /// References must outlive it. Buffers are opened on first use, among the mesh's neighbours.
  GltfAccessors(const std::string& path, const GltfFile& file);

  /// The accessor to which this refers, which must have one of these numbers of components. Throws
  /// Error, with its number: there is none; a type that is not allowed; data that its buffer does
  /// not have; numbers that are not finite.
  GltfValues values(const Json& reference, std::size_t fewest, std::size_t most);
  GltfValues values(const Json& reference, std::size_t components) {
    return values(reference, components, components);
  }
  /// The same for non-negative whole numbers.
  std::vector<std::uint32_t> indices(const Json& reference);

 private:
  struct Type;

  /// Position of elements: `from` bytes into the buffer view, `bytes` bytes each, `stride` apart if
  /// it is not 0.
  struct Place {
    std::size_t from, bytes, count;
  };
  void read(const Json& view, const Place& place, const Type& type, std::size_t components,
            std::vector<double>& to);
  void read_sparse(const Json& sparse, const Type& type, GltfValues& to);
  std::string_view buffer(const Json& reference);
  std::string content_of(const Json& buffer, std::size_t number) const;
  [[noreturn]] void fail(const std::string& what) const;

  const std::string& path_;
  const GltfFile& file_;
  NeighbourFiles neighbours_;
  std::map<std::string, std::string> meant_names_;
  std::vector<std::optional<std::string>> buffers_;  // that have been opened
  std::string accessor_;                             // that is read, for messages
};

}  // namespace displayfile
