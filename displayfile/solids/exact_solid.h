#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "clip/point.h"
#include "displayfile/graphics_system.h"
#include "displayfile/solids/solid_faces.h"

namespace displayfile {

/// Triangles that bound a solid. World coordinates.
struct BoundingTriangles {
  std::vector<Point3> vertices;                         ///< with distinct positions
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into vertices
  std::vector<std::uint32_t> source;                    ///< per triangle
  /// True if the triangle beyond the side that ends at the vertex is exactly coplanar, on the other
  /// side of it. Results only.
  std::vector<std::array<std::uint8_t, 3>> is_flat;
  /// True if the vertex lies, within reach, between two others on the one line along which
  /// triangles of different sources meet there. Results only.
  std::vector<std::uint8_t> is_between;
};

/// A solid with exact vertices, not rounded. Made by the module of solids (solids_module.h): Error
/// if it is not installed, or was not built (exact_solid_absent.cpp).
class ExactSolid {
 public:
  struct Body;  ///< the module's

  /// From closed triangles: oriented so that they bound a volume, a shell within another being a
  /// hollow. Throws Error if they are not closed, intersect, or touch each other elsewhere than at
  /// shared sides and corners of one fan; `name` names the solid in messages.
  ExactSolid(const BoundingTriangles& triangles, std::string_view name);

  /// The result may touch itself, in points and along edges. Throws Error beyond
  /// CountedSteps::kMost steps, and LimitReached; `name` names solid b in messages.
  static ExactSolid combined(SolidOperation operation, const ExactSolid& a, const ExactSolid& b,
                             std::string_view name);

  bool is_empty() const;
  /// Its triangles, counterclockwise from outside; each vertex rounded, coordinate by coordinate.
  BoundingTriangles rounded() const;

 private:
  explicit ExactSolid(std::shared_ptr<const Body> body) : body_(std::move(body)) {}

  std::shared_ptr<const Body> body_;  // null: empty
};

/// Some faces of a solid, each with one loop, as triangles, whose source is the face.
BoundingTriangles triangles_of(const SolidFaces& solid, std::size_t first_face,
                               std::size_t end_face);

/// Converts a result to faces: all triangles of one source are one face with the source's
/// attributes. A side is drawn unless it separates faces of one polygon, or exactly coplanar faces
/// with equal attributes. The order of vertices and faces does not depend on the library.
SolidFaces combined_faces(const BoundingTriangles& result, const SolidFaces& sources);

}  // namespace displayfile
