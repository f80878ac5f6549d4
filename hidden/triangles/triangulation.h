#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"
#include "hidden/triangles/bridged_loops.h"
#include "hidden/triangles/ear_cutting.h"

namespace displayfile {

/// Cuts polygons, mostly non-planar ones, into triangles (hidden/triangles/triangulation.md).
class Triangulation {
 public:
  struct Triangle {
    std::array<std::uint32_t, 3> vertex;  ///< indices into the polygon
    std::array<std::uint8_t, 3>
        edge_visible;  ///< of the side that ends at that vertex; 0 for a diagonal
  };

  /// Polygons of more corners than this are cut by a sweep, others by cutting off ears.
  static constexpr std::size_t kMostForEars = 64;
  /// If the sweep finds that a polygon crosses itself, ears are cut until this many corners have
  /// been examined for each of its corners.
  static constexpr std::size_t kLooksPerCorner = 256;

  /// The direction in which the triangles tile the polygon: the axis nearest to its Newell normal;
  /// or the z axis, if the polygon does not cross itself as seen along it, else as before.
  enum class SeenAlong : std::uint8_t { nearest_axis, z_axis };

  /// Triangles that tile the polygon (at least three vertices, any coordinates in space), two fewer
  /// than its vertices, as seen along an axis; each has the polygon's orientation, and each side of
  /// the polygon is a side of one of them. In n log n. A polygon of several loops that bridges
  /// join, sides that it follows there and back, is tiled by the even-odd rule wherever its bridges
  /// lead: if they leave its inside they are sides of no triangle, and there may be fewer
  /// triangles. A self-crossing polygon has no such tiling; it is cut where ears are found, and
  /// fanned from there. Valid until the next call.
  std::span<const Triangle> triangulate(std::span<const Point3> polygon,
                                        SeenAlong along = SeenAlong::nearest_axis);

  /// The same by cutting ears only, in quadratic time: the reference for tests.
  std::span<const Triangle> triangulate_by_ears(std::span<const Point3> polygon);

 private:
  void flatten(std::span<const Point3> polygon, const Point3& along);
  void find_corners();
  void find_corners_of_one_loop();
  bool tiles() const;
  std::span<const Triangle> with_sides();

  std::vector<Point2> flattened_;
  std::vector<CornerTriple> corners_;
  std::vector<Triangle> triangles_;
  EarCutting ears_;
  BridgedLoops bridged_;
  bool is_by_loops_ = false;  // the last polygon's triangles are those of its loops
};

}  // namespace displayfile
