#pragma once

#include <vector>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// The points p with normal . p = distance. The normal need not be of length 1, but not 0.
struct SectionPlane {
  Point3 normal{0.0, 0.0, 1.0};
  double distance = 0.0;
};

/// A mesh's section by a plane (section.md). World coordinates.
struct Section {
  /// In side_of: a side along the plane, and a side that is not part of the mesh's.
  static constexpr std::size_t kInPlane = static_cast<std::size_t>(-1), kNoSide = kInPlane - 1;

  /// Closed polylines in the plane: counterclockwise around solid, seen from where the
  /// normal points, clockwise around holes. Empty if nothing is cut, or the mesh is not closed.
  std::vector<std::vector<Point3>> loops;
  /// The object of each loop; if objects are closed only in combination, the number of all objects.
  std::vector<std::size_t> object_of;
  double area = 0.0;  ///< of the cut face
  /// The part of the mesh behind the plane. The rest of a planar face is one even-odd face, its
  /// loops joined by bridges; the rest of another face is triangles and their parts. Cut edges end
  /// at the loops' points, bit for bit. The cut face is not included. Its objects are the mesh's;
  /// some may have no faces.
  Mesh behind;
  std::vector<std::size_t> face_of;  ///< for each face behind, its face of the mesh
  /// For the side that ends at each corner behind: the mesh's corner at which the original side
  /// ends; kInPlane; or kNoSide for a bridge or a diagonal.
  std::vector<std::size_t> side_of;
  bool closed = true;  ///< each edge is used equally often in both directions
};

/// Cuts a mesh. Each object has its own loops if each is closed by itself; faces are even-odd and
/// may have bridges. A vertex in the plane counts as in front of it: the part behind is closed by
/// the loops, and a face in the plane is cut exactly where there is solid behind it. Throws Error
/// for a normal of length 0, or numbers that are not finite.
Section section(const Mesh& mesh, const SectionPlane& plane);

/// Reverses the loops of inside-out bodies, such as mirrored ones, so that all run counterclockwise
/// around solid. A body in no other's material is solid in either orientation; bodies within an
/// inside-out body are reversed with it.
void turn_bodies_out(Section& section, const SectionPlane& plane);

/// The cut face of a section, as even-odd polygons, one per object, whose loops are joined by
/// bridges; they may overlap where bodies do. A cavity, of negative area, is a hole of the smallest
/// object with it in its material.
std::vector<std::vector<Point3>> cap_polygons(const Section& section, const SectionPlane& plane);

}  // namespace displayfile
