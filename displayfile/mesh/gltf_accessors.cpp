#include "displayfile/mesh/gltf_accessors.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "clip/base/error.h"
#include "displayfile/mesh/mesh_file.h"

namespace displayfile {

/// A component type: its code, its size in bytes, and the largest value of normalized integers.
struct GltfAccessors::Type {
  std::size_t code, bytes;
  double largest;
  double (*read)(std::string_view);
};

namespace {

template <class Number>
double component(std::string_view bytes) {
  return static_cast<double>(binary_value<Number>(bytes, std::endian::little));
}

constexpr std::size_t kFloatType = 5126;

struct ElementType {
  std::string_view name;
  std::size_t components;
};
constexpr ElementType kElements[] = {
    {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};

/// Decodes base64 (RFC 4648, section 4). Nothing if the text has other characters.
std::optional<std::string> base64_decoded(std::string_view text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int n = 0;
  for (const char c : text) {
    const std::size_t digit = kDigits.find(c);
    if (digit == kDigits.npos) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    n += 6;
    if (n < 8) continue;
    n -= 8;
    bytes += static_cast<char>(bits >> n & 0xFF);
  }
  return bytes;
}

}  // namespace

GltfAccessors::GltfAccessors(const std::string& path, const GltfFile& file)
    : path_(path),
      file_(file),
      neighbours_(path),
      meant_names_(meant_names(path, file.json)),
      buffers_(array_in(file.json, "buffers").size()) {}

GltfValues GltfAccessors::values(const Json& reference, std::size_t fewest, std::size_t most) {
  static constexpr Type kTypes[] = {
      {5120, 1, 127, component<std::int8_t>},          {5121, 1, 255, component<std::uint8_t>},
      {5122, 2, 32767, component<std::int16_t>},       {5123, 2, 65535, component<std::uint16_t>},
      {5125, 4, 4294967295, component<std::uint32_t>}, {kFloatType, 4, 1, component<float>}};
  accessor_ = reference.dump();
  const Json& accessor = referred(array_in(file_.json, "accessors"), reference);
  if (accessor.is_null()) fail("there is none");
  const auto code = whole_number(member(accessor, "componentType"));
  const auto* type = std::ranges::find(kTypes, code.value_or(0), &Type::code);
  const auto* element =
      std::ranges::find(kElements, text_of(member(accessor, "type")), &ElementType::name);
  if (type == std::end(kTypes) || element == std::end(kElements)) fail("its type is unknown");
  if (element->components < fewest || element->components > most) {
    fail(fmt::format(
        "{}: expected {} components", element->name,
        fewest == most ? fmt::format("{}", most) : fmt::format("{} to {}", fewest, most)));
  }
  const auto count = whole_number(member(accessor, "count"));
  constexpr std::size_t kMost = 0xFFFFFFFF;
  if (!count || *count > kMost) fail("expected a count");

  GltfValues all{*count, element->components, {}, type->code == kFloatType, 1.0};
  const Json& view = member(accessor, "bufferView");
  if (view.is_null()) {
    all.values.assign(*count * all.components, 0.0);
  } else {
    const std::size_t from = whole_number_in(accessor, "byteOffset", 0);
    read(view, {from, type->bytes * all.components, *count}, *type, all.components, all.values);
  }
  const Json& sparse = object_in(accessor, "sparse");
  if (!sparse.is_null()) read_sparse(sparse, *type, all);
  if (!std::ranges::all_of(all.values, [](double v) { return std::isfinite(v); })) {
    fail("expected finite numbers");
  }
  if (!all.are_floats && member(accessor, "normalized") == true) {
    all.unit = 1.0 / type->largest;
    for (double& value : all.values) value = std::max(value / type->largest, -1.0);
  }
  return all;
}

std::vector<std::uint32_t> GltfAccessors::indices(const Json& reference) {
  const GltfValues all = values(reference, 1);
  std::vector<std::uint32_t> indices;
  indices.reserve(all.count);
  for (const double value : all.values) {
    const bool is_index = value >= 0.0 && value <= 4294967295.0 && value == std::floor(value);
    if (!is_index) fail(fmt::format("{}: expected an index", value));
    indices.push_back(static_cast<std::uint32_t>(value));
  }
  return indices;
}

void GltfAccessors::read(const Json& reference, const Place& place, const Type& type,
                         std::size_t components, std::vector<double>& to) {
  const Json& view = referred(array_in(file_.json, "bufferViews"), reference);
  if (view.is_null()) fail("its buffer view is not there");
  const std::string_view bytes = buffer(member(view, "buffer"));
  const std::size_t begin = whole_number_in(view, "byteOffset", 0);
  const std::size_t length = whole_number_in(view, "byteLength", 0);
  if (begin > bytes.size() || length > bytes.size() - begin) {
    fail(fmt::format("its buffer view ends behind its buffer, which has {} bytes", bytes.size()));
  }
  constexpr std::size_t kMostStride = 0xFFFF;
  std::size_t stride = whole_number_in(view, "byteStride", 0);
  if (stride > kMostStride) fail(fmt::format("stride {}: expected at most 252", stride));
  if (stride == 0) stride = place.bytes;
  const std::string_view data = bytes.substr(begin, length);
  const bool fits =
      place.count == 0 || (place.from <= length && place.bytes <= length - place.from &&
                           (place.count - 1) * stride <= length - place.from - place.bytes);
  if (!fits) {
    fail(fmt::format("{} elements announced, but its buffer view has {} bytes", place.count,
                     length));
  }
  to.reserve(place.count * components);
  for (std::size_t i = 0; i < place.count; ++i) {
    for (std::size_t k = 0; k < components; ++k) {
      to.push_back(type.read(data.substr(place.from + i * stride + k * type.bytes)));
    }
  }
}

/// Reads sparse elements, which replace others.
void GltfAccessors::read_sparse(const Json& sparse, const Type& type, GltfValues& to) {
  const std::size_t count = whole_number_in(sparse, "count", 0);
  const Json& indices = member(sparse, "indices");
  const Json& values = member(sparse, "values");
  const Type kIndices[] = {{5121, 1, 1, component<std::uint8_t>},
                           {5123, 2, 1, component<std::uint16_t>},
                           {5125, 4, 1, component<std::uint32_t>}};
  const auto code = whole_number(member(indices, "componentType"));
  const auto* index_type = std::ranges::find(kIndices, code.value_or(0), &Type::code);
  if (count > to.count || index_type == std::end(kIndices)) fail("its sparse values are invalid");
  std::vector<double> at, replaced;
  const auto offset = [](const Json& of) { return whole_number_in(of, "byteOffset", 0); };
  read(member(indices, "bufferView"), {offset(indices), index_type->bytes, count}, *index_type, 1,
       at);
  read(member(values, "bufferView"), {offset(values), type.bytes * to.components, count}, type,
       to.components, replaced);
  for (std::size_t i = 0; i < count; ++i) {
    const auto element = static_cast<std::size_t>(at[i]);
    if (element >= to.count)
      fail(fmt::format("sparse index {}: expected 0 to {}", element, to.count));
    std::copy_n(&replaced[i * to.components], to.components, &to.values[element * to.components]);
  }
}

std::string_view GltfAccessors::buffer(const Json& reference) {
  const Json& buffers = array_in(file_.json, "buffers");
  const auto number = whole_number(reference);
  if (!number || *number >= buffers.size()) fail("its buffer is not there");
  auto& content = buffers_[*number];
  if (!content) content = content_of(buffers[*number], *number);
  return *content;
}

std::string GltfAccessors::content_of(const Json& buffer, std::size_t number) const {
  const Json& uri = member(buffer, "uri");
  if (!uri.is_string()) {
    if (number == 0 && !file_.binary.empty()) return file_.binary;
    fail(fmt::format("buffer {} has no data", number));
  }
  const std::string written(text_of(uri));
  if (written.starts_with("data:")) {
    constexpr std::string_view kBase64 = ";base64,";
    const std::size_t at = written.find(kBase64);
    auto bytes = at == written.npos
                     ? std::nullopt
                     : base64_decoded(std::string_view(written).substr(at + kBase64.size()));
    if (!bytes) fail(fmt::format("the data of buffer {}: expected base64", number));
    return std::move(*bytes);
  }
  const auto meant = meant_names_.find(written);
  const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
  for (const std::string& name : {meant == meant_names_.end() ? written : meant->second, written}) {
    const std::string path = (folder / name).string();
    if (!neighbours_.allows(path)) continue;
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  fail(fmt::format("no buffer '{}' beside it", written));
}

void GltfAccessors::fail(const std::string& what) const {
  throw Error(fmt::format("{}: not a mesh that can be read: glTF: accessor {}: {}", path_,
                          accessor_, what));
}

}  // namespace displayfile
