#include "programs/command/export_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <ostream>
#include <span>
#include <string_view>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "displayfile/entered/kept_annotation.h"
#include "displayfile/mesh/solid_triangles.h"
#include "displayfile/mesh/write_mesh.h"
#include "displayfile/segments/display_file.h"
#include "programs/inputs/assembled_inputs.h"
#include "programs/inputs/input_names.h"
#include "programs/inputs/not_solid.h"
#include "programs/inputs/output_paths.h"
#include "programs/process/progress.h"
#include "programs/process/warnings.h"

namespace displayfile {

CLI::App& ExportCommand::add_to(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "export", "Write the polygons of drawing programs and meshes as solids, to be printed");
  add_inputs(command, "INPUT", inputs, "drawing programs (.draw, or -) and meshes");
  command
      .add_option("-o,--output", output,
                  "the solids: .stl (binary, single precision), .obj (with colours in .mtl beside "
                  "it), .ply (binary, double precision) or .3mf")
      ->type_name("OUT.{stl,obj,ply,3mf}")
      ->required();
  import.add_to(command);
  return command;
}

namespace {

/// The title that is set; of a mesh it is its object's name.
std::string name_of(const RetainedScene::Segment& segment, const AssembledInputs& assembled) {
  const std::string& title = assembled.system.display_file().segment(segment.name).title();
  if (!title.empty()) return title;
  const std::string& object = assembled.opening(segment).object;
  return object.empty() ? fmt::format("segment {}", segment.name) : object;
}

void count(std::span<const KeptAnnotation> annotations, NotSolid& left_out) {
  using Kind = KeptAnnotation::Kind;
  for (const KeptAnnotation& one : annotations) {
    switch (one.kind) {
      case Kind::leader: ++left_out.leaders; break;
      case Kind::balloon: ++left_out.balloons; break;
      case Kind::linear:
      case Kind::diameter:
      case Kind::radius:
      case Kind::angle: ++left_out.dimensions; break;
      case Kind::title: ++left_out.titles; break;
      case Kind::list: ++left_out.lists; break;
    }
  }
}

/// The visible filled polygons of inputs, an object for each segment.
Mesh filled_polygons(const AssembledInputs& assembled, NotSolid& left_out) {
  const RetainedScene& scene = assembled.scene;
  Mesh mesh;
  mesh.first_corner.push_back(0);
  std::map<std::uint32_t, std::uint32_t> material_of_look;
  double reach = 0.0;
  for (const RetainedScene::Segment& segment : scene.segments()) {
    if (!assembled.is_visible(segment)) continue;
    left_out.texts += scene.texts(segment).size();
    count(segment.annotations, left_out);
    const std::size_t first_face = mesh.faces(), first_vertex = mesh.vertices.size();
    const auto points = scene.points(segment);
    mesh.vertices.insert(mesh.vertices.end(), points.begin(), points.end());
    for (std::uint32_t i = segment.first; i < segment.end; ++i) {
      if (scene[i].is_line()) {
        ++left_out.lines;
        continue;
      }
      if (scene.shared_attributes(i).fill.kind != FillStyle::Kind::solid) {
        ++left_out.hollow;
        continue;
      }
      for (std::uint32_t k = 0; k < scene[i].sides; ++k) {
        const std::size_t point = scene.has_shared() ? scene.corners(i)[k] : scene[i].first + k;
        mesh.corners.push_back(
            static_cast<std::uint32_t>(first_vertex + point - segment.first_point));
      }
      mesh.first_corner.push_back(mesh.corners.size());
      const auto next = static_cast<std::uint32_t>(mesh.materials.size());
      const auto [material, is_new] = material_of_look.try_emplace(scene[i].look, next);
      if (is_new) mesh.materials.push_back({.colour = scene.fill_colour(i)});
      mesh.face_materials.push_back(material->second);
    }
    if (mesh.faces() == first_face) continue;
    reach = std::max(reach, scene.reach_in_world(segment));
    mesh.objects.push_back({name_of(segment, assembled), first_face, mesh.faces() - first_face});
  }
  if (reach > 0.0) mesh.set_reach(reach);
  return mesh;
}

void warn_of_open(const std::string& output, const SolidTriangles& solid) {
  for (const SolidTriangles::Object& object : solid.objects) {
    if (object.open_sides == 0) continue;
    warnings() << fmt::format(
        "{}: {} is not closed: {} no face beside {}: programs that print refuse it, or close it in "
        "their own way\n",
        output, object.name,
        counted(object.open_sides, "side of a triangle has", "sides of triangles have"),
        object.open_sides == 1 ? "it" : "them");
  }
}

void warn_of_crossing(const std::string& output, const SolidTriangles& solid) {
  for (const SolidTriangles::Object& object : solid.objects) {
    if (object.crossing_faces == 0) continue;
    warnings() << fmt::format(
        "{}: {}: {}, as drawn by the even-odd rule: its volume counts each part as often as they "
        "wind around it\n",
        output, object.name,
        counted(object.crossing_faces, "polygon crosses itself and is not cut",
                "polygons cross themselves and are not cut"));
  }
}

void warn_of_rounding(const std::string& output, const SingleTriangles& single) {
  if (single.merged == 0 && single.left_out == 0) return;
  warnings() << fmt::format(
      "{}: in single precision {} on others, and {} left out: .ply, .obj and .3mf keep them\n",
      output, counted(single.merged, "vertex lies", "vertices lie"),
      counted(single.left_out, "triangle without area is", "triangles without area are"));
}

}  // namespace

int ExportCommand::run() {
  const std::vector<std::string> lists = input_lists(inputs);
  inputs = input_names(inputs);
  require_no_field(output);
  const std::vector<std::string> files = files_of_mesh(output);
  require_files_of_their_own(files, inputs, lists);
  NotSolid left_out;
  SolidTriangles solid;
  {
    const AssembledInputs assembled(inputs, import.limits());
    assembled.planes.warn(inputs, assembled.system);
    const Progress progress("finding the triangles of " + inputs.front());
    const Mesh mesh = filled_polygons(assembled, left_out);
    if (mesh.faces() == 0) {
      throw Error(fmt::format("{}: no filled polygons: expected solids to export",
                              input_name(inputs.front())));
    }
    solid = solid_triangles(mesh);
    left_out.without_area = solid.faces_without_area;
  }
  if (solid.objects.empty()) {
    throw Error(fmt::format("{}: all polygons are without area: expected solids to export",
                            input_name(inputs.front())));
  }
  if (extension_of(output) == ".stl") {
    SingleTriangles single;
    try {
      single = in_single_precision(solid);
    } catch (const Error& e) {
      throw Error(fmt::format("{}: {}: expected .ply, .obj or .3mf", output, e.what()));
    }
    warn_of_rounding(output, single);
    solid = std::move(single.solid);
  }
  write_mesh(solid, output);
  if (const std::string words = left_out.words(); !words.empty()) {
    warnings() << fmt::format("{}: left out: {}\n", output, words);
  }
  warn_of_crossing(output, solid);
  warn_of_open(output, solid);
  return 0;
}

}  // namespace displayfile
