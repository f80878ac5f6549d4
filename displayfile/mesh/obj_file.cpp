// Wavefront OBJ: Alias|Wavefront, "Object Files (.obj)", Advanced Visualizer manual, appendix B1.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "displayfile/mesh/mesh_builder.h"
#include "displayfile/mesh/mesh_file.h"
#include "displayfile/mesh/obj_materials.h"
#include "displayfile/mesh/text_cursor.h"

namespace displayfile {

namespace {

/// The indices of OBJ faces: into the vertices, texture coordinates and normals so far, or those
/// that are still to come, as some exporters write them.
class ObjIndices {
 public:
  enum Kind { vertex, texture, normal };

  void define(Kind kind) { ++defined_[kind]; }

  /// A field's index, counted from 0; its element may follow later.
  std::uint32_t resolved(Kind kind, std::string_view field, const TextCursor& text) {
    return resolved(kind, text.integer(field, "an index"), text.offset(field), text);
  }
  std::uint32_t resolved(Kind kind, std::int64_t index, std::size_t at, const TextCursor& text) {
    if (index < 0 && index >= -defined_[kind]) {
      return static_cast<std::uint32_t>(defined_[kind] + index);
    }
    if (index <= 0) fail(kind, at, index, text);
    if (index > defined_[kind]) look_ahead(kind, index, at);
    return static_cast<std::uint32_t>(index - 1);
  }

  /// Texture coordinates are not drawn: a missing one is not an error.
  void note_texture(std::string_view field, const TextCursor& text) {
    const std::int64_t index = text.integer(field, "an index");
    if (index > defined_[texture]) {
      look_ahead(texture, index, text.offset(field));
    } else if (index == 0 || index < -defined_[texture]) {
      if (!missing_texture_) {
        missing_texture_ = {text.offset(field), message(texture, index)};
      }
    }
  }

  void check_all_defined(const TextCursor& text) const {
    for (const Kind kind : {vertex, normal}) {
      for (const auto& [index, at] : ahead_[kind]) {
        if (index > defined_[kind]) fail(kind, at, index, text);
      }
    }
  }

  /// The position of the first reference to a missing texture coordinate, and the message about it.
  std::optional<std::string> missing_texture(const TextCursor& text) const {
    std::optional<Missing> first = missing_texture_;
    for (const auto& [index, at] : ahead_[texture]) {
      if (index <= defined_[texture] || (first && first->at < at)) continue;
      first = Missing{at, message(texture, index)};
      break;
    }
    if (!first) return std::nullopt;
    return fmt::format("{}: {}: the face is drawn without", text.place(first->at), first->what);
  }

 private:
  struct Ahead {
    std::int64_t index;
    std::size_t at;
  };
  struct Missing {
    std::size_t at;
    std::string what;
  };

  /// Records only an index larger than all before it: no other can be the first error.
  void look_ahead(Kind kind, std::int64_t index, std::size_t at) {
    auto& ahead = ahead_[kind];
    if (ahead.empty() || index > ahead.back().index) ahead.push_back({index, at});
  }

  [[noreturn]] void fail(Kind kind, std::size_t at, std::int64_t index,
                         const TextCursor& text) const {
    text.fail(at, message(kind, index));
  }

  std::string message(Kind kind, std::int64_t index) const {
    constexpr std::array names = {"vertex", "texture coordinate", "normal"};
    const std::string what = fmt::format("{} index {} out of range: ", names[kind], index);
    if (defined_[kind] == 0) return what + fmt::format("no {} was given", names[kind]);
    return what + fmt::format("expected 1 to {0} or -{0} to -1", defined_[kind]);
  }

  std::array<std::int64_t, 3> defined_{};
  std::array<std::vector<Ahead>, 3> ahead_;
  std::optional<Missing> missing_texture_;  // one that no later texture coordinate can define
};

/// Statements that do not affect the positions of polygons, and parts of those of curves and
/// surfaces.
constexpr std::string_view kOfNoPolygons[] = {
    "s",         "vp",     "mg",     "bevel",  "c_interp", "d_interp", "lod",   "shadow_obj",
    "trace_obj", "usemap", "maplib", "cstype", "deg",      "bmat",     "step",  "parm",
    "trim",      "hole",   "scrv",   "sp",     "end",      "con",      "ctech", "stech"};

class ObjReader {
 public:
  explicit ObjReader(const MeshFile& file)
      : text_(text_of(file.path, file.data)),
        mesh_(file.path),
        materials_(file.path),
        with_normals_(file.with_normals) {}

  Mesh read() && {
    do {
      read_statement(text_.field());
    } while (text_.next_line());
    indices_.check_all_defined(text_);
    if (auto missing = indices_.missing_texture(text_)) mesh_.warn(std::move(*missing));
    warn();
    materials_.tell(mesh_);
    mesh_.note_rounding(text_.rounding_of_coordinates());
    return std::move(mesh_).finish();
  }

 private:
  void read_statement(std::string_view keyword) {
    switch (keyword.size() == 1 ? keyword[0] : '\0') {
      case 'v': read_vertex(); break;
      case 'f': read_face(); break;
      case 'l':
        read_corners();
        if (!corners_.empty()) mesh_.skip_points_and_lines(corners_.size() - 1);
        break;
      case 'p':
        read_corners();
        mesh_.skip_points_and_lines(corners_.size());
        break;
      case 'o': begin_object(text_.rest_of_line()); break;
      case 'g': begin_group(text_.rest_of_line()); break;
      default: read_longer_statement(keyword);
    }
  }

  void read_longer_statement(std::string_view keyword) {
    if (keyword == "vt") {
      indices_.define(ObjIndices::texture);
    } else if (keyword == "vn") {
      read_normal();
    } else if (keyword == "fo") {
      read_face();
    } else if (keyword == "usemtl") {
      use_material(text_.rest_of_line());
    } else if (keyword == "mtllib") {
      materials_.add_library(text_.rest_of_line());
    } else if (keyword == "curv" || keyword == "curv2" || keyword == "surf") {
      ++curves_;
    } else if (TextCursor::is_content(keyword) &&
               std::ranges::find(kOfNoPolygons, keyword) == std::end(kOfNoPolygons)) {
      if (unknown_++ == 0) first_unknown_ = keyword;
    }
  }

  /// Warns of contents that a mesh does not have.
  void warn() {
    mesh_.warn_left_out(curves_, "{} curve or surface", "{} curves and surfaces");
    if (unknown_ > 0) {
      mesh_.warn(fmt::format("{}: {}: not read: {}", text_.place(text_.offset(first_unknown_)),
                             TextCursor::quoted(first_unknown_),
                             unknown_ == 1 ? "the line is left out"
                                           : fmt::format("{} such lines are left out", unknown_)));
    }
    if (!extra_.empty()) {
      mesh_.warn(fmt::format("{}: {}: expected a weight or a colour after a vertex: left out",
                             text_.place(text_.offset(extra_)), TextCursor::quoted(extra_)));
    }
  }

  void read_face() {
    read_corners();
    if (!corners_.empty()) mesh_.add_face(corners_, normals_);
  }

  /// Reads x y z, then nothing, a weight w, or a colour r g b.
  void read_vertex() {
    const Point3 p = text_.position();
    std::array<std::string_view, 5> fields;
    const auto rest = text_.fields(fields);
    mesh_.add_vertex(rest.size() == 1 ? text_.over_weight(p, rest[0]) : p);
    if (const auto colour = text_.colour(rest)) {
      mesh_.add_vertex_colour(*colour);
    } else if (rest.size() > 1 && extra_.empty()) {
      extra_ = rest[0];
    }
    indices_.define(ObjIndices::vertex);
  }

  void read_normal() {
    indices_.define(ObjIndices::normal);
    if (with_normals_) mesh_.add_normal(text_.direction());
  }

  void read_corners() {
    corners_.clear();
    normals_.clear();
    for (;;) {
      while (const auto index = text_.next_digits()) {
        corners_.push_back(indices_.resolved(ObjIndices::vertex, index->value, index->at, text_));
        if (with_normals_) normals_.push_back(Mesh::kNoNormal);
      }
      const std::string_view f = text_.field();
      if (!TextCursor::is_content(f)) return;
      read_corner(f);
    }
  }

  /// Reads vertex, vertex/texture, vertex//normal or vertex/texture/normal.
  void read_corner(std::string_view corner) {
    if (with_normals_) normals_.push_back(Mesh::kNoNormal);
    for (const auto kind : {ObjIndices::vertex, ObjIndices::texture, ObjIndices::normal}) {
      const std::size_t slash = std::min(corner.find('/'), corner.size());
      const std::string_view field = corner.substr(0, slash);
      if (kind == ObjIndices::texture) {
        if (!field.empty()) indices_.note_texture(field, text_);
      } else if (!field.empty()) {
        const std::uint32_t index = indices_.resolved(kind, field, text_);
        if (kind == ObjIndices::vertex) corners_.push_back(index);
        if (kind == ObjIndices::normal && with_normals_) normals_.back() = index;
      } else if (kind == ObjIndices::vertex) {
        text_.fail(corner, fmt::format("{}: expected a vertex index", TextCursor::quoted(corner)));
      }
      if (slash == corner.size()) return;
      corner.remove_prefix(slash + 1);
    }
    text_.fail(corner, "expected at most three indices, vertex/texture/normal");
  }

  /// An empty name stands for no material.
  void use_material(std::string_view name_as_written) {
    const std::string_view name = without_quotation_marks(name_as_written);
    mesh_.use_material(name.empty() ? Mesh::kNoMaterial : materials_.named(name, mesh_));
  }

  /// An object whose name is repeated is continued.
  void begin_object(std::string_view name) {
    if (name.empty()) return;
    group_.clear();
    const auto [known, is_new] = objects_.try_emplace(std::string(name), 0);
    if (is_new) {
      known->second = mesh_.begin_object(name);
    } else {
      mesh_.go_on_with(known->second);
    }
  }

  /// A group with a name other than the current one begins an object, even if the name is repeated.
  void begin_group(std::string_view name) {
    if (name == group_) return;
    group_ = name;
    objects_.try_emplace(std::string(name), mesh_.begin_object(name));
  }

  TextCursor text_;
  MeshBuilder mesh_;
  ObjMaterials materials_;
  bool with_normals_;
  ObjIndices indices_;
  std::vector<std::uint32_t> corners_, normals_;  // of the face that is read
  std::map<std::string, std::size_t> objects_;    // the first of each name
  std::string group_;
  std::size_t curves_ = 0, unknown_ = 0;
  std::string_view first_unknown_, extra_;  // extra words after a vertex
};

}  // namespace

Mesh read_obj(const MeshFile& file) { return ObjReader(file).read(); }

}  // namespace displayfile
