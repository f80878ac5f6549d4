#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// The faces of a mesh as triangles, for programs that print or calculate: closed where the mesh
/// is.
struct SolidTriangles {
  static constexpr std::uint32_t kNoColour = 0xFFFFFFFFu;
  using Triangle = std::array<std::uint32_t, 3>;  ///< three different indices of vertices
  struct Object {
    std::string name;
    std::vector<Point3> vertices;  ///< used ones, with distinct positions
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> colours;  ///< of each triangle, an index into all, or kNoColour
    /// The number of sides without one in the opposite direction: 0 if it is closed.
    std::size_t open_sides = 0;
    std::size_t faces_without_area = 0;  ///< faces that have no triangle
    /// Faces that cross themselves: their triangles wind around each point as often as the face.
    std::size_t crossing_faces = 0;
  };
  std::vector<Object> objects;  ///< none without triangles
  std::vector<Colour> colours;
  std::size_t faces_without_area = 0;  ///< of all objects, also of those without triangles

  std::size_t triangles() const;
};

/// The triangles of a mesh, an object each. Vertices of equal position are one; where sides then
/// have no others beside them, so are those within entered_reach, and a vertex within reach of such
/// a side, between its ends, becomes a corner of its face. Objects whose open sides meet and that
/// are closed only together become one, with the first one's name (joined_objects.h). Closed shells
/// that are inside out are turned (turned_shells.h).
SolidTriangles solid_triangles(const Mesh& mesh);

/// The same with vertices rounded to single precision, as in STL. Vertices of one position become
/// one, and triangles that then have two corners of one are left out, which opens nothing.
struct SingleTriangles {
  SolidTriangles solid;
  std::size_t merged = 0;    ///< vertices
  std::size_t left_out = 0;  ///< triangles
};
/// Throws Error for a coordinate beyond single precision, and if nothing is left of an object.
SingleTriangles in_single_precision(const SolidTriangles& solid);

}  // namespace displayfile
