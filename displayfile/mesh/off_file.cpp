// OFF, the object file format of Geomview: its manual, section "OFF: Polyhedral Objects".

#include <fmt/format.h>

#include <array>
#include <vector>

#include "displayfile/mesh/mesh_builder.h"
#include "displayfile/mesh/mesh_file.h"
#include "displayfile/mesh/text_cursor.h"

namespace displayfile {

namespace {

/// What a vertex line begins with.
struct OffVertex {
  int dimension = 3;
  bool homogeneous = false, normal = false, colour = false, texture = false;

  int numbers() const { return dimension + (homogeneous ? 1 : 0); }
};

/// Takes a letter of the header's keyword, if it stands there.
bool take(std::string_view& keyword, std::string_view letters) {
  if (!keyword.starts_with(letters)) return false;
  keyword.remove_prefix(letters.size());
  return true;
}

/// The header's keyword, [ST][C][N][4][n]OFF, if there is one.
OffVertex off_header(TextCursor& text) {
  TextCursor ahead = text;
  std::string_view keyword = ahead.field_on_any_line();
  OffVertex vertex;
  vertex.texture = take(keyword, "ST");
  vertex.colour = take(keyword, "C");
  vertex.normal = take(keyword, "N");
  vertex.homogeneous = take(keyword, "4");
  const bool has_dimension = take(keyword, "n");
  if (keyword != "OFF") return {};
  text = ahead;
  if (has_dimension) {
    const std::string_view f = text.field_on_any_line();
    const std::int64_t n = text.integer(f, "the dimension");
    if (n < 1 || n > 3) text.fail(f, fmt::format("dimension {}: expected 1 to 3", n));
    vertex.dimension = static_cast<int>(n);
  }
  return vertex;
}

class OffReader {
 public:
  explicit OffReader(const MeshFile& file)
      : text_(text_of(file.path, file.data)), mesh_(file.path), with_normals_(file.with_normals) {}

  Mesh read() && {
    const OffVertex vertex = off_header(text_);
    const auto count = [&](std::string_view what, std::size_t least_bytes) {
      return text_.announced(text_.field_on_any_line(), what, least_bytes);
    };
    const auto numbers = static_cast<std::size_t>(vertex.numbers());
    const std::int64_t vertices = count("vertices", 2 * numbers), faces = count("faces", 2);
    mesh_.reserve(static_cast<std::size_t>(vertices), static_cast<std::size_t>(faces));
    for (std::int64_t i = 0; i < vertices; ++i) {
      next("vertex", i, vertices);
      read_vertex(vertex);
    }
    for (std::int64_t i = 0; i < faces; ++i) {
      next("face", i, faces);
      read_face(vertices);
    }
    mesh_.warn_of_lines_left(text_.count_filled_lines());
    mesh_.share_normals_as_vertices();
    return std::move(mesh_).finish();
  }

 private:
  void next(std::string_view what, std::int64_t i, std::int64_t n) {
    if (text_.next_filled_line()) return;
    text_.fail(text_.at(), fmt::format("end of file: expected {} {} of {}", what, i, n));
  }

  void read_vertex(const OffVertex& vertex) {
    const Point3 p = text_.position(vertex.dimension);
    mesh_.add_vertex(vertex.homogeneous ? text_.over_weight(p, text_.field()) : p);
    if (vertex.normal && with_normals_) {
      mesh_.add_normal(text_.direction());
    } else if (vertex.normal && vertex.colour) {
      for (int axis = 0; axis < 3; ++axis) text_.field();
    }
    if (vertex.colour) read_colour_of_vertex(vertex.texture);
  }

  /// Texture coordinates stand after it.
  void read_colour_of_vertex(bool texture) {
    std::array<std::string_view, 7> fields;
    auto rest = text_.fields(fields);
    if (texture && rest.size() > 2) rest = rest.first(rest.size() - 2);
    if (const auto colour = text_.colour(rest)) mesh_.add_vertex_colour(*colour);
  }

  void read_face(std::int64_t vertices) {
    const std::string_view field = text_.field();
    const std::int64_t sides = text_.announced(field, "corners", 2);
    if (sides < 1) text_.fail(field, "a face of 0 corners: expected 1 or more");
    corners_.clear();
    for (std::int64_t k = 0; k < sides; ++k) {
      const std::string_view f = text_.field();
      const std::int64_t index = text_.integer(f, "a vertex index");
      if (index < 0 || index >= vertices) {
        text_.fail(
            f, fmt::format("vertex index {} out of range: expected 0 to {}", index, vertices - 1));
      }
      corners_.push_back(static_cast<std::uint32_t>(index));
    }
    // One number is an index into a map of colours that the file does not have.
    std::array<std::string_view, 5> fields;
    mesh_.use_colour(text_.colour(text_.fields(fields)));
    mesh_.add_face(corners_);
  }

  TextCursor text_;
  MeshBuilder mesh_;
  bool with_normals_;
  std::vector<std::uint32_t> corners_;  // of the face that is read
};

}  // namespace

Mesh read_off(const MeshFile& file) { return OffReader(file).read(); }

}  // namespace displayfile
