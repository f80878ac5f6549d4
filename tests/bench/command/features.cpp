#include "tests/bench/command/features.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "displayfile/graphics_system.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/views/retained_views.h"
#include "interp/device/interpreter.h"
#include "interp/device/raster_request.h"
#include "interp/draw/draw.h"
#include "interp/raster/software.h"
#include "interp/vector/svg_device.h"
#include "programs/scenes/generated_scenes.h"

namespace displayfile::bench {

namespace {

constexpr std::uint64_t kFeatureSeed = 1;
constexpr std::size_t kSegments = 4;
constexpr double kRoundoff = 1e-9;

/// Without exact decisions, which are a feature of their own.
void find_by(FeatureUse& use, HiddenMethod method) {
  use.surfaces.method = method;
  use.surfaces.precision = Precision{.exact = false, .roundoff = kRoundoff};
}

using Names = std::vector<std::string_view>;

Names both(Names a, const Names& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::vector<Feature> table() {
  using enum HiddenMethod;
  const Names sort{"hidden_surface_check", "SortTables",  "ComparePolys",
                   "SideBuffer",           "VertexTable", "separated_by_side_of",
                   "overlapping_pairs",    "Extent",      "FlatBoxes"};
  // Not all code compiled for Exact: where it equals that for Roundoff, compilers keep one
  // function, under either name.
  const Names exact_sort{"ExactNumber",   "ExactPoint",
                         "DefinedPoint",  "VertexTable<displayfile::Exact>",
                         "SortedPainter", "libgmp"};
  return {
      {"clipping at the window",
       "set-window",
       "",
       [](FeatureUse& u) { u.clipped_by_window = true; },
       {"ClipPipeline::clip_stage", "ClipPipeline::cut", "ViewVolume::inside_distance",
        "ViewVolume::snap"}},
      {"front and back clipping",
       "set-front-plane-clipping, set-back-plane-clipping",
       "",
       [](FeatureUse& u) { u.clipped_by_depth = true; },
       {"ClipPipeline::clip_stage", "ClipPipeline::cut", "ViewVolume::inside_distance",
        "ViewVolume::snap"}},
      {"cutting planes",
       "set-cutting-plane",
       "",
       [](FeatureUse& u) { u.cutting_planes = true; },
       {"CuttingPlanes::set", "CuttingPlanes::cut", "CuttingPlanes::outcode",
        "GraphicsSystem::State::enter_cut"}},
      {"perspective", "set-perspective", "", [](FeatureUse& u) { u.perspective = true; }, {}},
      {"modelling transformation",
       "rotate-z-3",
       "",
       [](FeatureUse& u) { u.modelling = true; },
       {"ModellingTransformation::", "sine_cosine_of_degrees"}},
      {"image transformation",
       "set-image-scale",
       "",
       [](FeatureUse& u) { u.image_transformation = true; },
       {"ImageMatrix::", "sine_cosine_of_degrees"}},
      {"polygons that are not flat",
       "polygon-abs-3",
       "",
       [](FeatureUse& u) { u.bent_polygons = true; },
       {"Triangulation::", "GraphicsSystem::State::enter_triangles"}},
      {"outlines beside the fill",
       "set-line-style solid",
       "",
       [](FeatureUse& u) { u.lines = LineStyle::Kind::solid; },
       {"LinePainter", "Painter::edges"}},
      {"dashes",
       "set-line-style dashed",
       "outlines beside the fill",
       [](FeatureUse& u) { u.lines = LineStyle::Kind::dashed; },
       {"fmod"}},
      {"a fill style for each polygon",
       "set-fill-style",
       "",
       [](FeatureUse& u) { u.colours = true; },
       {"GraphicsSystem::set_fill_style"}},
      {"pick identifiers that are set",
       "set-pick-id",
       "",
       [](FeatureUse& u) { u.pick_identifiers = true; },
       {"GraphicsSystem::set_pick_id"}},
      {"texts",
       "text",
       "",
       [](FeatureUse& u) { u.texts = true; },
       {"GraphicsSystem::text", "enter_text", "seen_texts", "TextPainter", "CairoText", "libcairo"},
       "what letters take is not ours"},
      {"back-face removal",
       "set-back-face-removal",
       "",
       [](FeatureUse& u) { u.back_face_removal = true; },
       {}},
      {"lighting",
       "set-light",
       "",
       [](FeatureUse& u) { u.light = true; },
       {"displayfile::lit", "displayfile::intensity", "GraphicsSystem::set_light"}},
      {"Gouraud shading",
       "set-shading, set-vertex-normals",
       "lighting",
       [](FeatureUse& u) { u.vertex_normals = true; },
       {"Gouraud", "set_vertex_normals", "world_normals", "ShadedVertex", "shaded_fill",
        "apply_to_normal", "IntensityPlane", "PixelShade"}},
      {"Phong shading",
       "set-shading phong, set-vertex-normals",
       "lighting",
       [](FeatureUse& u) {
         u.vertex_normals = true;
         u.shading = Shading::phong;
       },
       {"PhongNormals::clip", "PhongShade", "PaintPhong", "phong_fill", "clip_with_normals",
        "set_vertex_normals", "world_normals", "ShadedVertex", "apply_to_normal", "NormalPlane"}},
      {"shadows",
       "set-shadows",
       "lighting",
       [](FeatureUse& u) { u.shadows = true; },
       {"Shadows::", "ShadowedFill::", "shadow_on", "SpaceBoxes"}},
      {"sort at close-segment, bsp", "set-hidden-line-removal, set-hidden-method", "",
       [](FeatureUse& u) { find_by(u, bsp); }, both(sort, {"SortPolygons"})},
      {"sort at close-segment, depth sort", "set-hidden-line-removal, set-hidden-method", "",
       [](FeatureUse& u) { find_by(u, depth_sort); },
       both(sort, {"sort_by_depth", "DepthSort", "DrawingGraph", "find_cycles"})},
      {"map at close-segment",
       "set-hidden-line-removal, set-hidden-method",
       "",
       [](FeatureUse& u) { find_by(u, map); },
       {"hidden_surface_check", "visible_map", "map_in_order", "pieces_of_map", "SeenFaces",
        "EdgesAlongLine", "edges_on_sides", "edges_of_meetings", "CellGrid", "SideTable"}},
      {"scope all",
       "set-hidden-scope",
       "sort at close-segment, bsp",
       [](FeatureUse& u) { u.surfaces.scope = HiddenScope::all; },
       {"sort_together", "overlapping_groups"}},
      {"exact decisions of bsp", "set-precision exact", "sort at close-segment, bsp",
       [](FeatureUse& u) { u.surfaces.precision = Precision{}; }, exact_sort},
      {"exact decisions of depth sort", "set-precision exact", "sort at close-segment, depth sort",
       [](FeatureUse& u) { u.surfaces.precision = Precision{}; }, exact_sort},
      {"z-buffer",
       "set-z-buffer",
       "",
       [](FeatureUse& u) { find_by(u, z_buffer); },
       {"ZBuffer", "ViewedScene"}},
      {"exact decisions of the z-buffer",
       "set-precision exact",
       "z-buffer",
       [](FeatureUse& u) { u.surfaces.precision = Precision{}; },
       {}},
      {"scan line",
       "set-hidden-method scan-line",
       "",
       [](FeatureUse& u) { u.surfaces.method = scan_line; },
       {"ScanLine::", "ActivePolygons", "SpanSweep", "ViewedScene"}},
      {"scan line z-buffer",
       "set-hidden-method scan-line-z",
       "",
       [](FeatureUse& u) { u.surfaces.method = scan_line_z; },
       {"ScanLineZ", "DepthRow", "ViewedScene"}},
      {"subdivision",
       "set-hidden-method warnock",
       "",
       [](FeatureUse& u) { u.surfaces.method = warnock; },
       {"Warnock", "ViewedScene"}},
      {"ray casting",
       "set-hidden-method ray-cast",
       "",
       [](FeatureUse& u) { u.surfaces.method = ray_cast; },
       {"RayCast", "RayPacket", "PixelBoxes", "ViewedScene"}},
      {"the method that picks itself",
       "set-hidden-method auto",
       "",
       [](FeatureUse& u) { u.surfaces.method = automatic; },
       {"choose_method", "ViewedScene", "ZBuffer"}},
      {"item buffer", "--ids", "z-buffer", [](FeatureUse& u) { u.ids = true; }, {}},
      {"depths", "--depth", "z-buffer", [](FeatureUse& u) { u.depth = true; }, {}},
      {"antialiasing", "--samples 4", "", [](FeatureUse& u) { u.samples = 4; }, {"SampleAverage"}},
      {"vectors in place of pixels",
       "-o FILE.svg",
       "",
       [](FeatureUse& u) { u.svg = true; },
       {"SvgDevice", "VectorDevice", "libfmt"}},
      {"recording a drawing program",
       "GraphicsSystem::set_recorder",
       "",
       [](FeatureUse& u) { u.recorded = true; },
       {"Recorder::", "libfmt"}},
      {"retaining world coordinates",
       "GraphicsSystem::retain",
       "",
       [](FeatureUse& u) { u.retained = true; },
       {"RetainedScene"}},
      {"lines that are selected",
       "set-lines",
       "retaining world coordinates",
       [](FeatureUse& u) { u.selects_lines = true; },
       {"SideKinds", "SideTable"}},
      {"one tree for all views",
       "RetainedViews",
       "retaining world coordinates",
       [](FeatureUse& u) { u.world_tree = true; },
       {"RetainedViews", "WorldTree", "MovingEye"}},
      {"threads",
       "--threads 2",
       "exact decisions of the z-buffer",
       [](FeatureUse& u) { u.surfaces.threads = 2; },
       {"libtbb", "tbb::"},
       "threads share out the work as it comes"},
      {"OSMesa",
       "--device osmesa",
       "",
       [](FeatureUse& u) { u.osmesa = true; },
       {"OSMesa", "osmesa", "libglapi", "libLLVM"},
       "what it does is not ours"},
  };
}

/// Polygons reach out of the unit cube a little, and in perspective a little more.
void set_view(const FeatureUse& use, GraphicsSystem& system) {
  const double margin = use.clipped_by_window ? -0.2 : 0.2;
  system.set_window(-margin, 1.0 + margin, -margin, 1.0 + margin);
  system.set_view_depth(-0.8, -0.2);
  if (use.perspective) system.set_perspective({0.5, 0.5, 20.0});
  if (!use.clipped_by_depth) return;
  system.set_front_plane_clipping(true);
  system.set_back_plane_clipping(true);
}

void set_attributes(const FeatureUse& use, GraphicsSystem& system) {
  system.set_line_style({use.lines});
  if (use.modelling) system.rotate_z_3(1.0);
  if (use.cutting_planes) {
    system.set_cutting_plane(1, 1.0, 0.0, 0.0, -0.5);
    system.set_cutting_plane(2, 0.0, 1.0, 1.0, -1.0);
  }
  if (!use.surfaces.method) system.set_hidden_surfaces({.removal = false});  // in order of entry
  if (use.back_face_removal) system.set_back_face_removal(true);
  if (use.light) system.set_light({1.0, 2.0, 3.0});
  if (use.vertex_normals) system.set_shading(use.shading);
  if (use.shadows) system.set_shadows(true);
  if (!use.surfaces.method) return;
  if (use.surfaces.method == HiddenMethod::z_buffer) {
    system.set_hidden_surfaces({.z_buffer = true});
  } else {
    system.set_hidden_surfaces({.removal = true});
    system.set_back_face_removal(false);
    system.set_hidden_surfaces({.method = use.surfaces.method, .scope = use.surfaces.scope});
  }
  system.set_hidden_surfaces({.precision = use.surfaces.precision});
}

/// Any will do: those of a ball about the scene.
void make_normals(std::span<const Point3> vertices, std::vector<Point3>& normals) {
  normals.clear();
  for (const Point3& v : vertices) normals.push_back(v - Point3(0.5));
}

void enter_polygons(const FeatureUse& use, const Scene& scene, GraphicsSystem& system) {
  const std::size_t each = (scene.polygons() + kSegments - 1) / kSegments;
  std::vector<Point3> polygon, normals;
  const Point3* vertex = scene.points.data();
  for (std::size_t k = 0; k < scene.polygons(); vertex += scene.sides[k], ++k) {
    if (k % each == 0) {
      system.open_segment(static_cast<int>(k / each) + 1);
      if (use.texts) {
        system.move_abs_3(0.5, 0.5, 0.5);
        system.text("a");
      }
    }
    polygon.assign(vertex, vertex + scene.sides[k]);
    if (use.bent_polygons) {
      polygon.push_back(polygon.back() + Point3(0.01, 0.02, 0.03));
    }
    if (use.colours) {
      system.set_fill_style({FillStyle::Kind::solid, Colour(static_cast<double>(k % 64) / 64.0)});
    }
    if (use.pick_identifiers) system.set_pick_id(static_cast<int>(k * 7 % scene.polygons()));
    if (use.vertex_normals) {
      make_normals(polygon, normals);
      system.set_vertex_normals(normals);
    }
    system.polygon_abs_3(polygon);
    if ((k + 1) % each == 0 || k + 1 == scene.polygons()) system.close_segment();
  }
}

DrawOptions draw_options(const FeatureUse& use) {
  DrawOptions options;
  options.width = options.height = kFeaturePictureSize;
  if (use.ids) options.ids = "ids.npy";
  if (use.depth) options.depth = "depth.npy";
  if (use.osmesa) options.device = "osmesa";
  options.samples = use.samples;
  options.surfaces.threads = use.surfaces.threads;
  return options;
}

struct RecordedProgram {
  std::ostringstream text;
  Recorder recorder{text};
};

DisplayFile draw_tree(const GraphicsSystem& system, const RetainedScene& retained) {
  RetainedViews views(retained, system.display_file(), {});
  DisplayFile file = views.view(system.view());
  RasterRequest request;
  request.width = request.height = kFeaturePictureSize;
  request.sorted = true;
  draw_with_software(file, request);
  return file;
}

void draw_vectors(const DisplayFile& file) {
  SvgDevice device(kFeaturePictureSize, kFeaturePictureSize);
  interpret(file, device);
  std::ostringstream text;
  device.finish(text);
}

}  // namespace

const std::vector<Feature>& features() {
  static const std::vector<Feature> all = table();
  return all;
}

FeatureUse use_of(const Feature& feature) {
  const auto under = std::ranges::find(features(), feature.over, &Feature::name);
  FeatureUse use = under == features().end() ? FeatureUse{} : use_of(*under);
  feature.turn_on(use);
  return use;
}

Scene feature_scene(std::size_t polygons) {
  return generated_scene("soup").make(polygons, kFeatureSeed);
}

void draw_with(const FeatureUse& use, const Scene& scene, const LookAt& look) {
  GraphicsSystem system;
  std::optional<RetainedScene> retained;
  std::optional<RecordedProgram> program;
  if (use.retained) system.retain(&retained.emplace());
  if (use.selects_lines) system.set_hidden_surfaces({.lines = line_selection("outline,crease")});
  if (use.recorded) system.set_recorder(&program.emplace().recorder);
  set_view(use, system);
  set_attributes(use, system);
  enter_polygons(use, scene, system);
  if (use.image_transformation) {
    for (std::size_t s = 0; s < kSegments; ++s) {
      system.set_image_scale(static_cast<int>(s) + 1, 0.9, 0.9);
    }
  }
  const auto look_at = [&](const DisplayFile& drawn) {
    if (look) look(drawn);
  };
  if (use.world_tree) return look_at(draw_tree(system, *retained));
  if (use.svg) {
    draw_vectors(system.display_file());
    return look_at(system.display_file());
  }
  SortedDisplayFile kept;
  draw(system, draw_options(use), kept);
  look_at(kept.display_file());
}

}  // namespace displayfile::bench
