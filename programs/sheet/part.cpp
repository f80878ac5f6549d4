#include "programs/sheet/part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <glm/geometric.hpp>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "clip/geometry/secret_hash.h"
#include "clip/geometry/unit.h"
#include "displayfile/mesh/up_axis.h"
#include "displayfile/mesh/welded_faces.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "displayfile/text/characters.h"
#include "displayfile/user_routines/system_inside.h"
#include "programs/inputs/inputs.h"
#include "programs/inputs/not_solid.h"
#include "programs/inputs/planes_of_inputs.h"
#include "programs/inputs/segment_names.h"
#include "programs/process/progress.h"
#include "programs/process/warnings.h"
#include "programs/sheet/closed_pieces.h"
#include "programs/sheet/segment_origins.h"

namespace displayfile {

namespace {

/// The up axis that a program sets, if it is a coordinate axis.
std::optional<Upright> upright_of(const View& view) {
  constexpr std::string_view kAxes[] = {"x", "y", "z", "-x", "-y", "-z"};
  const Point3 up = unit(view.up);
  for (const std::string_view axis : kAxes) {
    const Upright standing = upright(axis);
    if (standing.up == up) return standing;
  }
  return std::nullopt;
}

/// The up axis of the view in which a program has drawn, otherwise of the one that it leaves in
/// force.
std::optional<Upright> upright_of(const GraphicsSystem& system, const RetainedScene& scene,
                                  std::size_t segments_before) {
  if (!system.explicit_settings().contains(Setting::camera)) return std::nullopt;
  const auto drawn = std::span(scene.segments()).subspan(segments_before);
  return upright_of(drawn.empty() ? system.view() : drawn.front().view);
}

/// Which axis is up is not only the mesh's matter, but also of the transformation that turns it.
std::optional<Upright> enter_mesh_file(const std::string& input, const ImportLimits& limits,
                                       std::size_t index, GraphicsSystem& system,
                                       SegmentOrigins& origins) {
  const Mesh mesh = [&] {
    const NamedWarnings named(input);
    return read_mesh(input, false, limits);
  }();
  report_skipped(std::span(&input, 1), std::span(&mesh.skipped, 1));
  MeshOptions options;
  options.sides_drawn = options.hidden_sides_drawn = true;
  naming_mesh(input, [&] { enter_meshes(std::span(&mesh, 1), system, options); });
  origins.add_mesh(mesh, index, system);
  if (!mesh.upright) return std::nullopt;
  return nearest_upright(system.modelling_transformation().apply_to_difference(mesh.upright->up));
}

/// The names of parts that come from these segments.
std::vector<NamedPart> named_parts(std::span<const SegmentOrigin> origins,
                                   std::span<const std::string> inputs) {
  std::vector<std::size_t> parts_of_input(inputs.size(), 0);
  for (const SegmentOrigin& origin : origins) ++parts_of_input[origin.input];
  std::vector<NamedPart> parts;
  for (const SegmentOrigin& origin : origins) {
    const std::string input = drawable(std::filesystem::path(inputs[origin.input]).stem().string());
    std::string name =
        origin.segment ? fmt::format("{}:{}", input, *origin.segment) : drawable(origin.object);
    if (parts_of_input[origin.input] == 1 || name.empty()) name = input;
    parts.push_back({input, std::move(name)});
  }
  return parts;
}

/// The visible polygons, without lines and texts, of which a warning tells, with the scene's
/// segments as the mesh's objects and the part's parts.
Part polygons_of(const RetainedScene& scene, const DisplayFile& display_file,
                 const SegmentOrigins& origins, std::span<const std::string> inputs) {
  std::vector<SegmentOrigin> of_parts;
  std::vector<NotSolid> left_out(inputs.size());
  Part part;
  Mesh& mesh = part.mesh;
  mesh.first_corner.push_back(0);
  for (const RetainedScene::Segment& segment : scene.segments()) {
    if (!display_file.segment(segment.name).visible) continue;
    NotSolid& not_drawn = left_out[origins.of(segment.name).input];
    not_drawn.texts += scene.texts(segment).size();
    const std::size_t first_face = mesh.faces(), first_vertex = mesh.vertices.size();
    mesh.set_reach(std::max(entered_reach(mesh), scene.reach_in_world(segment)));
    const auto points = scene.points(segment);
    mesh.vertices.insert(mesh.vertices.end(), points.begin(), points.end());
    for (std::uint32_t i = segment.first; i < segment.end; ++i) {
      if (!scene.draws(i)) continue;
      if (scene[i].is_line()) {
        ++not_drawn.lines;
        continue;
      }
      for (std::uint32_t k = 0; k < scene[i].sides; ++k) {
        const std::size_t point = scene.has_shared() ? scene.corners(i)[k] : scene[i].first + k;
        mesh.corners.push_back(
            static_cast<std::uint32_t>(first_vertex + point - segment.first_point));
        part.side_visible.push_back(scene.edge_visible(i, k) ? 1 : 0);
      }
      mesh.first_corner.push_back(mesh.corners.size());
      part.fill_of_face.push_back(scene[i].look);
    }
    if (mesh.faces() == first_face) continue;
    mesh.objects.push_back({"", first_face, mesh.faces() - first_face});
    of_parts.push_back(origins.of(segment.name));
    for (const TurnedShape& shape : of_parts.back().turned) {
      if (const auto axis = shape.axis_at(points)) part.axes.push_back(*axis);
    }
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (const std::string words = left_out[i].words(); !words.empty()) {
      warnings() << fmt::format("{}: left out: {}\n", input_name(inputs[i]), words);
    }
  }
  part.parts = named_parts(of_parts, inputs);
  for (std::uint32_t look = 0; look < scene.fill_colours().size(); ++look) {
    FillStyle& fill =
        part.fills.emplace_back(scene.all_attributes()[scene.attributes_of_look(look)].fill);
    fill.colour = scene.fill_colours()[look];
  }
  return part;
}

/// Puts the objects of a part, which are its parts, in place of its closed pieces.
void divide_into_pieces(Part& part) {
  std::vector<std::size_t> first_face_of;
  for (const Mesh::Object& object : part.mesh.objects) first_face_of.push_back(object.first_face);
  const std::vector<MeshPiece> pieces = closed_pieces(part.mesh);
  part.mesh.objects.clear();
  for (const MeshPiece& piece : pieces) {
    part.mesh.objects.push_back({"", piece.first_face, piece.faces});
    part.is_closed.push_back(piece.closed ? 1 : 0);
    const auto after = std::ranges::upper_bound(first_face_of, piece.first_face);
    part.part_of.push_back(static_cast<std::uint32_t>(after - first_face_of.begin() - 1));
  }
}

/// Makes sides that only one polygon has visible: where cutting planes left the part open, a sheet
/// shows its end, though a picture has no line there. Diagonals and bridges to holes are used
/// twice.
void show_ends(Part& part) {
  if (std::ranges::all_of(part.side_visible, [](auto visible) { return visible != 0; })) return;
  const WeldedFaces faces = weld(part.mesh);
  std::unordered_map<std::uint64_t, std::size_t, SecretHash> alone;  // corners of sides, or kTwice
  constexpr auto kTwice = static_cast<std::size_t>(-1);
  std::size_t corner = 0;
  for (std::size_t i = 0; i < faces.faces(); ++i) {
    std::uint32_t from = faces.face(i).back();
    for (const std::uint32_t to : faces.face(i)) {
      const auto [low, high] = std::minmax(from, to);
      const std::uint64_t side = (std::uint64_t{low} << 32) | high;
      from = to;
      const std::size_t of_side = corner++;
      if (part.side_visible[of_side] != 0) continue;
      const auto [at, is_new] = alone.try_emplace(side, of_side);
      if (!is_new) at->second = kTwice;
    }
  }
  for (const auto& [side, of_side] : alone) {
    if (of_side != kTwice) part.side_visible[of_side] = 1;
  }
}

std::vector<KeptAnnotation> annotations_of(const RetainedScene& scene,
                                           const DisplayFile& display_file) {
  std::vector<KeptAnnotation> all;
  for (const RetainedScene::Segment& segment : scene.segments()) {
    if (!display_file.segment(segment.name).visible) continue;
    all.insert(all.end(), segment.annotations.begin(), segment.annotations.end());
  }
  return all;
}

}  // namespace

Part read_part(std::span<const std::string> inputs, const std::string& up,
               const ImportLimits& limits) {
  RetainedScene scene;
  GraphicsSystem system;
  SegmentOrigins origins;
  SystemInside::retain_alone(system, scene);
  PlanesOfInputs planes;
  std::optional<Upright> standing;
  if (!up.empty()) standing = upright(up);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const std::string& input = inputs[i];
    const Progress progress("reading " + input);
    std::optional<Upright> of_input;
    if (is_drawing_program(input)) {
      const std::size_t segments = scene.segments().size();
      const std::string program = read_text_file(input);
      for (const auto& [from, to] : make_room_for_names(program, system)) origins.rename(from, to);
      origins.replay_program(program, input_name(input), i, system);
      of_input = upright_of(system, scene, std::min(segments, scene.segments().size()));
    } else {
      of_input = enter_mesh_file(input, limits, i, system, origins);
    }
    planes.entered(i, system);
    if (!standing) standing = of_input;
  }
  planes.warn(inputs, system);
  Part part = polygons_of(scene, system.display_file(), origins, inputs);
  if (part.mesh.faces() == 0) {
    throw Error(fmt::format("{}: no polygons: expected a part to draw", inputs.front()));
  }
  part.annotations = annotations_of(scene, system.display_file());
  const Upright axes = standing.value_or(Upright{});
  const auto turn = [&](Point3& p) {
    p = {glm::dot(p, axes.right), glm::dot(p, axes.up), glm::dot(p, axes.front)};
  };
  std::ranges::for_each(part.mesh.vertices, turn);
  for (CentreAxis& axis : part.axes) {
    turn(axis.from);
    turn(axis.to);
  }
  for (KeptAnnotation& one : part.annotations) std::ranges::for_each(one.points, turn);
  show_ends(part);
  divide_into_pieces(part);
  return part;
}

}  // namespace displayfile
