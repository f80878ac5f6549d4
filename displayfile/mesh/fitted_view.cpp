#include "displayfile/mesh/fitted_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "clip/bounds.h"
#include "clip/error.h"
#include "clip/transformation.h"
#include "clip/view_volume.h"
#include "displayfile/mesh/fitted_window.h"

namespace displayfile {

namespace {

constexpr double kFromTheRight = 30.0;  // degrees
constexpr double kFromAbove = 20.0;
constexpr double kEyeDistance = 4.0;   // of the view plane, in radii of the scene
constexpr double kDepthMargin = 0.01;  // in radii, before and behind the scene

/// The positions that faces use, each vertex once.
std::vector<Point3> used_vertices(std::span<const Mesh> meshes) {
  std::vector<Point3> used;
  for (const Mesh& mesh : meshes) {
    std::vector<bool> is_used(mesh.vertices.size());
    for (const std::uint32_t corner : mesh.corners) is_used[corner] = true;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      if (is_used[v]) used.push_back(mesh.vertices[v]);
    }
  }
  return used;
}

Point3 toward_viewer() {
  const auto [sine_right, cosine_right] = sine_cosine_of_degrees(kFromTheRight);
  const auto [sine_above, cosine_above] = sine_cosine_of_degrees(kFromAbove);
  return {sine_right * cosine_above, sine_above, cosine_right * cosine_above};
}

/// Where the projector of a point meets the view plane (x, y), and the point's own z.
Point3 projected(const Point3& world, const glm::dmat4& view_plane, double eye_distance) {
  const Point3 p(view_plane * HomogeneousPoint(world, 1.0));
  const double w = 1.0 - p.z / eye_distance;
  return {p.x / w, p.y / w, p.z};
}

}  // namespace

void fit_view(std::span<const Mesh> meshes, GraphicsSystem& system, double aspect) {
  if (!(aspect > 0.0 && aspect <= kCoordinateLimit)) {
    throw Error(fmt::format("aspect ratio {}: expected a positive number", aspect));
  }
  Bounds scene;
  const std::vector<Point3> vertices = used_vertices(meshes);
  for (const Point3& p : vertices) scene.include(p);
  if (scene.empty()) throw Error("no faces to fit the view to");

  const Point3 centre = scene.middle();
  const double diagonal = glm::length(scene.high - scene.low);
  const double radius = diagonal > 0.0 ? 0.5 * diagonal : 1.0;
  const double eye_distance = kEyeDistance * radius;

  View view;
  view.set_reference_point(centre);
  view.set_plane_normal(-toward_viewer());
  view.set_perspective(centre + eye_distance * toward_viewer());
  view.set_depth(-radius, radius);
  view.set_window({-radius, radius, -radius, radius});
  const glm::dmat4 view_plane = ViewVolume(view).view_plane();

  Bounds seen;
  for (const Point3& p : vertices) seen.include(projected(p, view_plane, eye_distance));
  const Rectangle window = fitted_window(seen, aspect, kDepthMargin * radius);

  system.set_view_reference_point(view.reference_point);
  system.set_view_plane_normal(view.plane_normal);
  system.set_view_distance(view.distance);
  system.set_view_up(view.up);
  system.set_perspective(view.centre_of_projection);
  system.set_view_depth(-seen.high.z - kDepthMargin * radius, -seen.low.z + kDepthMargin * radius);
  system.set_front_plane_clipping(false);
  system.set_back_plane_clipping(false);
  system.set_window(window.x_min, window.x_max, window.y_min, window.y_max);
  system.set_viewport(0.0, 1.0, 0.0, 1.0);

  // The rows of the view-plane transformation are the viewer's right, up and back.
  const glm::dmat4 axes = glm::transpose(view_plane);
  system.set_light(Point3(axes[2]) + 0.6 * Point3(axes[1]) - 0.5 * Point3(axes[0]), 0.25);
}

}  // namespace displayfile
