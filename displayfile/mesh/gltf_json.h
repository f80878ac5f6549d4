#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace displayfile {

// glTF: Khronos Group, "glTF 2.0 Specification", 2021.

using Json = nlohmann::json;

/// A glTF file: its JSON, and the binary chunk of a .glb file, if it has one.
struct GltfFile {
  Json json;
  std::string binary;
};

/// Reads a file, JSON or binary. Version 1.0 has its JSON at the same place. Throws Error: invalid
/// JSON, with its place.
GltfFile gltf_file(const std::string& path);

/// A member of an object; null if there is none. Iterating over null gives nothing.
const Json& member(const Json& object, const char* name);
/// The element that a number refers to in an array, or in glTF 1.0 a name in an object; null if
/// none.
const Json& referred(const Json& among, const Json& reference);
/// A non-negative whole number; nothing if it is none.
std::optional<std::size_t> whole_number(const Json& value);
/// A string; empty if it is none. Valid as long as the JSON is.
std::string_view text_of(const Json& value);

// Members that may be missing, and are not of another type. Each throws std::runtime_error for one
// that is.

/// An object, or null.
const Json& object_in(const Json& object, const char* name);
/// An array, or null.
const Json& array_in(const Json& object, const char* name);
std::size_t whole_number_in(const Json& object, const char* name, std::size_t if_missing);
double number_in(const Json& object, const char* name, double if_missing);
/// The numbers of an array, which must have `expected` elements; none if it is missing.
std::vector<double> numbers_in(const Json& object, const char* name, std::size_t expected);
template <std::size_t N>
std::array<double, N> numbers_in(const Json& object, const char* name,
                                 const std::array<double, N>& if_missing) {
  std::array<double, N> all = if_missing;
  const std::vector<double> values = numbers_in(object, name, N);
  std::copy(values.begin(), values.end(), all.begin());
  return all;
}

/// Names of buffers' files, as written and as meant, where these differ. Throws Error for an
/// invalid percent-encoded name.
std::map<std::string, std::string> meant_names(const std::string& path, const Json& file);

/// Throws Error if the file requires an extension for which `is_read` is false, as the
/// specification demands.
void require_extensions(const std::string& path, const Json& file,
                        bool (*is_read)(std::string_view name));

}  // namespace displayfile
