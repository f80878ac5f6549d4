#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "clip/geometry/secret_hash.h"
#include "displayfile/mesh/mesh_builder.h"

class Poly_Triangulation;
class TopLoc_Location;
class TopoDS_Face;

namespace displayfile {

/// The matrix of a location.
glm::dmat4 matrix_of(const TopLoc_Location& location);

/// Adds faces that BRepMesh has triangulated to the object that was begun last. Their vertices of
/// equal position are one vertex: the triangulations of neighbours have the same doubles along
/// their common edge.
class CadFaces {
 public:
  CadFaces(MeshBuilder& mesh, bool with_normals) : mesh_(mesh), with_normals_(with_normals) {}

  /// Begins an instance: no vertex is shared with the faces before.
  void begin(const glm::dmat4& to_world);
  /// A plane face with one outline is added as a polygon, any other as triangles. False if it has
  /// no triangulation.
  bool add(const TopoDS_Face& face);

 private:
  struct Corner {
    std::uint32_t vertex, normal;
  };

  std::uint32_t vertex(const Point3& p);
  void add_nodes(const TopoDS_Face& face, const Poly_Triangulation& triangulation,
                 const glm::dmat4& matrix);
  /// `numbers` of nodes.
  void add_polygon(std::span<const int> numbers, bool turned);

  MeshBuilder& mesh_;
  bool with_normals_;
  glm::dmat4 to_world_{1.0};
  std::unordered_map<Point3, std::uint32_t, SecretHash> vertices_;  // of the instance
  std::vector<Corner> nodes_;                                       // of the face
  std::vector<std::uint32_t> corners_, normals_;                    // of the polygon
};

}  // namespace displayfile
