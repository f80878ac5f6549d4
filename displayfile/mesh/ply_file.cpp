// PLY: G. Turk, "The PLY Polygon File Format", Stanford University 1994.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/mesh/mesh_builder.h"
#include "displayfile/mesh/mesh_file.h"
#include "displayfile/mesh/text_cursor.h"

namespace displayfile {

namespace {

// ---- Header ----------------------------------------------------------------------------

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr std::array<std::size_t, 8> kPlySizes = {1, 1, 2, 2, 4, 4, 4, 8};  // bytes

/// The value of a full colour component, by type. Programs that write components of four bytes mean
/// 0 to 255.
constexpr std::array<double, 8> kPlyWholeParts = {127, 255, 32767, 65535, 255, 255, 1, 1};

constexpr double whole_part(PlyType type) { return kPlyWholeParts[static_cast<std::size_t>(type)]; }
constexpr std::size_t size_of(PlyType type) { return kPlySizes[static_cast<std::size_t>(type)]; }
constexpr bool is_integer(PlyType type) { return type < PlyType::float32; }

struct PlyProperty {
  std::string_view name;
  PlyType type;
  std::optional<PlyType> count = {};  ///< of a list
};

struct PlyElement {
  std::string_view name;
  std::int64_t count;
  std::size_t at;  ///< of the count, in the file
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  std::string_view format;
  std::vector<PlyElement> elements;
  std::size_t textures = 0;  ///< that comments name
  /// Lines before the first element that are not of the format, and the place of the first: some
  /// programs write their own names there.
  std::size_t other_lines = 0;
  std::string first_other;
};

PlyType ply_type(std::string_view name, const TextCursor& text) {
  struct Name {
    std::string_view name;
    PlyType type;
  };
  constexpr std::array<Name, 16> names = {{{"char", PlyType::int8},
                                           {"uchar", PlyType::uint8},
                                           {"int8", PlyType::int8},
                                           {"uint8", PlyType::uint8},
                                           {"short", PlyType::int16},
                                           {"ushort", PlyType::uint16},
                                           {"int16", PlyType::int16},
                                           {"uint16", PlyType::uint16},
                                           {"int", PlyType::int32},
                                           {"uint", PlyType::uint32},
                                           {"int32", PlyType::int32},
                                           {"uint32", PlyType::uint32},
                                           {"float", PlyType::float32},
                                           {"float32", PlyType::float32},
                                           {"double", PlyType::float64},
                                           {"float64", PlyType::float64}}};
  const auto* found = std::ranges::find(names, name, &Name::name);
  if (found == names.end()) {
    text.fail(name, fmt::format("{}: expected a PLY type", TextCursor::quoted(name)));
  }
  return found->type;
}

PlyProperty ply_property(TextCursor& text) {
  PlyProperty property{};
  std::string_view type = text.field();
  if (type == "list") {
    const std::string_view count = text.field();
    property.count = ply_type(count, text);
    if (!is_integer(*property.count)) {
      text.fail(count, fmt::format("{}: expected an integer type for the count of a list", count));
    }
    type = text.field();
  }
  property.type = ply_type(type, text);
  property.name = text.field();
  return property;
}

PlyHeader ply_header(TextCursor& text) {
  PlyHeader header;
  std::set<std::string_view> names;  // of elements
  while (text.next_line()) {
    const std::string_view keyword = text.field();
    if (keyword == "end_header") {
      text.next_line();
      return header;
    }
    if (keyword == "format") {
      header.format = text.field();
    } else if (keyword == "element") {
      const std::string_view name = text.field();
      const std::string_view count = text.field();
      if (!names.insert(name).second) {
        text.fail(name, fmt::format("{}: expected each element once", TextCursor::quoted(name)));
      }
      header.elements.push_back({name, text.announced(count, name, 1), text.offset(count), {}});
    } else if (keyword == "property") {
      if (header.elements.empty()) text.fail(keyword, "property before any element");
      header.elements.back().properties.push_back(ply_property(text));
    } else if (keyword == "comment") {
      header.textures += text.field() == "TextureFile" ? 1 : 0;
    } else if (keyword.empty() || keyword == "obj_info") {
      continue;
    } else if (header.elements.empty()) {
      if (header.other_lines++ > 0) continue;
      header.first_other =
          fmt::format("{}: {}", text.place(text.offset(keyword)), TextCursor::quoted(keyword));
    } else {
      text.fail(keyword,
                fmt::format("{}: expected format, element, property, comment or end_header",
                            TextCursor::quoted(keyword)));
    }
  }
  text.fail(text.at(), "end of file: expected end_header");
}

// ---- Values ----------------------------------------------------------------------------

/// Position of a value: the element being read, and its number.
struct PlyPlace {
  const PlyElement& element;
  std::int64_t number = 0;
};

[[noreturn]] void fail_at_end(const PlyPlace& place, const TextCursor& text) {
  text.fail(place.element.at, fmt::format("{} {} announced, but the file ends in number {}",
                                          place.element.count, place.element.name, place.number));
}

/// The values of an ascii file, one field each, regardless of line ends.
class PlyText {
 public:
  explicit PlyText(const TextCursor& text) : text_(text) {}

  static std::size_t least_bytes(PlyType) { return 2; }

  double real(PlyType, const PlyPlace& place) { return text_.real(next(place), "a number"); }
  double coordinate(PlyType, const PlyPlace& place) { return text_.coordinate(next(place)); }
  double rounding_of_coordinates() const { return text_.rounding_of_coordinates(); }
  static bool has_single_coordinates() { return false; }
  std::int64_t list_count(const PlyProperty&, const PlyPlace& place) {
    return text_.announced(next(place), "values of a list", 2);
  }
  void skip(PlyType, const PlyPlace& place) { next(place); }
  std::size_t lines_left() { return text_.count_filled_lines(); }
  /// Throws Error about the value read last.
  [[noreturn]] void fail(const PlyPlace&, const std::string& what) const {
    text_.fail(last_, what);
  }

 private:
  std::string_view next(const PlyPlace& place) {
    last_ = text_.field_on_any_line();
    if (last_.empty()) fail_at_end(place, text_);
    return last_;
  }

  TextCursor text_;
  std::string_view last_;
};

class PlyBinary {
 public:
  PlyBinary(const TextCursor& text, std::string_view path, std::endian order)
      : text_(text), path_(path), data_(text.rest()), order_(order) {}

  static std::size_t least_bytes(PlyType type) { return size_of(type); }

  double real(PlyType type, const PlyPlace& place) {
    const std::string_view value = next(size_of(type), place);
    switch (type) {
      case PlyType::float32: return binary_value<float>(value, order_);
      case PlyType::float64: return binary_value<double>(value, order_);
      default: return static_cast<double>(integer_of(type, value));
    }
  }
  double coordinate(PlyType type, const PlyPlace& place) {
    const double value = real(type, place);
    if (!(std::abs(value) <= kLargestCoordinate)) {
      fail(place, fmt::format("coordinate {}: expected a finite number of magnitude at most {}",
                              value, kLargestCoordinate));
    }
    has_single_coordinates_ |= type == PlyType::float32;
    return value;
  }
  static double rounding_of_coordinates() { return 0.0; }
  bool has_single_coordinates() const { return has_single_coordinates_; }
  std::int64_t list_count(const PlyProperty& list, const PlyPlace& place) {
    const std::int64_t count = integer_of(*list.count, next(size_of(*list.count), place));
    if (count < 0) fail(place, fmt::format("a list of {} values", count));
    if (static_cast<std::uint64_t>(count) > data_.size() / size_of(list.type)) {
      fail_at_end(place, text_);
    }
    return count;
  }
  void skip(PlyType type, const PlyPlace& place) { next(size_of(type), place); }
  static std::size_t lines_left() { return 0; }
  [[noreturn]] void fail(const PlyPlace& place, const std::string& what) const {
    throw Error(fmt::format("{}: {} {}: {}", path_, place.element.name, place.number, what));
  }

 private:
  std::string_view next(std::size_t size, const PlyPlace& place) {
    if (data_.size() < size) fail_at_end(place, text_);
    const std::string_view value = data_.substr(0, size);
    data_.remove_prefix(size);
    return value;
  }

  std::int64_t integer_of(PlyType type, std::string_view value) const {
    switch (type) {
      case PlyType::int8: return binary_value<std::int8_t>(value, order_);
      case PlyType::uint8: return binary_value<std::uint8_t>(value, order_);
      case PlyType::int16: return binary_value<std::int16_t>(value, order_);
      case PlyType::uint16: return binary_value<std::uint16_t>(value, order_);
      case PlyType::int32: return binary_value<std::int32_t>(value, order_);
      default: return binary_value<std::uint32_t>(value, order_);
    }
  }

  const TextCursor& text_;
  std::string_view path_, data_;
  std::endian order_;
  bool has_single_coordinates_ = false;
};

// ---- Elements --------------------------------------------------------------------------

/// The colour of an element: which properties are its components, and their values.
class PlyColour {
 public:
  explicit PlyColour(const PlyElement& element) {
    constexpr std::array<std::string_view, 4> kNames = {"red", "green", "blue", "alpha"};
    std::array<bool, 4> has{};
    for (const PlyProperty& p : element.properties) {
      std::string_view name = p.name;
      if (name.starts_with("diffuse_")) name.remove_prefix(8);
      const auto* const found = p.count ? kNames.end() : std::ranges::find(kNames, name);
      parts_.push_back(static_cast<std::size_t>(found - kNames.begin()));
      if (parts_.back() < 4) has[parts_.back()] = true;
    }
    is_there_ = has[0] && has[1] && has[2];
  }

  bool is_there() const { return is_there_; }
  bool has(std::size_t property) const { return is_there_ && parts_[property] < 4; }
  void set(std::size_t property, double part) { value_[static_cast<int>(parts_[property])] = part; }
  const Rgba& value() const { return value_; }

 private:
  std::vector<std::size_t> parts_;  // component of each property; 4 if none
  bool is_there_ = false;
  Rgba value_{kOpaque};
};

template <class Values>
class PlyReader {
 public:
  PlyReader(const MeshFile& file, const PlyHeader& header, Values values)
      : header_(header),
        values_(std::move(values)),
        mesh_(file.path),
        with_normals_(file.with_normals) {}

  Mesh read() && {
    const auto vertex = std::ranges::find(header_.elements, "vertex", &PlyElement::name);
    const auto face = std::ranges::find(header_.elements, "face", &PlyElement::name);
    vertices_ = vertex == header_.elements.end() ? 0 : vertex->count;
    mesh_.reserve(static_cast<std::size_t>(vertices_),
                  face == header_.elements.end() ? 0 : static_cast<std::size_t>(face->count));
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else if (element.name == "tristrips") {
        read_strips(element);
      } else {
        skip(element);
        warn_of_element(element);
      }
    }
    mesh_.warn_left_out(header_.textures, "{} texture", "{} textures");
    if (header_.other_lines > 0) {
      mesh_.warn(fmt::format("{}: not read: {}", header_.first_other,
                             header_.other_lines == 1
                                 ? "the line is left out"
                                 : fmt::format("{} such lines are left out", header_.other_lines)));
    }
    mesh_.warn_of_lines_left(values_.lines_left());
    mesh_.share_normals_as_vertices();
    mesh_.note_rounding(values_.rounding_of_coordinates());
    if (values_.has_single_coordinates()) mesh_.set_single_precision();
    return std::move(mesh_).finish();
  }

 private:
  void warn_of_element(const PlyElement& element) {
    if (element.count == 0) return;
    mesh_.warn(fmt::format("left out: the element {}, of which there {}",
                           TextCursor::quoted(element.name),
                           element.count == 1 ? "is 1" : fmt::format("are {}", element.count)));
  }

  /// Texture coordinates are excluded: a texture that a file does not name cannot be drawn.
  void warn_of_properties(const PlyElement& element, const std::vector<std::string_view>& others) {
    constexpr std::array<std::string_view, 9> kOfTextures = {
        "s", "t", "u", "v", "texture_u", "texture_v", "texcoord", "texnumber", "flags"};
    std::vector<std::string> names;
    for (const std::string_view name : others) {
      if (std::ranges::find(kOfTextures, name) == kOfTextures.end()) {
        names.push_back(TextCursor::quoted(name));
      }
    }
    if (names.empty() || element.count == 0) return;
    mesh_.warn(fmt::format("left out: of each {}: {}", element.name, fmt::join(names, ", ")));
  }

  void skip(const PlyElement& element) {
    if (element.properties.empty()) return;  // whatever the announced count
    for (PlyPlace place{element}; place.number < element.count; ++place.number) {
      for (const PlyProperty& property : element.properties) skip(property, place);
    }
  }
  void skip(const PlyProperty& property, const PlyPlace& place) {
    std::int64_t values = property.count ? values_.list_count(property, place) : 1;
    for (; values > 0; --values) values_.skip(property.type, place);
  }

  void read_vertices(const PlyElement& element) {
    constexpr std::array<std::string_view, 6> kNames = {"x", "y", "z", "nx", "ny", "nz"};
    std::vector<std::size_t> parts;  // index in kNames of each property
    for (const PlyProperty& p : element.properties) {
      const auto* const name = p.count ? kNames.end() : std::ranges::find(kNames, p.name);
      parts.push_back(static_cast<std::size_t>(name - kNames.begin()));
    }
    const bool has_normals =
        std::ranges::any_of(parts, [](std::size_t k) { return k >= 3 && k < 6; });
    PlyColour colour(element);
    std::vector<std::string_view> others;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i] == kNames.size() && !colour.has(i)) others.push_back(element.properties[i].name);
    }
    warn_of_properties(element, others);
    std::array<double, 6> value{};
    for (PlyPlace place{element}; place.number < element.count; ++place.number) {
      for (std::size_t i = 0; i < parts.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        if (parts[i] < 3) {
          value[parts[i]] = values_.coordinate(property.type, place);
        } else if (parts[i] < 6) {
          value[parts[i]] = values_.real(property.type, place);
        } else {
          read_other(colour, i, place);
        }
      }
      mesh_.add_vertex({value[0], value[1], value[2]});
      if (has_normals && with_normals_) mesh_.add_normal({value[3], value[4], value[5]});
      if (colour.is_there()) mesh_.add_vertex_colour(colour.value());
    }
  }

  /// Reads a property that is a colour component, or skips it.
  void read_other(PlyColour& colour, std::size_t property, const PlyPlace& place) {
    const PlyProperty& p = place.element.properties[property];
    if (!colour.has(property)) return skip(p, place);
    const double part = values_.real(p.type, place);
    if (!std::isfinite(part)) {
      values_.fail(place, fmt::format("{} {}: expected a finite number", p.name, part));
    }
    colour.set(property, part / whole_part(p.type));
  }

  /// True for normals' components; a face's normal follows from its corners.
  static bool is_part_of_normal(std::string_view name) {
    return name == "nx" || name == "ny" || name == "nz";
  }

  static bool is_index_list(const PlyProperty& p) {
    return p.count && (p.name == "vertex_indices" || p.name == "vertex_index");
  }

  void read_faces(const PlyElement& element) {
    PlyColour colour(element);
    std::vector<std::string_view> others;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (!is_index_list(property) && !colour.has(i) && !is_part_of_normal(property.name)) {
        others.push_back(property.name);
      }
    }
    warn_of_properties(element, others);
    std::vector<std::uint32_t> corners;
    const auto add = [&] {
      if (colour.is_there()) mesh_.use_colour(colour.value());
      mesh_.add_face(corners);
    };
    for (PlyPlace place{element}; place.number < element.count; ++place.number) {
      bool has_list = false;
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        if (!is_index_list(property)) {
          read_other(colour, i, place);
          continue;
        }
        if (has_list) add();  // of two lists
        corners.clear();
        std::int64_t n = values_.list_count(property, place);
        for (; n > 0; --n) corners.push_back(index(values_.real(property.type, place), place));
        has_list = true;
      }
      if (has_list) add();
    }
    mesh_.use_colour(std::nullopt);
  }

  /// Each vertex ends a triangle with the two before it; -1 begins a new strip.
  void read_strips(const PlyElement& element) {
    const auto read_strip = [&](PlyType type, std::int64_t n, const PlyPlace& place) {
      std::array<std::uint32_t, 3> triangle{};
      std::int64_t length = 0;
      for (; n > 0; --n) {
        const double value = values_.real(type, place);
        if (value == -1.0) {
          length = 0;
          continue;
        }
        triangle = {triangle[1], triangle[2], index(value, place)};
        if (++length < 3) continue;
        const auto [a, b, c] = triangle;
        mesh_.add_face(length % 2 == 1 ? std::array{a, b, c} : std::array{b, a, c});
      }
    };
    for (PlyPlace place{element}; place.number < element.count; ++place.number) {
      for (const PlyProperty& property : element.properties) {
        if (is_index_list(property)) {
          read_strip(property.type, values_.list_count(property, place), place);
        } else {
          skip(property, place);
        }
      }
    }
  }

  std::uint32_t index(double value, const PlyPlace& place) const {
    const bool in_range = value >= 0.0 && value < static_cast<double>(vertices_);
    if (!in_range || value != static_cast<double>(static_cast<std::int64_t>(value))) {
      values_.fail(place, fmt::format("vertex index {} out of range: expected 0 to {}", value,
                                      vertices_ - 1));
    }
    return static_cast<std::uint32_t>(value);
  }

  const PlyHeader& header_;
  Values values_;
  MeshBuilder mesh_;
  bool with_normals_;
  std::int64_t vertices_ = 0;  // that the header announces
};

/// Checks the announced counts against the least size of each element and the bytes after the
/// header.
template <class Values>
void check_room(const PlyHeader& header, const TextCursor& text) {
  for (const PlyElement& element : header.elements) {
    std::size_t least = 0;
    for (const PlyProperty& p : element.properties)
      least += Values::least_bytes(p.count.value_or(p.type));
    if (least > 0 && static_cast<std::size_t>(element.count) > (text.bytes_left() + 1) / least) {
      text.fail(element.at, fmt::format("{} {} announced, but only {} bytes follow", element.count,
                                        element.name, text.bytes_left()));
    }
  }
}

template <class Values>
Mesh read_values(const MeshFile& file, const PlyHeader& header, const TextCursor& text,
                 Values values) {
  check_room<Values>(header, text);
  return PlyReader<Values>(file, header, std::move(values)).read();
}

}  // namespace

Mesh read_ply(const MeshFile& file) {
  // The data after the header may be binary: line ends are determined by the first one.
  TextCursor text(file.path, file.data, LineBreaks::as_first);
  if (text.field() != "ply") text.fail(std::size_t{0}, "expected ply");
  const PlyHeader header = ply_header(text);
  if (header.format == "ascii") return read_values(file, header, text, PlyText(text));
  for (const auto& [format, order] : {std::pair("binary_little_endian", std::endian::little),
                                      std::pair("binary_big_endian", std::endian::big)}) {
    if (header.format == format) {
      return read_values(file, header, text, PlyBinary(text, file.path, order));
    }
  }
  text.fail(text.at(),
            "no format in the header: expected format ascii, binary_little_endian or "
            "binary_big_endian");
}

}  // namespace displayfile
