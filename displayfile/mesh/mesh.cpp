#include "displayfile/mesh/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "clip/geometry/bounds.h"
#include "clip/pipeline/cutting_planes.h"
#include "clip/surfaces.h"
#include "clip/view/view_volume.h"
#include "displayfile/mesh/fitted_view.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/solids/solid_faces.h"
#include "displayfile/text/characters.h"
#include "displayfile/user_routines/system_inside.h"

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

/// The name of the mesh's first segment, after all names in use.
int first_segment_name(const Mesh& mesh, const GraphicsSystem& system) {
  const std::int64_t name = name_after_all_in_use(system.display_file());
  require_free_names(mesh, system, name);
  return static_cast<int>(name);
}

FillStyle solid(const Colour& colour) { return {FillStyle::Kind::solid, colour}; }

/// The fill styles of an object's faces: empty if all have the style in force, one style for all,
/// or one for each.
std::vector<FillStyle> fills_of(const Mesh& mesh, const Mesh::Object& object,
                                const FillStyle& in_force, const MeshOptions& options) {
  if (options.colour) return {solid(*options.colour)};
  if (mesh.face_materials.empty() || !options.file_colours) return {};
  const auto of_faces = std::span(mesh.face_materials).subspan(object.first_face, object.faces);
  const auto fill_of = [&](std::uint32_t material) {
    const bool coloured = material != Mesh::kNoMaterial && mesh.materials[material].colour;
    return coloured ? solid(*mesh.materials[material].colour) : in_force;
  };
  if (std::ranges::count(of_faces, of_faces[0]) == std::ssize(of_faces)) {
    return {fill_of(of_faces[0])};
  }
  std::vector<FillStyle> fills;
  fills.reserve(of_faces.size());
  for (const std::uint32_t material : of_faces) fills.push_back(fill_of(material));
  return fills;
}

/// The mesh with its faces reversed, each from the same first corner, for modelling transformations
/// that mirror.
Mesh turned_over(const Mesh& mesh) {
  Mesh turned = mesh;
  const auto reverse = [&](std::vector<std::uint32_t>& of_corners, std::size_t i) {
    if (of_corners.empty()) return;
    const auto place = [&](std::size_t corner) {
      return of_corners.begin() + static_cast<std::ptrdiff_t>(corner);
    };
    std::reverse(place(mesh.first_corner[i] + 1), place(mesh.first_corner[i + 1]));
  };
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    reverse(turned.corners, i);
    reverse(turned.corner_normals, i);
  }
  return turned;
}

/// Enters one polygon after another, each with its normals if there are any.
void enter_one_by_one(const Mesh& mesh, const Mesh::Object& object,
                      std::span<const FillStyle> fills, GraphicsSystem& system) {
  std::vector<Point3> polygon, normals;
  for (std::size_t i = object.first_face; i < object.first_face + object.faces; ++i) {
    if (!fills.empty()) {
      const FillStyle& fill = fills.size() == 1 ? fills[0] : fills[i - object.first_face];
      if (fill != system.looks().attributes.fill) system.set_fill_style(fill);
    }
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

/// The volume of an object (displayfile/solids/solid_faces.h); none unless each side of its faces
/// is used equally often in both directions.
std::optional<double> volume_if_closed(const Mesh& mesh, const Mesh::Object& object) {
  std::vector<std::uint32_t> corners, sides;
  for (std::size_t i = object.first_face; i < object.first_face + object.faces; ++i) {
    const auto face = mesh.face(i);
    corners.insert(corners.end(), face.begin(), face.end());
    sides.push_back(static_cast<std::uint32_t>(face.size()));
  }
  if (open_side(mesh.vertices, corners, sides)) return std::nullopt;
  return enclosed_volume(mesh.vertices, corners, sides);
}

/// Enters the polygons in one call, with the range of vertices from the object's first to its last.
/// An object whose few vertices are far apart in the array is entered one by one instead.
void enter_object(const Mesh& mesh, const Mesh::Object& object, std::span<const FillStyle> fills,
                  GraphicsSystem& system) {
  const std::size_t begin = mesh.first_corner[object.first_face];
  const std::size_t end = mesh.first_corner[object.first_face + object.faces];
  std::span<const std::uint32_t> corners = std::span(mesh.corners).subspan(begin, end - begin);
  const auto [low, high] = std::ranges::minmax(corners);
  const std::size_t vertices = std::size_t{high} - low + 1;
  if (!mesh.corner_normals.empty() || vertices > 2 * corners.size()) {
    const auto enter = [&] {
      SystemInside::keep_fill_style(system, [&] { enter_one_by_one(mesh, object, fills, system); });
    };
    const bool is_cut = SystemInside::cutting_planes(system).any();
    const bool may_be_solid = is_cut || SystemInside::takes_whole_solids(system);
    const auto volume = may_be_solid ? volume_if_closed(mesh, object) : std::nullopt;
    if (!volume) return enter();
    const bool mirrors = system.modelling_transformation().mirrors();
    return SystemInside::as_solid(system, enter, mirrors ? -*volume : *volume);
  }
  std::vector<std::uint32_t> from_low;
  if (low > 0) {
    from_low.assign(corners.begin(), corners.end());
    for (std::uint32_t& corner : from_low) corner -= low;
    corners = from_low;
  }
  std::vector<std::uint32_t> sides;  // none: all are triangles
  if (corners.size() > 3 * object.faces) {
    sides.reserve(object.faces);
    for (std::size_t i = object.first_face; i < object.first_face + object.faces; ++i) {
      sides.push_back(static_cast<std::uint32_t>(mesh.face(i).size()));
    }
  }
  system.polygons_abs_3({std::span(mesh.vertices).subspan(low, vertices), corners, sides, fills});
}

}  // namespace

std::vector<std::string> left_out(const Mesh::Skipped& skipped) {
  std::vector<std::string> all;
  const auto add = [&](std::size_t n, std::string_view what) {
    if (n > 0) all.push_back(fmt::format(fmt::runtime(what), n));
  };
  add(skipped.points_and_lines, "{} points and lines");
  add(skipped.degenerate_faces, "{} faces of fewer than 3 positions");
  add(skipped.textured_faces, "the textures of {} faces");
  add(skipped.transparent_faces, "the transparency of {} faces");
  return all;
}

void Mesh::set_reach(double reach) { rounding = reach / entered_reach(kUnlessSet, 1.0, 1.0); }

double entered_reach(const Mesh& mesh) {
  const double of_doubles = entered_reach(kUnlessSet, largest_coordinate(mesh.vertices));
  return std::max(of_doubles, entered_reach(kUnlessSet, mesh.rounding, 1.0));
}

namespace {

/// The object's name as far as its characters can be drawn.
std::string title_of(const Mesh::Object& object) {
  return drawable(std::string_view(object.name).substr(0, GraphicsSystem::kLongestText));
}

}  // namespace

void enter_mesh(const Mesh& as_read, GraphicsSystem& system, int first_segment_name,
                const MeshOptions& options) {
  const RoundToNearest nearest;
  require_no_open_segment(system);
  require_free_names(as_read, system, first_segment_name);
  const bool mirrored = system.modelling_transformation().mirrors();
  const Mesh turned = mirrored ? turned_over(as_read) : Mesh();
  const Mesh& mesh = mirrored ? turned : as_read;
  const auto enter_objects = [&] {
    int next = first_segment_name;
    for (const Mesh::Object& object : mesh.objects) {
      if (!object.name.empty()) SystemInside::comment(system, object.name);
      system.open_segment(next);
      if (const std::string title = title_of(object); !title.empty()) {
        system.set_segment_title(next, title);
      }
      ++next;
      enter_object(mesh, object, fills_of(mesh, object, system.looks().attributes.fill, options),
                   system);
      system.close_segment();
    }
  };
  system.enter_segments([&] {
    if (mesh.rounding > 0.0)
      return SystemInside::with_automatic_reach(system, entered_reach(mesh), enter_objects);
    enter_objects();
  });
}

namespace {

/// Ambient light: enough that no visible face is nearly black, and the three visible faces of a
/// cube differ.
constexpr double kAmbient = 0.45;

Point3 over_left_shoulder(const GraphicsSystem& system) {
  // The rows of the view-plane transformation are the viewer's right, up and back.
  const glm::dmat4 axes = glm::transpose(ViewVolume(system.view()).view_plane());
  return Point3(axes[2]) + 0.55 * Point3(axes[1]) - 0.45 * Point3(axes[0]);
}

/// True if back faces are needed: removed faces cast no shadows, and have no hidden sides to draw.
bool needs_back_faces(const GraphicsSystem& system, const MeshOptions& options) {
  return system.looks().attributes.shadows || options.hidden_sides_drawn ||
         system.hidden_surfaces().hidden_lines != HiddenLines::none;
}

void bring_light(GraphicsSystem& system) {
  SystemInside::by_default(system, Setting::light,
                           [&] { system.set_light(over_left_shoulder(system), kAmbient); });
}

const LineKindStyle& style_of_hatching(const Attributes& attributes) {
  return attributes.line.of_kinds.of(StyledLines::hatch);
}

void bring_styles(GraphicsSystem& system, const MeshOptions& options) {
  SystemInside::by_default(system, Setting::fill_style,
                           [&] { system.set_fill_style(solid(kNeutral)); });
  const bool shows_lines =
      system.hidden_surfaces().removal && shows_lines_only(system.hidden_surfaces().method);
  const bool sides_drawn =
      options.sides_drawn || shows_lines || system.explicit_settings().contains(Setting::lines);
  SystemInside::by_default(system, Setting::line_style, [&] {
    system.set_line_style({sides_drawn ? LineStyle::Kind::solid : LineStyle::Kind::none});
    // Hatching that is set is drawn on a mesh whose sides are not.
    if (!sides_drawn && system.looks().cut_faces.kind == CutFaces::Kind::hatched &&
        style_of_hatching(system.looks().attributes) == LineKindStyle{}) {
      system.set_line_kind_style(StyledLines::hatch, {.kind = LineStyle::Kind::solid});
    }
  });
}

void restore_styles(GraphicsSystem& system, const Attributes& before) {
  SystemInside::by_default(system, Setting::fill_style,
                           [&] { system.set_fill_style(before.fill); });
  SystemInside::by_default(system, Setting::line_style,
                           [&] { system.set_line_style(before.line); });
  if (style_of_hatching(system.looks().attributes) != style_of_hatching(before)) {
    system.set_line_kind_style(StyledLines::hatch, style_of_hatching(before));
  }
}

/// Sets the defaults of settings that the application has not set.
void bring_defaults(GraphicsSystem& system, const MeshOptions& options) {
  bring_light(system);
  bring_styles(system, options);
  SystemInside::by_default(system, Setting::hidden_line_removal, [&] {
    const bool back_face_removal = system.looks().attributes.back_face_removal;
    const bool was_set = system.explicit_settings().contains(Setting::back_face_removal);
    system.set_hidden_surfaces({.removal = true});
    if (was_set) system.set_back_face_removal(back_face_removal);
  });
}

/// True if a cutting plane cuts away a part of the object.
bool is_cut(const Mesh& mesh, const Mesh::Object& object, const GraphicsSystem& system) {
  const CuttingPlanes& planes = SystemInside::cutting_planes(system);
  for (std::size_t i = object.first_face; i < object.first_face + object.faces; ++i) {
    for (const std::uint32_t corner : mesh.face(i)) {
      const Point3 world = system.modelling_transformation().apply(mesh.vertices[corner]);
      if (planes.outcode(world) != 0) return true;
    }
  }
  return false;
}

}  // namespace

std::size_t objects_cut_open(const Mesh& mesh, const GraphicsSystem& system) {
  const RoundToNearest nearest;
  if (system.looks().cut_faces.kind == CutFaces::Kind::open) return 0;
  if (!SystemInside::places(system).empty()) return 0;
  return static_cast<std::size_t>(
      std::ranges::count_if(mesh.objects, [&](const Mesh::Object& object) {
        return is_cut(mesh, object, system) && !volume_if_closed(mesh, object);
      }));
}

Point3 mesh_light(const GraphicsSystem& system) {
  const RoundToNearest nearest;
  return over_left_shoulder(system);
}

void with_mesh_looks(GraphicsSystem& system, const MeshOptions& options,
                     const std::function<void()>& enter) {
  const RoundToNearest nearest;
  const Attributes before = system.looks().attributes;
  bring_light(system);
  bring_styles(system, options);
  try {
    enter();
  } catch (...) {
    restore_styles(system, before);
    throw;
  }
  restore_styles(system, before);
}

void enter_meshes(std::span<const Mesh> meshes, GraphicsSystem& system,
                  const MeshOptions& options) {
  const RoundToNearest nearest;
  require_no_open_segment(system);
  const Attributes before = system.looks().attributes;
  MeshOptions entering = options;
  entering.file_colours &= !system.explicit_settings().contains(Setting::fill_style);
  bring_defaults(system, options);
  for (const Mesh& mesh : meshes) {
    SystemInside::by_default(system, Setting::back_face_removal, [&] {
      system.set_back_face_removal(!needs_back_faces(system, options) &&
                                   closed_and_consistently_oriented(mesh));
    });
    enter_mesh(mesh, system, first_segment_name(mesh, system), entering);
  }
  restore_styles(system, before);
}

void enter_empty_segments(const Mesh& mesh, GraphicsSystem& system) {
  const RoundToNearest nearest;
  int name = first_segment_name(mesh, system);
  for (std::size_t i = 0; i < mesh.objects.size(); ++i) {
    system.open_segment(name++);
    system.close_segment();
  }
}

ImportedMeshes import_meshes(std::span<const std::string> paths, GraphicsSystem& system,
                             const MeshOptions& options) {
  const RoundToNearest nearest;
  require_no_open_segment(system);
  if (options.colour) GraphicsSystem{}.set_fill_style(solid(*options.colour));  // or refuses
  std::vector<Mesh> meshes;
  std::int64_t name = name_after_all_in_use(system.display_file());
  for (const std::string& path : paths) {
    const bool smooth = system.looks().attributes.shading != Shading::flat;
    meshes.push_back(read_mesh(path, smooth, options.import_limits));
    if (smooth) complete_normals(meshes.back(), system);
    require_free_names(meshes.back(), system, name);
    name += static_cast<std::int64_t>(meshes.back().objects.size());
  }
  if (meshes.empty()) return {};
  ImportedMeshes imported;
  system.all_or_nothing([&] {
    if (!system.explicit_settings().contains(Setting::window)) {
      const bool has_camera = system.explicit_settings().contains(Setting::camera);
      const CommonUpright upright = fit_view(meshes, system, options.camera);
      if (upright.differ()) meshes.front().skipped.warnings.emplace_back(kStandDifferently);
      if (!has_camera) imported.fitted = upright.upright();
    }
    enter_meshes(meshes, system, options);
  });
  imported.skipped.reserve(meshes.size());
  for (Mesh& mesh : meshes) imported.skipped.push_back(std::move(mesh.skipped));
  return imported;
}

ImportedMeshes import_meshes(std::span<const std::string> paths, GraphicsSystem& system,
                             double aspect) {
  const RoundToNearest nearest;
  const double before = system.aspect_ratio();
  system.set_aspect_ratio(aspect);
  try {
    return import_meshes(paths, system);
  } catch (...) {
    system.set_aspect_ratio(before);
    throw;
  }
}

Mesh::Skipped import_mesh(const std::string& path, GraphicsSystem& system,
                          const MeshOptions& options) {
  const RoundToNearest nearest;
  return import_meshes(std::span(&path, 1), system, options).skipped.front();
}

Mesh::Skipped import_mesh(const std::string& path, GraphicsSystem& system, double aspect) {
  const RoundToNearest nearest;
  return import_meshes(std::span(&path, 1), system, aspect).skipped.front();
}

}  // namespace displayfile
