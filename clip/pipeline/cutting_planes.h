#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// A polygon after cutting, in world coordinates; spans as in ClippedPolygon
/// (clip/pipeline/clip_pipeline.h). Sides made by cutting are not drawn. No vertices: all is cut
/// away.
struct CutPolygon {
  std::span<const Point3> vertices;
  std::span<const std::uint8_t> edge_visible;  ///< empty: all
  std::span<const Point3> normals;             ///< if the polygon had normals
  std::span<const Point3> entered;  ///< the vertices before the modelling transformation, if passed
};

/// Up to six planes in world coordinates; each cuts away the half-space a x + b y + c z + d < 0
/// (clip/pipeline/cutting_planes.md). Distances and cut points are doubles. PHIGS's modelling
/// clipping volume, and OpenGL's user clip planes.
class CuttingPlanes {
 public:
  static constexpr int kMost = 6;

  /// Sets plane n, from 1, and turns it on. Throws Error for an n outside of 1 to 6, a number that
  /// is not finite or exceeds kCoordinateLimit, a zero normal a b c, and a plane farther than
  /// kCoordinateLimit from the origin.
  void set(int n, double a, double b, double c, double d);
  /// Throws Error for an n outside of 1 to 6.
  void set_off(int n);
  /// Moves all planes, also those that are set later, with parts that are moved in the world: they
  /// are where they were set, plus `move`.
  void place(const Point3& move);

  /// How far from a plane a point still lies in it: `length`, or `of_terms` times the sum of the
  /// magnitudes of a x, b y, c z and d over the length of (a, b, c), whichever is farther. [0, 0]
  struct Reach {
    double length = 0.0, of_terms = 0.0;
  };
  void set_reach(const Reach& reach) { reach_ = reach; }

  bool any() const { return on_ != 0; }
  unsigned on() const { return on_; }  ///< the planes that are on, one bit each, as in outcode
  bool is_on(int n) const {
    assert(1 <= n && n <= kMost);
    return (on_ >> (n - 1) & 1u) != 0;
  }

  /// The planes that points lie outside and inside of, one bit each.
  struct Sides {
    unsigned outside = 0, inside = 0;
    void include(const Sides& other) {
      outside |= other.outside;
      inside |= other.inside;
    }
    /// True if a plane leaves nothing but what may lie in it.
    bool leave_nothing() const { return (outside & ~inside) != 0; }
  };
  Sides sides(const Point3& world) const;
  /// The planes that cut the point away, one bit each. A point in a plane stays.
  unsigned outcode(const Point3& world) const;

  /// Cuts a polygon; edge_visible empty for "all sides", normals one per vertex or none. Where an
  /// edge is cut, the normal is interpolated linearly between normals of length 1. A polygon of
  /// which nothing lies inside of a plane, and not all in it, is cut away. `entered` are
  /// the vertices before the modelling transformation, or none; they are cut at the same places. An
  /// uncut polygon is returned unchanged. Valid until the next call.
  CutPolygon cut(std::span<const Point3> world, std::span<const std::uint8_t> edge_visible,
                 std::span<const Point3> normals, std::span<const Point3> entered = {});
  /// Cuts the line from a to b in place; false if nothing is left, or a single point in a plane.
  /// From b to a it gives the same two ends, bit for bit.
  bool cut_line(Point3& a, Point3& b) const;

  // For cutting a whole solid plane by plane (displayfile/solids/solid_faces.h). Plane n is on.

  /// The signed distance times a positive factor of at most 2 and a power of two: below 0 where the
  /// plane cuts away, 0 within reach of the plane.
  double distance(int n, const Point3& world) const { return distance(plane(n), world); }
  /// The unit normal toward the side that is kept; the plane is normal . p = -offset.
  struct UnitPlane {
    Point3 normal;
    double offset;
  };
  UnitPlane unit_plane(int n) const;
  /// A point and a normal there.
  struct Place {
    Point3 position;
    Point3 normal;
    Point3 entered{0.0};  ///< before the modelling transformation, if needed
  };
  /// The point where the edge crosses plane n, between a vertex inside and one outside or on it:
  /// the one that `cut` makes there, bit for bit. An end that lies in the plane is that point.
  Place crossing(int n, const Place& inside, const Place& outside) const;

 private:
  /// a, b, c and d times a power of two, so that the largest of a, b and c is between 1/2 and 1.
  struct Plane {
    Point3 normal{0.0};
    double d = 0.0;       ///< where it is placed
    double length = 0.0;  ///< of the normal
    double as_set = 0.0;  ///< d before it is placed
    void snap(Point3& p) const;
  };
  double distance(const Plane& by, const Point3& p) const {
    const Point3 terms(by.normal.x * p.x, by.normal.y * p.y, by.normal.z * p.z);
    const double value = terms.x + terms.y + terms.z + by.d;
    const double of_terms =
        std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z) + std::abs(by.d);
    const double reach = std::max(reach_.length * by.length, reach_.of_terms * of_terms);
    return std::abs(value) <= reach ? 0.0 : value;
  }
  const Plane& plane(int n) const {
    assert(is_on(n));
    return planes_[static_cast<std::size_t>(n - 1)];
  }
  struct Vertex {
    Place place;
    unsigned outcode;
    std::uint8_t edge_visible;  ///< of the side that ends here
  };

  Vertex cut_edge(const Vertex& inside, const Vertex& outside, int plane) const;

  std::array<Plane, kMost> planes_{};
  Reach reach_;
  Point3 place_{0.0};
  unsigned on_ = 0;
  std::vector<Vertex> in_, out_;
  std::vector<Point3> vertices_, normals_, entered_;
  std::vector<std::uint8_t> visible_;
};

}  // namespace displayfile
