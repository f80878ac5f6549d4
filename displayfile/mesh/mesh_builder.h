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
#include "displayfile/mesh/mesh_colour.h"
#include "displayfile/mesh/palette.h"

namespace displayfile {

/// True if the corners have at least three different positions: a face that has not is degenerate.
bool has_three_positions(std::span<const Point3> vertices, std::span<const std::uint32_t> corners);

/// A mesh while its file is read. Corners and their normals may be named before what they refer to
/// was read; the reader sees to it that all of it is there at the end.
class MeshBuilder {
 public:
  /// Messages name the file by its path, which must outlive the builder. Faces before any object
  /// are of one without a name.
  explicit MeshBuilder(std::string_view path);

  /// The faces from here on are of this new object. Objects keep the order in which they began.
  std::size_t begin_object(std::string_view name);
  /// The faces from here on are of an object that began before.
  void go_on_with(std::size_t object);

  /// Makes room for what the file is known to hold.
  void reserve(std::size_t vertices, std::size_t faces);
  void add_vertex(const Point3& position);
  /// A normal of any length; one that is not finite is as good as unknown.
  void add_normal(const Point3& normal);
  /// `normals`, if there are any, go with the corners; Mesh::kNoNormal for one that is not known.
  /// A face of fewer than three corners counts as a point or a line.
  void add_face(std::span<const std::uint32_t> corners,
                std::span<const std::uint32_t> normals = {});
  void skip_points_and_lines(std::size_t n) { mesh_.skipped.points_and_lines += n; }

  /// A material, by its index: the next one. It may be told later what it looks like.
  std::uint32_t add_material(const Mesh::Material& material = {});
  void set_material(std::uint32_t index, const Mesh::Material& material) {
    mesh_.materials[index] = material;
  }
  /// The faces from here on are of this material, or of none (Mesh::kNoMaterial).
  void use_material(std::uint32_t index) { material_ = index; }
  /// The faces from here on have this colour of their own; nothing takes it back.
  void use_colour(const std::optional<Rgba>& colour);
  /// The colour of the vertex that was added last.
  void add_vertex_colour(const Rgba& colour);
  /// Coordinates may be off by so much, as the numbers of the file are rounded.
  void note_rounding(double rounding) { mesh_.rounding = std::max(mesh_.rounding, rounding); }
  /// Coordinates are rounded to single precision.
  void set_single_precision() { is_in_single_precision_ = true; }
  /// Something that the file lost, in a sentence.
  void warn(std::string sentence) { mesh_.skipped.warnings.push_back(std::move(sentence)); }

  /// Warns of what was left out, in the singular or the plural, each with a {} for the count; not
  /// where that is 0.
  void warn_left_out(std::size_t count, std::string_view one, std::string_view many);
  /// Warns of so many lines behind all that the file announces, if there are any.
  void warn_of_lines_left(std::size_t lines);

  std::size_t vertices() const { return mesh_.vertices.size(); }
  std::size_t normals() const { return mesh_.normals.size(); }

  /// Normals belong to the vertices of equal index, not to corners.
  void share_normals_as_vertices() { normals_as_vertices_ = true; }

  /// Leaves out degenerate faces and objects without faces, and puts the faces in the order of the
  /// objects. Gives faces without colours of their own that of their material times the mean of
  /// their vertices' colours, as far as there are any. Throws Error if no face is left.
  Mesh finish() &&;

 private:
  /// Faces that follow each other in the file and are of one object.
  struct Run {
    std::size_t object, first_face, end_face = 0;
  };

  void find_rounding();
  bool is_degenerate(std::size_t face) const;
  bool has_degenerate_faces() const;
  /// Keeps the faces that are not degenerate, in the order of the runs.
  void gather_faces();
  void name_objects();
  /// The mean of the corners' colours, those that have one.
  std::optional<Rgba> mean_colour(std::size_t face) const;
  void mix_in_colours_of_vertices();
  void give_faces_materials();

  std::string_view path_;
  Mesh mesh_;
  std::vector<std::string> names_;  // of the objects
  std::vector<Run> runs_;
  bool normals_as_vertices_ = false, is_in_single_precision_ = false;
  std::uint32_t material_ = Mesh::kNoMaterial;  // of the faces from here on, or the colour
  Palette<Rgba> face_colours_;                  // if there are any, what face_materials means
  std::vector<Rgba> vertex_colours_;            // of the vertices so far; kNoColour if unknown
};

}  // namespace displayfile
