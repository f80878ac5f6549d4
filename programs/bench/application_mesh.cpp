#include "programs/bench/application_mesh.h"

#include <algorithm>

#include "clip/error.h"
#include "clip/planarity.h"
#include "displayfile/lighting.h"
#include "displayfile/turntable.h"
#include "interp/picture.h"
#include "programs/bench/contenders.h"
#include "programs/scenes/scene.h"

namespace displayfile::bench {

namespace {

void require(bool held, const char* why) {
  if (!held) throw CannotDraw{why};
}

/// The colour of its light face.
FillStyle colour_of(const RetainedScene& scene, std::uint32_t primitive) {
  const Attributes& attributes = scene.attributes(primitive);
  const WorldPolygon polygon = scene.polygon(primitive);
  require(polygon.vertex_normals.empty() && !attributes.shadows, "it is shaded");
  if (!attributes.light) return attributes.fill;
  return lit(attributes.fill, *attributes.light, polygon.normal, false);
}

void add(const RetainedScene& scene, std::uint32_t primitive, ApplicationMesh& mesh) {
  const auto polygon = scene.points(primitive);
  const auto sides = static_cast<std::uint32_t>(polygon.size());
  if (scene.has_shared()) {
    const auto corners = scene.corners(primitive);
    mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
  } else {
    for (const Point3& p : polygon) {
      mesh.corners.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back(p);
    }
  }
  mesh.sides.push_back(sides);
  mesh.fills.push_back(colour_of(scene, primitive));
}

std::vector<View> views_around(const RetainedScene& scene, const GraphicsSystem& system,
                               bool fitted) {
  std::vector<View> views;
  try {
    Turntable turntable(scene, system.display_file(), system.view());
    if (fitted) turntable.fit_window(ApplicationMesh::kViews);
    for (int k = 0; k < ApplicationMesh::kViews; ++k) {
      views.push_back(turntable.at(360.0 * k / ApplicationMesh::kViews).view);
    }
  } catch (const Error& error) {
    throw CannotDraw{error.what()};
  }
  return views;
}

}  // namespace

ApplicationMesh application_mesh(const BenchScene& scene) {
  RetainedScene retained;
  GraphicsSystem system;
  system.retain(&retained);
  scene.enter(system);
  const DisplayFile& file = system.display_file();
  for (const Segment& segment : file.segments()) {
    require(segment.image.is_identity(), "a segment has an image transformation");
    require(segment.visible, "a segment is invisible");
  }
  require(!file.has_texts(), "it has texts");
  ApplicationMesh mesh;
  for (const RetainedScene::Segment& segment : retained.segments()) {
    require(segment.view.viewport == View().viewport, "a view has a viewport of its own");
    if (!retained.has_shared()) continue;
    const auto points = retained.points(segment);
    mesh.vertices.insert(mesh.vertices.end(), points.begin(), points.end());
  }
  std::uint32_t removed = 0;
  for (std::uint32_t i = 0; i < retained.size(); ++i) {
    require(!retained[i].is_line() && retained.attributes(i).line.kind == LineStyle::Kind::none,
            "it has lines");
    if (!retained.draws(i)) continue;
    removed += retained.attributes(i).back_face_removal ? 1 : 0;
    add(retained, i, mesh);
  }
  require(!mesh.sides.empty(), "it has no polygons");
  require(removed == 0 || removed == mesh.sides.size(), "only some of its back faces are removed");
  mesh.back_faces_removed = removed > 0;
  mesh.views = views_around(retained, system, scene.kind == BenchScene::Kind::input);
  return mesh;
}

void enter(const ApplicationMesh& mesh, GraphicsSystem& system) {
  if (!system.display_file().segments().empty()) system.delete_segment(1);
  system.set_line_style({LineStyle::Kind::none});
  system.set_back_face_removal(mesh.back_faces_removed);
  system.open_segment(1);
  system.polygons_abs_3(mesh.vertices, mesh.corners, mesh.sides, mesh.fills);
  system.close_segment();
}

ColouredTriangles triangles_of(const ApplicationMesh& mesh) {
  ColouredTriangles made;
  Triangulation triangulation;
  std::vector<Point3> polygon;
  const std::uint32_t* corner = mesh.corners.data();
  for (std::size_t i = 0; i < mesh.sides.size(); ++i) {
    polygon.clear();
    for (std::uint32_t k = 0; k < mesh.sides[i]; ++k) polygon.push_back(mesh.vertices[*corner++]);
    for (const Triangulation::Triangle& t : triangulation.triangulate(polygon)) {
      for (const std::uint32_t v : t.vertex) made.corners.push_back(polygon[v]);
      made.colours.push_back(pixel_of(mesh.fills[i].colour));
    }
  }
  return made;
}

}  // namespace displayfile::bench
