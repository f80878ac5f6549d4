#include "programs/sheet/part.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <utility>

#include "clip/error.h"
#include "displayfile/mesh/up_axis.h"
#include "displayfile/retained_scene.h"
#include "displayfile/text/drawing_program.h"
#include "programs/inputs.h"
#include "programs/progress.h"
#include "programs/sheet/closed_pieces.h"
#include "programs/warnings.h"

namespace displayfile {

namespace {

/// The axis that a program says is upright, if it is one.
std::optional<Upright> upright_of(const View& view) {
  constexpr std::string_view kAxes[] = {"x", "y", "z", "-x", "-y", "-z"};
  const Point3 up = unit(view.up);
  for (const std::string_view axis : kAxes) {
    const Upright standing = upright(axis);
    if (standing.up == up) return standing;
  }
  return std::nullopt;
}

Mesh polygons_of_program(const std::string& input) {
  RetainedScene scene;
  GraphicsSystem system;
  system.retain(&scene);
  replay_file(input, system);
  Mesh mesh;
  mesh.first_corner.push_back(0);
  for (std::uint32_t i = 0; i < scene.size(); ++i) {
    if (scene[i].is_line()) continue;
    for (std::uint32_t k = 0; k < scene[i].sides; ++k) {
      mesh.corners.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back(scene.points(i)[k]);
    }
    mesh.first_corner.push_back(mesh.corners.size());
  }
  mesh.objects = closed_pieces(mesh);
  if (system.said().contains(Setting::camera) && !scene.segments().empty()) {
    mesh.upright = upright_of(scene.segments().front().view);
  }
  return mesh;
}

void append_mesh(const Mesh& other, Mesh& all) {
  const auto vertex = static_cast<std::uint32_t>(all.vertices.size());
  const std::size_t corner = all.corners.size(), face = all.faces();
  all.vertices.insert(all.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const std::uint32_t c : other.corners) all.corners.push_back(vertex + c);
  for (std::size_t i = 1; i < other.first_corner.size(); ++i) {
    all.first_corner.push_back(corner + other.first_corner[i]);
  }
  for (const Mesh::Object& object : other.objects) {
    all.objects.push_back({object.name, face + object.first_face, object.faces});
  }
}

}  // namespace

Mesh read_part(std::span<const std::string> inputs, const std::string& up,
               const ImportLimits& limits) {
  Mesh part;
  part.first_corner.push_back(0);
  std::optional<Upright> standing;
  if (!up.empty()) standing = upright(up);
  for (const std::string& input : inputs) {
    const Progress progress("reading " + input);
    if (is_drawing_program(input)) {
      const Mesh mesh = polygons_of_program(input);
      if (!standing) standing = mesh.upright;
      append_mesh(mesh, part);
      continue;
    }
    const NamedWarnings named(input);
    const Mesh mesh = read_mesh(input, false, limits);
    report_skipped(std::span(&input, 1), std::span(&mesh.skipped, 1));
    if (!standing) standing = mesh.upright;
    append_mesh(mesh, part);
  }
  if (part.faces() == 0) {
    throw Error(fmt::format("{}: no polygons: expected a part to draw", inputs.front()));
  }
  const Upright axes = standing.value_or(Upright{});
  for (Point3& p : part.vertices) {
    p = {glm::dot(p, axes.right), glm::dot(p, axes.up), glm::dot(p, axes.front)};
  }
  return part;
}

}  // namespace displayfile
