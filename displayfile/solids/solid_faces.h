#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "clip/pipeline/cutting_planes.h"
#include "clip/point.h"
#include "displayfile/looks/style.h"

namespace displayfile {

/// The surface of a solid in world coordinates: faces that share vertices, each a polygon or
/// several loops, filled even-odd, with attributes.
struct SolidFaces {
  struct Corner {
    std::uint32_t vertex;
    std::uint8_t edge_visible;  ///< of the side that ends here
    Point3 normal{0.0};         ///< if the face is smooth
  };
  struct Face {
    Point3 normal{0.0};  ///< Newell's normal of the whole polygon, where there is light
    std::int32_t pick = 0;
    std::uint32_t attributes = 0;
    std::uint32_t polygon = 0;  ///< the call that entered it
    bool smooth = false;        ///< its corners have normals
    int cut_by = 0;             ///< the cutting plane whose cut face it is, or 0
    std::size_t end_loop = 0;   ///< end of its loops, which follow those of the face before
  };

  std::vector<Point3> vertices;
  std::vector<Corner> corners;
  std::vector<std::size_t> end_corner;  ///< of each loop
  std::vector<Face> faces;
  std::vector<Attributes> attributes;

  std::size_t first_loop(std::size_t face) const {
    return face == 0 ? 0 : faces[face - 1].end_loop;
  }
  std::span<const Corner> loop(std::size_t i) const {
    const std::size_t first = i == 0 ? 0 : end_corner[i - 1];
    return std::span(corners).subspan(first, end_corner[i] - first);
  }
  /// Adds a loop to the face that `add` ends; loops with fewer than three corners are ignored.
  void add_loop(std::span<const Corner> loop);
  /// Adds a face of the loops added since the last one; no effect without loops.
  void add(const Face& face);
};

/// A face as one even-odd polygon: its loops are joined by undrawn sides there and back.
struct FacePolygon {
  std::vector<Point3> vertices;
  std::vector<std::uint8_t> edge_visible;  ///< of the side that ends at the vertex
  std::vector<Point3> normals;             ///< if the face is smooth
};
void set_to_face(FacePolygon& polygon, const SolidFaces& solid, std::size_t face);

/// A side used more often in its direction than in the reverse: its surface is not closed.
using OpenSide = std::pair<Point3, Point3>;

/// Returns an open side, or nothing if each side of these polygons is used equally often in both
/// directions; vertices with equal positions are one. As in polygons_abs_3, three corners each if
/// `sides` is empty.
std::optional<OpenSide> open_side(std::span<const Point3> vertices,
                                  std::span<const std::uint32_t> corners,
                                  std::span<const std::uint32_t> sides);
/// The same for some faces of a solid.
std::optional<OpenSide> open_side(const SolidFaces& solid, std::size_t first_face,
                                  std::size_t end_face);

/// Six times the volume that closed polygons enclose, as in open_side: above 0 if their light faces
/// are outward.
double enclosed_volume(std::span<const Point3> vertices, std::span<const std::uint32_t> corners,
                       std::span<const std::uint32_t> sides);
double enclosed_volume(const SolidFaces& solid);

/// Cuts a closed solid by cutting planes and closes it by cut faces (cut_solid.md): their `cut_by`
/// is the plane's number, and `attributes` their attributes. Vertices of the solid with equal
/// positions need not be shared. A vertex in a plane, or within its reach, counts as cut away.
SolidFaces cut_solid(const SolidFaces& solid, const CuttingPlanes& planes,
                     std::uint32_t attributes);

}  // namespace displayfile
