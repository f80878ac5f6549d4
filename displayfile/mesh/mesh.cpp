#include "displayfile/mesh/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "clip/error.h"
#include "displayfile/mesh/fitted_view.h"

namespace displayfile {

namespace {

constexpr Colour kNeutral(0.87, 0.85, 0.81);

void require_no_open_segment(const GraphicsSystem& system) {
  if (const auto open = system.open_segment_name()) {
    throw Error(fmt::format("segment already open: segment {}; close it first", *open));
  }
}

void require_free_names(const Mesh& mesh, const GraphicsSystem& system, std::int64_t first) {
  const std::int64_t last = first + static_cast<std::int64_t>(mesh.objects.size()) - 1;
  if (first < 1 || last > std::numeric_limits<int>::max()) {
    throw Error(
        fmt::format("segment names {} to {}: expected positive 32-bit numbers", first, last));
  }
  for (std::int64_t name = first; name <= last; ++name) {
    if (system.display_file().contains(static_cast<int>(name))) {
      throw Error(fmt::format("segment name in use: {}", name));
    }
  }
}

std::int64_t name_after_all_in_use(const DisplayFile& display_file) {
  std::int64_t largest = 0;
  for (const Segment& s : display_file.segments()) {
    largest = std::max<std::int64_t>(largest, s.name());
  }
  return largest + 1;
}

/// One polygon after another, each with its normals if there are some.
void enter_one_by_one(const Mesh& mesh, const Mesh::Object& object, GraphicsSystem& system) {
  std::vector<Point3> polygon, normals;
  for (std::size_t i = object.first_face; i < object.first_face + object.faces; ++i) {
    polygon.clear();
    for (const std::uint32_t corner : mesh.face(i)) polygon.push_back(mesh.vertices[corner]);
    if (!mesh.corner_normals.empty()) {
      normals.clear();
      for (std::size_t k = mesh.first_corner[i]; k < mesh.first_corner[i + 1]; ++k) {
        normals.push_back(mesh.normal(k));
      }
      system.set_vertex_normals(normals);
    }
    system.polygon_abs_3(polygon);
  }
}

/// The polygons at once, of those vertices between the first and the last that the object has. An
/// object whose few vertices lie far apart among all is entered one by one instead.
void enter_object(const Mesh& mesh, const Mesh::Object& object, GraphicsSystem& system) {
  const std::size_t begin = mesh.first_corner[object.first_face];
  const std::size_t end = mesh.first_corner[object.first_face + object.faces];
  std::vector<std::uint32_t> corners(mesh.corners.begin() + static_cast<std::ptrdiff_t>(begin),
                                     mesh.corners.begin() + static_cast<std::ptrdiff_t>(end));
  const auto [low, high] = std::ranges::minmax(corners);
  const std::size_t vertices = std::size_t{high} - low + 1;
  if (!mesh.corner_normals.empty() || vertices > 2 * corners.size()) {
    return enter_one_by_one(mesh, object, system);
  }
  for (std::uint32_t& corner : corners) corner -= low;
  std::vector<std::uint32_t> sides;
  for (std::size_t i = object.first_face; i < object.first_face + object.faces; ++i) {
    sides.push_back(static_cast<std::uint32_t>(mesh.face(i).size()));
  }
  system.polygons_abs_3(std::span(mesh.vertices).subspan(low, vertices), corners, sides);
}

}  // namespace

void enter_mesh(const Mesh& mesh, GraphicsSystem& system, int first_segment_name) {
  require_no_open_segment(system);
  require_free_names(mesh, system, first_segment_name);
  int next = first_segment_name;
  try {
    for (const Mesh::Object& object : mesh.objects) {
      system.open_segment(next++);
      enter_object(mesh, object, system);
      system.close_segment();
    }
  } catch (...) {
    if (system.open_segment_name()) system.close_segment();
    for (int name = first_segment_name; name < next; ++name) {
      if (system.display_file().contains(name)) system.delete_segment(name);
    }
    throw;
  }
}

Mesh::Skipped import_meshes(std::span<const std::string> paths, GraphicsSystem& system,
                            double aspect) {
  require_no_open_segment(system);
  std::vector<Mesh> meshes;
  std::int64_t name = name_after_all_in_use(system.display_file());
  std::int64_t end = name;
  for (const std::string& path : paths) {
    const bool smooth = system.shading() == Shading::gouraud;
    meshes.push_back(read_mesh(path, smooth));
    if (smooth) complete_normals(meshes.back());
    require_free_names(meshes.back(), system, end);
    end += static_cast<std::int64_t>(meshes.back().objects.size());
  }
  const bool bare = !system.view_was_set();
  if (bare && !meshes.empty()) {
    fit_view(meshes, system, aspect);
    system.create_transformation_3();
    system.set_fill_style({FillStyle::Kind::solid, kNeutral});
    system.set_line_style({LineStyle::Kind::none});
    system.set_hidden_line_removal(true);
  }
  Mesh::Skipped skipped;
  for (const Mesh& mesh : meshes) {
    if (bare) {  // removed faces would hide no light
      system.set_back_face_removal(!system.shadows() && closed_and_consistently_oriented(mesh));
    }
    enter_mesh(mesh, system, static_cast<int>(name));
    name += static_cast<std::int64_t>(mesh.objects.size());
    skipped.points_and_lines += mesh.skipped.points_and_lines;
    skipped.degenerate_faces += mesh.skipped.degenerate_faces;
  }
  return skipped;
}

Mesh::Skipped import_mesh(const std::string& path, GraphicsSystem& system, double aspect) {
  return import_meshes(std::span(&path, 1), system, aspect);
}

}  // namespace displayfile
