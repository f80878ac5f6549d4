#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// Faces of a mesh, their vertices of equal position made one; only vertices that they use.
struct WeldedFaces {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> corners;         ///< indices into vertices, as in the mesh
  std::span<const std::size_t> first_corner;  ///< the mesh's, of each face; one more at the end

  std::size_t faces() const { return first_corner.size() - 1; }
  std::span<const std::uint32_t> face(std::size_t i) const {
    return std::span(corners).subspan(first_corner[i] - first_corner[0],
                                      first_corner[i + 1] - first_corner[i]);
  }
};

/// All faces of a mesh, which must outlive them.
WeldedFaces weld(const Mesh& mesh);

/// Welds the faces of one object at a time, in the order of the objects.
class WeldedObjects {
 public:
  explicit WeldedObjects(const WeldedFaces& all) : all_(all), number_(all.vertices.size(), kNone) {}

  WeldedFaces operator()(const Mesh::Object& object);

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  const WeldedFaces& all_;
  std::vector<std::uint32_t> number_;  // of all vertices, among an object's; none between calls
};

}  // namespace displayfile
