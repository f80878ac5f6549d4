#include "displayfile/mesh/gltf_json.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/mesh/mesh_file.h"
#include "displayfile/mesh/neighbour_files.h"

namespace displayfile {

namespace {

/// The data of a chunk, after its length and type: as many bytes as the length announces and the
/// file has.
std::string_view chunk_at(std::string_view file, std::size_t at) {
  constexpr std::size_t kHead = 8;
  if (file.size() < at + kHead) return {};
  const auto length = binary_value<std::uint32_t>(file.substr(at), std::endian::little);
  return file.substr(at + kHead, length);
}

[[noreturn]] void fail_type(const char* name, const std::string& expected) {
  throw std::runtime_error(fmt::format("glTF: {}: expected {}", name, expected));
}

}  // namespace

GltfFile gltf_file(const std::string& path) {
  constexpr std::size_t kHeader = 12, kChunkHead = 8;  // bytes
  std::ifstream in(path, std::ios::binary);
  const std::string content(std::istreambuf_iterator<char>(in), {});
  std::string_view text = content, binary;
  if (text.starts_with("glTF")) {
    text = chunk_at(content, kHeader);
    binary = chunk_at(content, kHeader + kChunkHead + text.size());
    while (text.ends_with('\0')) text.remove_suffix(1);  // some programs fill up chunks by zeros
  }
  try {
    return {Json::parse(text), std::string(binary)};
  } catch (const Json::parse_error& e) {
    throw Error(
        fmt::format("{}: not a mesh that can be read: glTF: bad JSON at byte {}", path, e.byte));
  }
}

const Json& member(const Json& object, const char* name) {
  static const Json none;
  if (!object.is_object()) return none;
  const auto found = object.find(name);
  return found == object.end() ? none : *found;
}

const Json& referred(const Json& among, const Json& reference) {
  if (reference.is_string()) return member(among, reference.get_ref<const std::string&>().c_str());
  const auto index = whole_number(reference);
  return among.is_array() && index && *index < among.size() ? among[*index] : member({}, "");
}

std::optional<std::size_t> whole_number(const Json& value) {
  if (!value.is_number_unsigned()) return std::nullopt;
  return static_cast<std::size_t>(value.get<std::uint64_t>());
}

std::string_view text_of(const Json& value) {
  return value.is_string() ? std::string_view(value.get_ref<const std::string&>())
                           : std::string_view();
}

const Json& object_in(const Json& object, const char* name) {
  const Json& value = member(object, name);
  if (!value.is_null() && !value.is_object()) fail_type(name, "an object");
  return value;
}

const Json& array_in(const Json& object, const char* name) {
  const Json& value = member(object, name);
  if (!value.is_null() && !value.is_array()) fail_type(name, "an array");
  return value;
}

std::size_t whole_number_in(const Json& object, const char* name, std::size_t if_missing) {
  const Json& value = member(object, name);
  if (value.is_null()) return if_missing;
  const auto number = whole_number(value);
  if (!number) fail_type(name, "a whole number");
  return *number;
}

double number_in(const Json& object, const char* name, double if_missing) {
  const Json& value = member(object, name);
  if (value.is_null()) return if_missing;
  if (!value.is_number()) fail_type(name, "a number");
  return value.get<double>();
}

std::vector<double> numbers_in(const Json& object, const char* name, std::size_t expected) {
  std::vector<double> numbers;
  const Json& values = array_in(object, name);
  for (const Json& value : values) {
    if (value.is_number()) numbers.push_back(value.get<double>());
  }
  if (!values.is_null() && (numbers.size() != expected || values.size() != expected)) {
    fail_type(name, fmt::format("{} numbers", expected));
  }
  return numbers;
}

std::map<std::string, std::string> meant_names(const std::string& path, const Json& file) {
  std::map<std::string, std::string> names;
  for (const Json& buffer : member(file, "buffers")) {
    const std::string written(text_of(member(buffer, "uri")));
    if (written.starts_with("data:") || written.find('%') == written.npos) continue;
    const auto meant = percent_decoded(written);
    if (!meant) {
      throw Error(
          fmt::format("{}: buffer '{}': expected two hexadecimal digits, not 00, behind each %",
                      path, written));
    }
    names.emplace(written, *meant);
  }
  return names;
}

void require_extensions(const std::string& path, const Json& file,
                        bool (*is_read)(std::string_view name)) {
  std::vector<std::string_view> others;
  for (const Json& name : member(file, "extensionsRequired")) {
    if (name.is_string() && !is_read(text_of(name))) others.push_back(text_of(name));
  }
  if (others.empty()) return;
  throw Error(fmt::format("{}: requires the glTF extension{} {}, which {} not read", path,
                          others.size() > 1 ? "s" : "", fmt::join(others, ", "),
                          others.size() > 1 ? "are" : "is"));
}

}  // namespace displayfile
