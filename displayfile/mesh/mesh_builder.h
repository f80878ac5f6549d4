#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/mesh_file.h"

namespace displayfile {

/// Indexed values in order of first occurrence, with few duplicates: a repeated value finds its
/// index unless another with the same hash slot came in between. Thus few distinct values stay few,
/// and many need no search.
template <class Value>
class Palette {
 public:
  std::uint32_t number(const Value& value, std::uint64_t hash) {
    if (slots_.empty()) slots_.resize(kSlots, 0);
    std::uint32_t& slot = slots_[hash % kSlots];
    if (slot < values_.size() && values_[slot] == value) return slot;
    slot = static_cast<std::uint32_t>(values_.size());
    values_.push_back(value);
    return slot;
  }

  const std::vector<Value>& values() const { return values_; }
  std::vector<Value>&& take() && { return std::move(values_); }

 private:
  static constexpr std::size_t kSlots = 4096;

  std::vector<Value> values_;
  std::vector<std::uint32_t> slots_;  // last index by the hash's low bits
};

/// True if the corners have at least three distinct positions; otherwise the face is degenerate.
bool has_three_positions(std::span<const Point3> vertices, std::span<const std::uint32_t> corners);

/// Builds a mesh while its file is read. Corners and normals may refer to elements not read yet;
/// the reader must provide them all before the end.
class MeshBuilder {
 public:
  /// `path` names the file in messages and must outlive the builder. Faces before any object belong
  /// to an unnamed one.
  explicit MeshBuilder(std::string_view path);

  /// Begins a new object for faces from here on. Objects keep their order of creation.
  std::size_t begin_object(std::string_view name);
  /// Continues an object that was begun before.
  void go_on_with(std::size_t object);

  /// Reserves capacity for the known sizes of the file.
  void reserve(std::size_t vertices, std::size_t faces);
  void add_vertex(const Point3& position);
  /// A normal of any length; a non-finite one counts as unknown.
  void add_normal(const Point3& normal);
  /// `normals`, if any, are one per corner; Mesh::kNoNormal: unknown. A face of fewer than three
  /// corners counts as a point or a line.
  void add_face(std::span<const std::uint32_t> corners,
                std::span<const std::uint32_t> normals = {});
  void skip_points_and_lines(std::size_t n) { mesh_.skipped.points_and_lines += n; }

  /// Adds a material and returns its index. Its contents may be set later.
  std::uint32_t add_material(const Mesh::Material& material = {});
  void set_material(std::uint32_t index, const Mesh::Material& material) {
    mesh_.materials[index] = material;
  }
  /// Sets the material of faces from here on, or none (Mesh::kNoMaterial).
  void use_material(std::uint32_t index) { material_ = index; }
  /// Sets the own colour of faces from here on; nothing: no own colour.
  void use_colour(const std::optional<Rgba>& colour);
  /// Sets the colour of the vertex added last.
  void add_vertex_colour(const Rgba& colour);
  /// Records the largest rounding error of the file's numbers.
  void note_rounding(double rounding) { mesh_.rounding = std::max(mesh_.rounding, rounding); }
  /// Coordinates are rounded to single precision.
  void set_single_precision() { is_in_single_precision_ = true; }
  /// Adds a warning about lost contents, one sentence.
  void warn(std::string sentence) { mesh_.skipped.warnings.push_back(std::move(sentence)); }

  /// Warns of skipped contents, in the singular or plural, each with a {} for the count; no effect
  /// if it is 0.
  void warn_left_out(std::size_t count, std::string_view one, std::string_view many);
  /// Warns of lines after all announced contents, if there are any.
  void warn_of_lines_left(std::size_t lines);

  std::size_t vertices() const { return mesh_.vertices.size(); }
  std::size_t normals() const { return mesh_.normals.size(); }

  /// Normals belong to the vertices of equal index, not to corners.
  void share_normals_as_vertices() { normals_as_vertices_ = true; }

  /// Removes degenerate faces and objects without faces, and orders the faces by object. Faces
  /// without an own colour get their material's times the mean of their vertices' colours, where
  /// known. Throws Error if no face is left.
  Mesh finish() &&;

 private:
  /// Successive faces of one object in the file.
  struct Run {
    std::size_t object, first_face, end_face = 0;
  };

  [[noreturn]] void fail_without_faces() const;
  void find_rounding();
  bool is_degenerate(std::size_t face) const;
  bool has_degenerate_faces() const;
  /// Keeps the faces that are not degenerate, in the order of the runs.
  void gather_faces();
  void name_objects();
  /// The mean of the corners' known colours.
  std::optional<Rgba> mean_colour(std::size_t face) const;
  /// True if corners whose colours are known have different ones.
  bool corners_differ_in_colour(std::size_t face) const;
  void mix_in_colours_of_vertices();
  void give_faces_materials();

  std::string_view path_;
  Mesh mesh_;
  std::vector<std::string> names_;  // of the objects
  std::vector<Run> runs_;
  bool normals_as_vertices_ = false, is_in_single_precision_ = false;
  std::uint32_t material_ = Mesh::kNoMaterial;  // current material or colour
  Palette<Rgba> face_colours_;                  // if not empty, face_materials are indices into it
  std::vector<Rgba> vertex_colours_;            // of the vertices so far; kNoColour if unknown
};

}  // namespace displayfile
