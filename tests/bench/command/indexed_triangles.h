#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"
#include "displayfile/segments/viewed_scene.h"

namespace displayfile::bench {

/// Triangles as an application keeps them for OpenGL: vertices in single precision that triangles
/// share, and flat colours, which OpenGL takes from a triangle's last vertex.
struct IndexedTriangles {
  struct Vertex {
    float x, y, z;
    std::uint32_t colour;  ///< as in Picture::pixels
  };
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three a triangle, in the order given, turning as given

  std::size_t size() const { return indices.size() / 3; }
};

/// Joins the corners that lie in the same place in single precision, as far as the triangles'
/// colours let it: a vertex stands last in triangles of one colour only. `corners` are three a
/// triangle.
IndexedTriangles indexed_triangles(std::span<const Point3> corners,
                                   std::span<const std::uint32_t> colours);

/// The fills of a viewed scene in OpenGL's clip coordinates except that y runs downward, as
/// OpenGlMesh takes them (tests/bench/command/opengl_mesh.h) with no other matrix; depths are
/// scaled to their range.
IndexedTriangles indexed_triangles(const ViewedScene& scene);

}  // namespace displayfile::bench
