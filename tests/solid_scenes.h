#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/retained_scene.h"
#include "displayfile/solids/solid_faces.h"

// The polygons that solids enter, in world coordinates.

namespace displayfile::test {

using EnterSolid = std::function<void(GraphicsSystem&)>;

/// The retained scene of one segment.
struct Entered {
  RetainedScene scene;
  GraphicsSystem system;

  explicit Entered(const EnterSolid& enter) {
    system.retain(&scene);
    system.open_segment(1);
    enter(system);
    system.close_segment();
  }
  Entered(const Entered&) = delete;
  Entered& operator=(const Entered&) = delete;

  /// Its polygons, with vertices of their own; lines are left out.
  Mesh mesh() const {
    Mesh mesh;
    mesh.first_corner.push_back(0);
    for (const std::uint32_t i : polygons()) {
      for (const Point3& p : scene.points(i)) {
        mesh.corners.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        mesh.vertices.push_back(p);
      }
      mesh.first_corner.push_back(mesh.corners.size());
    }
    if (mesh.faces() > 0) mesh.objects = {{"solid", 0, mesh.faces()}};
    return mesh;
  }
  std::vector<std::uint32_t> polygons() const {
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < scene.size(); ++i) {
      if (!scene[i].is_line()) all.push_back(i);
    }
    return all;
  }
  std::vector<std::uint32_t> lines() const {
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < scene.size(); ++i) {
      if (scene[i].is_line()) all.push_back(i);
    }
    return all;
  }
  /// The length of the sides of a polygon that are drawn.
  double drawn_length(std::uint32_t polygon) const {
    const auto points = scene.points(polygon);
    double sum = 0.0;
    for (std::uint32_t k = 0; k < points.size(); ++k) {
      const std::uint32_t before = k == 0 ? static_cast<std::uint32_t>(points.size()) - 1 : k - 1;
      if (scene.edge_visible(polygon, k)) sum += glm::length(points[k] - points[before]);
    }
    return sum;
  }
};

/// Bit for bit: each side is used as often in one direction as in the other.
inline bool is_closed(const Mesh& mesh) {
  std::vector<std::uint32_t> sides;
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    sides.push_back(static_cast<std::uint32_t>(mesh.face(i).size()));
  }
  return !open_side(mesh.vertices, mesh.corners, sides);
}

inline double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    const auto face = mesh.face(i);
    const Point3 origin = mesh.vertices[0];
    for (std::size_t k = 2; k < face.size(); ++k) {
      sum += glm::dot(
          mesh.vertices[face[0]] - origin,
          glm::cross(mesh.vertices[face[k - 1]] - origin, mesh.vertices[face[k]] - origin));
    }
  }
  return sum / 6.0;
}

}  // namespace displayfile::test
