#include "tests/bench/device_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/common.hpp>
#include <numbers>
#include <span>

#include "displayfile/graphics_system.h"
#include "displayfile/mesh/fitted_view.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/display_file.h"
#include "programs/scenes/generated_scenes.h"

namespace displayfile::bench {

namespace {

/// Collects the polygons of a display file.
struct Collector {
  DeviceScene& scene;
  void fill(const FillStyle&) {}
  void line_style(const LineStyle&) {}
  void pick(int) {}
  void move(const Point3&) {}
  void line(const Point3&) {}
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t>) {
    scene.add(vertices.data(), vertices.size());
  }
};

DeviceScene collected(const std::string& name, const GraphicsSystem& system) {
  DeviceScene scene;
  scene.name = name;
  for (const Segment& segment : system.display_file().segments()) {
    segment.walk_entered_drawn(Collector{scene});
  }
  return scene;
}

Mesh in_triangles(const Mesh& mesh) {
  Mesh fans = mesh;
  fans.corners.clear();
  fans.first_corner = {0};
  for (Mesh::Object& object : fans.objects) {
    const std::size_t first = fans.faces();
    for (std::size_t i = object.first_face; i < object.first_face + object.faces; ++i) {
      const auto face = mesh.face(i);
      for (std::size_t k = 2; k < face.size(); ++k) {
        fans.corners.insert(fans.corners.end(), {face[0], face[k - 1], face[k]});
        fans.first_corner.push_back(fans.corners.size());
      }
    }
    object.first_face = first;
    object.faces = fans.faces() - first;
  }
  return fans;
}

DeviceScene viewed(const std::string& name, const Mesh& mesh, bool back_face_removal) {
  GraphicsSystem system;
  fit_view(std::span(&mesh, 1), system);
  system.set_line_style({LineStyle::Kind::none});
  system.set_back_face_removal(back_face_removal);
  enter_mesh(mesh, system, 1);
  return collected(name, system);
}

}  // namespace

void DeviceScene::add(const Point3* polygon, std::size_t sides) {
  polygons.push_back({static_cast<std::uint32_t>(points.size()), static_cast<std::uint32_t>(sides),
                      Primitives::Kind::solid});
  points.insert(points.end(), polygon, polygon + sides);
  visible.insert(visible.end(), sides, 0);
}

Model read_model(const std::string& path) {
  const Mesh mesh = read_mesh(path);
  const Mesh triangles = in_triangles(mesh);
  Model model{path,
              std::filesystem::path(path).stem().string(),
              {},
              {},
              closed_and_consistently_oriented(mesh)};
  model.all = viewed(model.name + ", all faces", triangles, false);
  model.entered = model.closed ? viewed(model.name + ", front faces", triangles, true) : model.all;
  return model;
}

DeviceScene generated(const std::string& name, std::size_t n) {
  return collected(name, displayfile::entered(generated_scene(name).make(n, 1)));
}

DeviceScene sphere(std::size_t n) {
  // Rings of quadrangles, each in two triangles; at the poles one of the two is degenerate.
  const auto rings = static_cast<std::size_t>(
      std::max(3.0, std::round(std::sqrt(static_cast<double>(n) / 4.0) + 0.5)));
  const std::size_t around = 2 * rings;
  const auto at = [&](std::size_t ring, std::size_t step) {
    const double down = std::numbers::pi * static_cast<double>(ring) / static_cast<double>(rings);
    const double round =
        2.0 * std::numbers::pi * static_cast<double>(step % around) / static_cast<double>(around);
    // The axis lies askew, so that no ring is seen from its edge.
    const double x = std::sin(down) * std::cos(round), y = std::cos(down);
    const double z = std::sin(down) * std::sin(round);
    return Point3(0.5 + 0.45 * x, 0.5 + 0.45 * (0.8 * y - 0.6 * z),
                  0.5 + 0.45 * (0.6 * y + 0.8 * z));
  };
  DeviceScene scene;
  scene.name = "sphere";
  for (std::size_t ring = 0; ring < rings; ++ring) {
    for (std::size_t step = 0; step < around; ++step) {
      const Point3 above[] = {at(ring, step), at(ring, step + 1), at(ring + 1, step + 1)};
      const Point3 below[] = {at(ring, step), at(ring + 1, step + 1), at(ring + 1, step)};
      if (ring > 0) scene.add(above, 3);
      if (ring + 1 < rings) scene.add(below, 3);
    }
  }
  return scene;
}

double overlaps_per_polygon(const DeviceScene& scene) {
  struct Box {
    Point2 low, high;
  };
  std::vector<Box> boxes;
  for (const Primitives::Item& polygon : scene.polygons) {
    Box box{Point2(scene.points[polygon.first]), Point2(scene.points[polygon.first])};
    for (std::uint32_t i = 1; i < polygon.sides; ++i) {
      const Point2 p(scene.points[polygon.first + i]);
      box = {glm::min(box.low, p), glm::max(box.high, p)};
    }
    boxes.push_back(box);
  }
  constexpr std::size_t kSample = 500;
  const std::size_t step = std::max<std::size_t>(1, boxes.size() / kSample);
  std::size_t sampled = 0, overlaps = 0;
  for (std::size_t i = 0; i < boxes.size(); i += step, ++sampled) {
    for (const Box& other : boxes) {
      overlaps += boxes[i].low.x < other.high.x && other.low.x < boxes[i].high.x &&
                  boxes[i].low.y < other.high.y && other.low.y < boxes[i].high.y;
    }
  }
  return sampled == 0 ? 0.0
                      : static_cast<double>(overlaps - sampled) / static_cast<double>(sampled);
}

}  // namespace displayfile::bench
