#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// Faces of a mesh, with vertices merged that are equal or within reach of each other; only used
/// vertices.
struct WeldedFaces {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> corners;         ///< indices into vertices, as in the mesh
  std::span<const std::size_t> first_corner;  ///< the mesh's, per face; one extra entry at the end

  std::size_t faces() const { return first_corner.size() - 1; }
  std::span<const std::uint32_t> face(std::size_t i) const {
    return std::span(corners).subspan(first_corner[i] - first_corner[0],
                                      first_corner[i + 1] - first_corner[i]);
  }
};

/// Calls visit(from, to) for every edge of every face, except edges of length 0.
template <class Visit>
void for_each_edge(const WeldedFaces& faces, const Visit& visit) {
  for (std::size_t i = 0; i < faces.faces(); ++i) {
    std::uint32_t from = faces.face(i).back();
    for (const std::uint32_t to : faces.face(i)) {
      if (from != to) visit(from, to);
      from = to;
    }
  }
}

/// Welds all faces of a mesh, which must outlive them.
WeldedFaces weld(const Mesh& mesh, double reach = 0.0);

/// Unmatched sides of faces, with the ends of other such sides within reach between their own ends
/// (hidden/touching/vertices_within_reach.h).
class SidesWithVertices {
 public:
  SidesWithVertices(const WeldedFaces& faces, double reach);

  bool any() const { return !along_.empty(); }
  /// The vertices along a side, in order from its start to its end, excluding both.
  std::span<const std::uint32_t> along(std::uint32_t from, std::uint32_t to) const;

 private:
  struct Along {
    std::uint32_t from, to;
    std::vector<std::uint32_t> vertices;
  };
  std::vector<Along> along_;  // in order
};

/// Faces with corners added where vertices are along their sides.
class FacesWithCorners {
 public:
  FacesWithCorners(const WeldedFaces& faces, const SidesWithVertices& sides);
  FacesWithCorners(const FacesWithCorners&) = delete;
  FacesWithCorners& operator=(const FacesWithCorners&) = delete;

  const WeldedFaces& faces() const { return faces_; }

 private:
  std::vector<std::size_t> first_corner_;
  WeldedFaces faces_;
};

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
