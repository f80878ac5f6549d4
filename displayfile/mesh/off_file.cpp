// OFF, the object file format of Geomview: its manual, section "OFF: Polyhedral Objects".

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "displayfile/mesh/mesh_builder.h"
#include "displayfile/mesh/mesh_file.h"
#include "displayfile/mesh/text_cursor.h"

namespace displayfile {

namespace {

/// The contents of a vertex line.
struct OffVertex {
  int dimension = 3;
  bool homogeneous = false, normal = false, colour = false, texture = false;

  int numbers() const { return dimension + (homogeneous ? 1 : 0); }
};

/// Removes letters of the header's keyword if it begins with them.
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

/// True if three numbers may be a unit normal.
bool is_unit(const Rgba& c) {
  constexpr double kRounded = 1e-3;
  return std::abs(c.r * c.r + c.g * c.g + c.b * c.b - 1.0) < kRounded;
}

class OffReader {
 public:
  explicit OffReader(const MeshFile& file)
      : text_(text_of(file.path, file.data)), mesh_(file.path), with_normals_(file.with_normals) {}

  Mesh read() && {
    OffVertex vertex = off_header(text_);
    const auto count = [&](std::string_view what, std::size_t least_bytes) {
      return text_.announced(text_.field_on_any_line(), what, least_bytes);
    };
    const auto numbers = static_cast<std::size_t>(vertex.numbers());
    const std::int64_t vertices = count("vertices", 2 * numbers), faces = count("faces", 2);
    mesh_.reserve(static_cast<std::size_t>(vertices), static_cast<std::size_t>(faces));
    vertex.colour |= has_unannounced_colours(text_, vertex, vertices);
    for (std::int64_t i = 0; i < vertices; ++i) {
      next("vertex", i, vertices);
      read_vertex(vertex);
    }
    for (std::int64_t i = 0; i < faces; ++i) {
      next("face", i, faces);
      read_face(vertices);
    }
    warn_of_what_was_left_out();
    mesh_.warn_of_lines_left(text_.count_filled_lines());
    mesh_.share_normals_as_vertices();
    mesh_.note_rounding(text_.rounding_of_coordinates());
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
    } else if (vertex.normal) {
      for (int axis = 0; axis < 3; ++axis) text_.field();
    }
    std::array<std::string_view, 7> room;
    const auto rest = before_texture(text_.fields(room), vertex);
    if (!vertex.colour) {
      more_behind_vertices_ += rest.empty() ? 0 : 1;
    } else if (const auto colour = text_.colour(rest)) {
      mesh_.add_vertex_colour(*colour);
    } else {
      ++other_colours_of_vertices_;
    }
  }

  using Fields = std::span<const std::string_view>;

  /// The fields after a vertex's position and normal, without its texture coordinates.
  static Fields before_texture(Fields fields, const OffVertex& vertex) {
    return vertex.texture ? fields.first(fields.size() - std::min<std::size_t>(2, fields.size()))
                          : fields;
  }

  /// Some programs write colours of vertices under a keyword without the C. The fields after each
  /// vertex are a colour if they are three or four numbers not below 0. If they are three
  /// numbers of length 1 at all vertices, they may be normals.
  static bool has_unannounced_colours(TextCursor text, const OffVertex& vertex, std::int64_t n) {
    if (vertex.colour) return false;
    bool may_be_normals = !vertex.normal;
    for (std::int64_t i = 0; i < n; ++i) {
      if (!text.next_filled_line()) return false;
      for (int k = 0; k < vertex.numbers() + (vertex.normal ? 3 : 0); ++k) text.field();
      std::array<std::string_view, 7> room;
      const auto rest = before_texture(text.fields(room), vertex);
      const bool are_numbers = (rest.size() == 3 || rest.size() == 4) &&
                               std::ranges::all_of(rest, [](std::string_view f) {
                                 const auto value = number<double>(f);
                                 return value && *value >= 0.0 && std::isfinite(*value);
                               });
      if (!are_numbers) return false;
      may_be_normals &= rest.size() == 3 && is_unit(*text.colour(rest));
    }
    return !may_be_normals;
  }

  void warn_of_what_was_left_out() {
    mesh_.warn_left_out(more_behind_vertices_,
                        "the numbers after {} vertex, which the keyword does not announce",
                        "the numbers after {} vertices, which the keyword does not announce");
    mesh_.warn_left_out(other_colours_of_vertices_,
                        "the colour of {} vertex, which is not three or four numbers",
                        "the colours of {} vertices, which are not three or four numbers");
    mesh_.warn_left_out(indexed_faces_, "the colour of {} face, which is an index into a map",
                        "the colours of {} faces, which are indices into a map");
    mesh_.warn_left_out(other_colours_of_faces_,
                        "the colour of {} face, which is not three or four numbers",
                        "the colours of {} faces, which are not three or four numbers");
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
    read_colour_of_face();
    mesh_.add_face(corners_);
  }

  /// A single number is an index into a colour map that the file does not have.
  void read_colour_of_face() {
    std::array<std::string_view, 5> room;
    const auto fields = text_.fields(room);
    const auto colour = text_.colour(fields);
    mesh_.use_colour(colour);
    if (colour || fields.empty()) return;
    const bool is_index = fields.size() == 1 && number<std::int64_t>(fields[0]);
    ++(is_index ? indexed_faces_ : other_colours_of_faces_);
  }

  TextCursor text_;
  MeshBuilder mesh_;
  bool with_normals_;
  std::vector<std::uint32_t> corners_;  // of the face that is read
  // Counts of elements with skipped contents:
  std::size_t more_behind_vertices_ = 0, other_colours_of_vertices_ = 0;
  std::size_t indexed_faces_ = 0, other_colours_of_faces_ = 0;
};

}  // namespace

Mesh read_off(const MeshFile& file) { return OffReader(file).read(); }

}  // namespace displayfile
