#include "displayfile/mesh/mesh_file_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "clip/error.h"

namespace displayfile {

namespace {

constexpr double kLargestCoordinate = std::numeric_limits<float>::max();

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

template <class Number>
std::optional<Number> number(std::string_view field) {
  if (field.starts_with('+')) field.remove_prefix(1);
  Number value{};
  const char* end = field.data() + field.size();
  const auto result = std::from_chars(field.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

/// A file's text, read field by field.
class Text {
 public:
  Text(std::string_view path, std::string_view text) : path_(path), text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
  }

  /// The next field of this line; empty at its end. A backslash before a line end joins lines.
  std::string_view field() {
    while (at_ < text_.size() && (is_blank(text_[at_]) || joins_lines())) ++at_;
    const std::size_t start = at_;
    while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '\n') ++at_;
    return text_.substr(start, at_ - start);
  }

  /// The next field on this line or a later one, comments passed over; empty at the end of the
  /// file.
  std::string_view field_on_any_line() {
    for (;;) {
      if (const std::string_view f = field(); is_content(f)) return f;
      if (!next_line()) return {};
    }
  }

  /// Moves to the start of the next line that is not blank or a comment; false if there is none.
  bool next_filled_line() {
    while (next_line()) {
      const std::size_t start = at_;
      const bool filled = is_content(field());
      at_ = start;
      if (filled) return true;
    }
    return false;
  }

  bool next_line() {
    const std::size_t end = text_.find('\n', at_);
    at_ = end == std::string_view::npos ? text_.size() : end + 1;
    return at_ < text_.size();
  }

  double coordinate() {
    const std::string_view f = field();
    const std::optional<double> value = number<double>(f);
    if (!value) fail(f, fmt::format("{}: expected a coordinate", quoted(f)));
    if (!(std::abs(*value) <= kLargestCoordinate)) {
      fail(f, fmt::format("coordinate {}: expected a finite number of magnitude at most {}", f,
                          kLargestCoordinate));
    }
    return *value;
  }

  std::int64_t integer(std::string_view f, std::string_view expected) const {
    const std::optional<std::int64_t> value = number<std::int64_t>(f);
    if (!value) fail(f, fmt::format("{}: expected {}", quoted(f), expected));
    return *value;
  }

  /// Throws Error with the place of a field of this text; an empty one stands for where reading
  /// has come to.
  [[noreturn]] void fail(std::string_view f, const std::string& what) const {
    fail(f.empty() ? at_ : offset(f), what);
  }
  [[noreturn]] void fail(std::size_t at, const std::string& what) const {
    const std::string_view before = text_.substr(0, at);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    throw Error(fmt::format("{}:{}:{}: {}", path_, line, at - line_start + 1, what));
  }

  std::size_t offset(std::string_view f) const {
    return static_cast<std::size_t>(f.data() - text_.data());
  }
  std::size_t at() const { return at_; }
  std::size_t bytes_left() const { return text_.size() - at_; }
  std::string_view rest() const { return text_.substr(at_); }

  static std::string quoted(std::string_view f) {
    if (f.empty()) return "end of line";
    std::string s = "'";
    for (char c : f.substr(0, 20)) s += c >= ' ' && c <= '~' ? c : '?';
    return s + (f.size() > 20 ? "...'" : "'");
  }

 private:
  static bool is_content(std::string_view f) { return !f.empty() && f[0] != '#'; }

  bool joins_lines() {
    if (text_[at_] != '\\') return false;
    std::size_t next = at_ + 1;
    if (next < text_.size() && text_[next] == '\r') ++next;
    if (next >= text_.size() || text_[next] != '\n') return false;
    at_ = next;
    return true;
  }

  std::string_view path_, text_;
  std::size_t at_ = 0;
};

// ---- OBJ -------------------------------------------------------------------------------

/// The indices of OBJ faces: into the vertices, texture coordinates and normals so far, or,
/// as the library reads the file whole, those that are still to come.
class ObjIndices {
 public:
  enum Kind { vertex, texture, normal };

  void define(Kind kind) { ++defined_[kind]; }

  void refer(Kind kind, std::string_view field, const Text& text) {
    const std::int64_t index = text.integer(field, "an index");
    if (index == 0 || index < -defined_[kind]) fail(kind, text.offset(field), index, text);
    // Of those too large so far, only one larger than all before it can be the first error.
    auto& ahead = ahead_[kind];
    const std::int64_t largest = ahead.empty() ? defined_[kind] : ahead.back().index;
    if (index > std::max(largest, defined_[kind])) ahead.push_back({index, text.offset(field)});
  }

  void check_all_defined(const Text& text) const {
    for (const Kind kind : {vertex, texture, normal}) {
      for (const auto& [index, at] : ahead_[kind]) {
        if (index > defined_[kind]) fail(kind, at, index, text);
      }
    }
  }

 private:
  struct Ahead {
    std::int64_t index;
    std::size_t at;
  };

  [[noreturn]] void fail(Kind kind, std::size_t at, std::int64_t index, const Text& text) const {
    constexpr std::array names = {"vertex", "texture coordinate", "normal"};
    const std::string what = fmt::format("{} index {} out of range: ", names[kind], index);
    if (defined_[kind] == 0) text.fail(at, what + fmt::format("no {} was given", names[kind]));
    text.fail(at, what + fmt::format("expected 1 to {0} or -{0} to -1", defined_[kind]));
  }

  std::array<std::int64_t, 3> defined_{};
  std::array<std::vector<Ahead>, 3> ahead_;
};

void check_obj_corner(std::string_view corner, ObjIndices& indices, const Text& text) {
  for (const auto kind : {ObjIndices::vertex, ObjIndices::texture, ObjIndices::normal}) {
    const std::size_t slash = std::min(corner.find('/'), corner.size());
    const std::string_view index = corner.substr(0, slash);
    if (!index.empty()) {
      indices.refer(kind, index, text);
    } else if (kind == ObjIndices::vertex) {
      text.fail(corner, fmt::format("{}: expected a vertex index", Text::quoted(corner)));
    }
    if (slash == corner.size()) return;
    corner.remove_prefix(slash + 1);
  }
  text.fail(corner, "expected at most three indices, vertex/texture/normal");
}

void check_obj(Text text) {
  ObjIndices indices;
  do {
    const std::string_view keyword = text.field();
    if (keyword == "v") {
      for (int i = 0; i < 3; ++i) text.coordinate();
      indices.define(ObjIndices::vertex);
    } else if (keyword == "vt") {
      indices.define(ObjIndices::texture);
    } else if (keyword == "vn") {
      indices.define(ObjIndices::normal);
    } else if (keyword == "f" || keyword == "l" || keyword == "p") {
      for (auto corner = text.field(); !corner.empty(); corner = text.field()) {
        check_obj_corner(corner, indices, text);
      }
    }
  } while (text.next_line());
  indices.check_all_defined(text);
}

// ---- OFF -------------------------------------------------------------------------------

/// A count that the file announces, of things that take at least `least_bytes` each.
std::int64_t announced(Text& text, std::string_view what, std::string_view field,
                       std::size_t least_bytes) {
  const std::int64_t count = text.integer(field, fmt::format("a number of {}", what));
  if (count < 0 || static_cast<std::uint64_t>(count) > (text.bytes_left() + 1) / least_bytes) {
    text.fail(field, fmt::format("{} {} announced, but only {} bytes follow", count, what,
                                 text.bytes_left()));
  }
  return count;
}

/// The header's keyword, if there is one: coordinates a vertex, as [ST][C][N][4][n]OFF.
int off_dimension(Text& text) {
  Text ahead = text;
  const std::string_view keyword = ahead.field_on_any_line();
  if (!keyword.ends_with("OFF")) return 3;
  text = ahead;
  const int homogeneous = keyword.find('4') != std::string_view::npos ? 1 : 0;
  if (keyword.find('n') == std::string_view::npos) return 3 + homogeneous;
  const std::string_view f = text.field_on_any_line();
  const std::int64_t n = text.integer(f, "the dimension");
  if (n < 1 || n > 3) text.fail(f, fmt::format("dimension {}: expected 1 to 3", n));
  return static_cast<int>(n) + homogeneous;
}

/// A face of more, or of none, the library leaves out without a word, or reads the next line as it.
constexpr std::int64_t kMostCornersOfOff = 9;

void check_off(Text text) {
  const int dimension = off_dimension(text);
  const auto count = [&](std::string_view what, std::size_t least_bytes) {
    return announced(text, what, text.field_on_any_line(), least_bytes);
  };
  const std::int64_t vertices = count("vertices", 2 * static_cast<std::size_t>(dimension));
  const std::int64_t faces = count("faces", 2);
  const auto next = [&](std::string_view what, std::int64_t i, std::int64_t n) {
    if (text.next_filled_line()) return;
    text.fail(text.at(), fmt::format("end of file: expected {} {} of {}", what, i, n));
  };
  for (std::int64_t i = 0; i < vertices; ++i) {
    next("vertex", i, vertices);
    for (int k = 0; k < dimension; ++k) text.coordinate();
  }
  for (std::int64_t i = 0; i < faces; ++i) {
    next("face", i, faces);
    const std::string_view corners = text.field();
    const std::int64_t sides = announced(text, "corners", corners, 2);
    if (sides < 1 || sides > kMostCornersOfOff) {
      text.fail(corners, fmt::format("a face of {} corners: expected 1 to {} in an OFF file", sides,
                                     kMostCornersOfOff));
    }
    for (std::int64_t k = 0; k < sides; ++k) {
      const std::string_view f = text.field();
      const std::int64_t index = text.integer(f, "a vertex index");
      if (index < 0 || index >= vertices) {
        text.fail(
            f, fmt::format("vertex index {} out of range: expected 0 to {}", index, vertices - 1));
      }
    }
  }
}

// ---- PLY -------------------------------------------------------------------------------

struct PlyProperty {
  std::size_t size;       ///< bytes of a value, in a binary file
  std::size_t list_size;  ///< of the list's count; 0 if this is no list
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
};

std::size_t ply_size(std::string_view type, const Text& text) {
  struct Type {
    std::string_view name;
    std::size_t size;
  };
  constexpr std::array<Type, 16> types = {{{"char", 1},
                                           {"uchar", 1},
                                           {"int8", 1},
                                           {"uint8", 1},
                                           {"short", 2},
                                           {"ushort", 2},
                                           {"int16", 2},
                                           {"uint16", 2},
                                           {"int", 4},
                                           {"uint", 4},
                                           {"int32", 4},
                                           {"uint32", 4},
                                           {"float", 4},
                                           {"float32", 4},
                                           {"double", 8},
                                           {"float64", 8}}};
  const auto* found = std::ranges::find(types, type, &Type::name);
  if (found == types.end()) {
    text.fail(type, fmt::format("{}: expected a PLY type", Text::quoted(type)));
  }
  return found->size;
}

PlyHeader ply_header(Text& text) {
  PlyHeader header;
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
      header.elements.push_back({name, announced(text, name, count, 1), text.offset(count), {}});
    } else if (keyword == "property") {
      if (header.elements.empty()) text.fail(keyword, "property before any element");
      const std::string_view type = text.field();
      PlyProperty property{};
      if (type == "list") property.list_size = ply_size(text.field(), text);
      property.size = ply_size(type == "list" ? text.field() : type, text);
      header.elements.back().properties.push_back(property);
    } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
      // The library looks for the end of what it does not know, and may never find it.
      text.fail(keyword,
                fmt::format("{}: expected format, element, property, comment or end_header",
                            Text::quoted(keyword)));
    }
  }
  text.fail(text.at(), "end of file: expected end_header");
}

[[noreturn]] void fail_ply_element(const PlyElement& e, std::int64_t i, const Text& text) {
  text.fail(e.at,
            fmt::format("{} {} announced, but the file ends in number {}", e.count, e.name, i));
}

void check_ply_text(const PlyHeader& header, Text text) {
  for (const PlyElement& element : header.elements) {
    for (std::int64_t i = 0; i < element.count; ++i) {
      for (const PlyProperty& property : element.properties) {
        std::string_view value = text.field_on_any_line();
        if (value.empty()) fail_ply_element(element, i, text);
        if (property.list_size == 0) continue;
        for (std::int64_t n = announced(text, "values of a list", value, 2); n > 0; --n) {
          if (text.field_on_any_line().empty()) fail_ply_element(element, i, text);
        }
      }
    }
  }
}

std::uint64_t unsigned_value(std::string_view bytes, bool big_endian) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto byte = static_cast<unsigned char>(bytes[big_endian ? i : bytes.size() - 1 - i]);
    value = value << 8 | byte;
  }
  return value;
}

void check_ply_binary(const PlyHeader& header, const Text& text) {
  const bool big_endian = header.format == "binary_big_endian";
  std::string_view data = text.rest();
  for (const PlyElement& element : header.elements) {
    for (std::int64_t i = 0; i < element.count; ++i) {
      for (const auto& [size, list_size] : element.properties) {
        std::uint64_t values = 1;
        if (data.size() < list_size) fail_ply_element(element, i, text);
        if (list_size > 0) values = unsigned_value(data.substr(0, list_size), big_endian);
        data.remove_prefix(list_size);
        if (values > data.size() / size) fail_ply_element(element, i, text);
        data.remove_prefix(values * size);
      }
    }
  }
}

void check_ply(Text text) {
  const PlyHeader header = ply_header(text);
  if (header.format == "ascii") return check_ply_text(header, text);
  if (header.format.starts_with("binary")) return check_ply_binary(header, text);
  text.fail(text.at(), "no format in the header: expected format ascii or binary_little_endian");
}

// ---- STL -------------------------------------------------------------------------------

void check_stl(const std::string& path, std::string_view data) {
  constexpr std::size_t header = 84, facet = 50;  // bytes
  if (data.starts_with("solid")) return;          // a text, which announces nothing
  const std::uint64_t facets = data.size() < header ? 0 : unsigned_value(data.substr(80, 4), false);
  if (data.size() < header || facets > (data.size() - header) / facet) {
    throw Error(fmt::format("{}: binary STL of {} bytes announces {} facets: expected {} bytes",
                            path, data.size(), facets, header + facet * facets));
  }
}

// ----------------------------------------------------------------------------------------

std::string contents(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    throw Error(fmt::format("{}: no such file: expected a mesh", path));
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw Error(fmt::format("{}: not a regular file: expected a mesh", path));
  }
  std::ifstream in(path, std::ios::binary);
  const auto size = std::filesystem::file_size(path, error);
  std::string data(error ? 0 : size, '\0');
  if (!in || error || !in.read(data.data(), static_cast<std::streamsize>(size))) {
    throw Error(fmt::format("{}: cannot read the file", path));
  }
  if (data.empty()) throw Error(fmt::format("{}: empty file: expected a mesh", path));
  return data;
}

bool is_utf_16(std::string_view data) {
  return data.starts_with("\xFF\xFE") || data.starts_with("\xFE\xFF");
}

/// A text has no zero bytes.
Text as_text(const std::string& path, std::string_view data) {
  Text text(path, data);
  if (const std::size_t zero = data.find('\0'); zero != std::string_view::npos) {
    text.fail(zero, "binary data: expected text");
  }
  return text;
}

}  // namespace

void check_mesh_file(const std::string& path) {
  const std::string data = contents(path);
  if (is_utf_16(data)) return;
  std::string extension = std::filesystem::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  });
  if (data.starts_with("ply")) return check_ply(Text(path, data));
  if (extension == ".ply") throw Error(fmt::format("{}:1:1: expected ply", path));
  if (extension == ".obj") return check_obj(as_text(path, data));
  if (extension == ".off" || data.starts_with("OFF")) return check_off(as_text(path, data));
  if (extension == ".stl") return check_stl(path, data);
}

}  // namespace displayfile
