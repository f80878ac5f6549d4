#include "tests/bench/command/application_mesh.h"

#include <algorithm>
#include <limits>

#include "clip/base/error.h"
#include "clip/geometry/equal_points.h"
#include "clip/view/view_volume.h"
#include "displayfile/looks/lighting.h"
#include "displayfile/views/turntable.h"
#include "hidden/triangles/triangulation.h"
#include "interp/device/picture.h"
#include "programs/scenes/scene.h"
#include "tests/bench/command/contenders.h"

namespace displayfile::bench {

namespace {

void require(bool held, const char* why) {
  if (!held) throw CannotDraw{why};
}

/// The colour of its light face.
FillStyle colour_of(const RetainedScene& scene, std::uint32_t primitive) {
  const Attributes attributes = scene.attributes(primitive);
  const WorldPolygon polygon = scene.polygon(primitive);
  require(polygon.vertex_normals.empty() && !attributes.shadows, "it is shaded");
  if (!attributes.light) return attributes.fill;
  return lit(attributes.fill, *attributes.light, polygon.normal, false);
}

/// The triangles of a polygon.
void add(const RetainedScene& scene, std::uint32_t primitive, Triangulation& triangulation,
         EqualPoints& vertices, ApplicationMesh& mesh) {
  const PointRow points = scene.points(primitive);
  const std::vector<Point3> polygon(points.begin(), points.end());
  const FillStyle fill = colour_of(scene, primitive);
  for (const Triangulation::Triangle& triangle : triangulation.triangulate(polygon)) {
    for (const std::uint32_t v : triangle.vertex) {
      mesh.corners.push_back(vertices.number_of(polygon[v]));
    }
    mesh.fills.push_back(fill);
  }
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
  }
  std::uint32_t removed = 0, drawn = 0;
  Triangulation triangulation;
  EqualPoints vertices(mesh.vertices, retained.primitives({}).all_corners());
  for (std::uint32_t i = 0; i < retained.size(); ++i) {
    require(
        !retained[i].is_line() && retained.shared_attributes(i).line.kind == LineStyle::Kind::none,
        "it has lines");
    if (!retained.draws(i)) continue;
    removed += retained.shared_attributes(i).back_face_removal ? 1 : 0;
    ++drawn;
    add(retained, i, triangulation, vertices, mesh);
  }
  require(!mesh.fills.empty(), "it has no polygons");
  if (std::ranges::count(mesh.fills, mesh.fills.front()) == std::ssize(mesh.fills)) {
    mesh.fills.resize(1);
  }
  require(removed == 0 || removed == drawn, "only some of its back faces are removed");
  mesh.back_faces_removed = removed > 0;
  mesh.views = views_around(retained, system, scene.kind == BenchScene::Kind::input);
  return mesh;
}

void enter(const ApplicationMesh& mesh, GraphicsSystem& system) {
  if (!system.display_file().segments().empty()) system.delete_segment(1);
  system.set_line_style({LineStyle::Kind::none});
  system.set_back_face_removal(mesh.back_faces_removed);
  system.open_segment(1);
  system.polygons_abs_3({mesh.vertices, mesh.corners, {}, mesh.fills});
  system.close_segment();
}

IndexedTriangles indexed_triangles(const ApplicationMesh& mesh) {
  std::vector<Point3> corners;
  corners.reserve(mesh.corners.size());
  for (const std::uint32_t corner : mesh.corners) corners.push_back(mesh.vertices[corner]);
  std::vector<std::uint32_t> colours(mesh.triangles(), pixel_of(mesh.fills.front().colour));
  for (std::size_t i = 1; i < mesh.fills.size(); ++i) colours[i] = pixel_of(mesh.fills[i].colour);
  return indexed_triangles(corners, colours);
}

glm::dmat4 opengl_matrix(const View& view, const ApplicationMesh& mesh) {
  const ViewVolume volume(view);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Point3& vertex : mesh.vertices) {
    const HomogeneousPoint p = volume.transform(vertex);
    const bool inside = p.w > 0.0 && p.x >= 0.0 && p.x <= p.w && p.y >= 0.0 && p.y <= p.w;
    if (!inside) continue;
    low = std::min(low, p.z / p.w);
    high = std::max(high, p.z / p.w);
  }
  if (!(low < high)) low = 0.0, high = 1.0;
  const double room = (high - low) / 16.0;
  low -= room;
  high += room;
  glm::dmat4 clip(0.0);  // clip[column][row]
  clip[0][0] = 2.0;
  clip[3][0] = -1.0;
  clip[1][1] = -2.0;
  clip[3][1] = 1.0;
  clip[2][2] = 2.0 / (high - low);
  clip[3][2] = -2.0 * low / (high - low) - 1.0;
  clip[3][3] = 1.0;
  return clip * volume.matrix();
}

}  // namespace displayfile::bench
