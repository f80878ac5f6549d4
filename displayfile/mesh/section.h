#pragma once

#include <vector>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// The points p with normal . p = distance. The normal need not be of length 1, but not 0.
struct SectionPlane {
  Point3 normal{0.0, 0.0, 1.0};
  double distance = 0.0;
};

/// What a plane cuts of a mesh (section.md). World coordinates.
struct Section {
  /// In side_of: a side along the plane, and one that no side of the mesh is part of.
  static constexpr std::size_t kInPlane = static_cast<std::size_t>(-1), kNoSide = kInPlane - 1;

  /// Closed polylines in the plane: counterclockwise around what is solid, seen from where the
  /// normal points, clockwise around holes. Empty if nothing is cut, or the mesh is not closed.
  std::vector<std::vector<Point3>> loops;
  /// Which of the mesh's objects each loop is of; if objects are only closed together, the number
  /// of all objects.
  std::vector<std::size_t> object_of;
  double area = 0.0;  ///< of the cut face
  /// The part of the mesh behind the plane. What is left of a flat face is one face, even-odd, its
  /// loops joined by bridges; of one that is not flat, triangles and what is left of
  /// them. What is cut ends at the loops' points, bit for bit. The cut face is not among its faces.
  /// Its objects are the mesh's: some may have no face left.
  Mesh behind;
  std::vector<std::size_t> face_of;  ///< of each face behind, which of the mesh it is a part of
  /// What the side is that ends at each corner behind: the mesh's corner at which the side ends
  /// that it is a part of; kInPlane; or kNoSide for a bridge, or a diagonal.
  std::vector<std::size_t> side_of;
  bool closed = true;  ///< each edge is used as often in one direction as in the other
};

/// Cuts a mesh. Each object has its own loops if each is closed by itself; faces are even-odd, and
/// may have bridges. A vertex in the plane counts as before it: what is behind is
/// closed by the loops, and a face in the plane is cut exactly where there is solid behind it.
/// Throws Error for a normal of no length, or numbers that are not finite.
Section section(const Mesh& mesh, const SectionPlane& plane);

}  // namespace displayfile
