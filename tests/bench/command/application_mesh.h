#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

#include "clip/view.h"
#include "displayfile/graphics_system.h"
#include "tests/bench/command/bench_scene.h"
#include "tests/bench/command/indexed_triangles.h"

namespace displayfile::bench {

/// A scene as an application holds it before it calls a library, and views of it: the input of both
/// sides of a comparison. Polygons are cut into triangles (hidden/triangles/triangulation.h), as
/// OpenGL requires, and vertices that are equal to the last bit are one.
struct ApplicationMesh {
  std::vector<Point3> vertices;        ///< world coordinates
  std::vector<std::uint32_t> corners;  ///< of the vertices, three a triangle
  /// Each triangle's colour, in the scene's light if it has one; one if all have the same.
  std::vector<FillStyle> fills;
  bool back_faces_removed = false;
  std::vector<View> views;  ///< evenly around the scene's middle; the first is the scene's own

  static constexpr int kViews = 8;
  std::size_t triangles() const { return corners.size() / 3; }
};

/// Throws CannotDraw, with the reason, for scenes other than polygons of one colour each in one
/// view: lines, texts, image transformations, back faces some of which are removed.
ApplicationMesh application_mesh(const BenchScene& scene);

/// Enters it as segment 1, replacing an existing one.
void enter(const ApplicationMesh& mesh, GraphicsSystem& system);

/// As OpenGL gets it, in world coordinates.
IndexedTriangles indexed_triangles(const ApplicationMesh& mesh);

/// A view's matrix for OpenGlMesh: from the view volume's homogeneous cube, over the part of its
/// depth where the mesh is, to OpenGL's clip coordinates; y downward.
glm::dmat4 opengl_matrix(const View& view, const ApplicationMesh& mesh);

}  // namespace displayfile::bench
