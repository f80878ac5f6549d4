#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "clip/point.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile::bench {

/// Polygons as the sort gets them, in normalised device coordinates: the same, point for point, for
/// us and for our peers.
struct DeviceScene {
  std::string name;
  std::vector<Point3> points;
  std::vector<std::uint8_t> visible;
  std::vector<Primitives::Item> polygons;

  void add(const Point3* polygon, std::size_t sides);
  Primitives items() const { return {points, {}, visible, polygons}; }
  std::size_t size() const { return polygons.size(); }
};

/// A mesh of triangles, each face of more sides cut into a fan, in the view that the command fits
/// to it.
struct Model {
  std::string path, name;  ///< the name is the file's, without its extension
  DeviceScene all;         ///< front and back faces
  /// The faces that the command enters: without back faces if the mesh is closed and consistently
  /// oriented, and otherwise the same as `all`.
  DeviceScene entered;
  bool closed;
};
/// Throws Error if the file cannot be read.
Model read_model(const std::string& path);

/// A generated scene (programs/scenes/generated_scenes.h) of about n polygons, without back-face
/// removal.
DeviceScene generated(const std::string& name, std::size_t n);

/// A sphere of about n triangles, front and back: a convex surface, on which each polygon's plane
/// has all others on one side.
DeviceScene sphere(std::size_t n);

/// The number of others that a polygon's extents overlap in the projection, averaged over a sample.
double overlaps_per_polygon(const DeviceScene& scene);

}  // namespace displayfile::bench
