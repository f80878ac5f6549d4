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
  /// Closed polylines in the plane: counterclockwise around what is solid, seen from where the
  /// normal points, clockwise around holes. Empty if nothing is cut, or the mesh is not closed.
  std::vector<std::vector<Point3>> loops;
  double area = 0.0;  ///< of the cut face
  /// The part of the mesh behind the plane. What is left of a flat face is one face, even-odd, its
  /// loops joined by bridges; of one that is not flat, triangles and what is left of
  /// them. What is cut ends at the loops' points, bit for bit. The cut face is not among its faces.
  Mesh behind;
  bool closed = true;  ///< each edge is used as often in one direction as in the other
};

/// Cuts a mesh. Each object has its own loops if each is closed by itself; faces are even-odd, and
/// may have bridges. A vertex in the plane counts as before it: what is behind is
/// closed by the loops, and a face in the plane is cut exactly where there is solid behind it.
/// Throws Error for a normal of no length, or numbers that are not finite.
Section section(const Mesh& mesh, const SectionPlane& plane);

}  // namespace displayfile
