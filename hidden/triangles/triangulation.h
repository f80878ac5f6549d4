#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"
#include "hidden/triangles/bridged_loops.h"
#include "hidden/triangles/ear_cutting.h"
#include "hidden/triangles/uncrossed_loops.h"

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
  /// fanned from there (tile tiles it). Valid until the next call.
  std::span<const Triangle> triangulate(std::span<const Point3> polygon,
                                        SeenAlong along = SeenAlong::nearest_axis);

  /// As triangulate, but of a polygon that crosses itself what the even-odd rule fills. It then has
  /// corners where its sides cross, numbered after its vertices in the order of crossings(), and
  /// parts of its sides are sides. One of more corners or crossings than UncrossedLoops takes is
  /// cut as by triangulate.
  std::span<const Triangle> tile(std::span<const Point3> polygon,
                                 SeenAlong along = SeenAlong::nearest_axis);
  /// Those of the polygon that tile cut last: empty unless it has corners of its own there.
  std::span<const UncrossedLoops::Crossing> crossings() const;
  /// Values at the vertices of that polygon, followed by those at its crossings: the mean of both
  /// sides'.
  std::vector<Point3> with_crossings(std::span<const Point3> values) const;

  /// True if the polygon cut last crosses itself, as seen along the axis along which it was cut, by
  /// more than rounding.
  bool crosses_itself() const;

  /// The same by cutting ears only, in quadratic time: the reference for tests.
  std::span<const Triangle> triangulate_by_ears(std::span<const Point3> polygon);

 private:
  void flatten(std::span<const Point3> polygon, const Point3& along);
  void find_corners();
  void find_corners_of_one_loop();
  std::span<const Triangle> uncrossed_triangles();
  bool tiles() const;
  std::span<const Triangle> with_sides();

  std::vector<Point2> flattened_;
  std::vector<CornerTriple> corners_;
  std::vector<Triangle> triangles_;
  EarCutting ears_;
  BridgedLoops bridged_;
  UncrossedLoops uncrossed_;
  bool is_by_loops_ = false;   // the last polygon's triangles are those of its loops
  bool is_bridged_ = false;    // bridged_ has its loops
  bool is_swept_ = false;      // it has more corners than kMostForEars, and does not cross itself
  bool is_uncrossed_ = false;  // its triangles are those of uncrossed_
};

}  // namespace displayfile
