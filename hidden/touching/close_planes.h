#pragma once

#include <cstdint>
#include <vector>

#include "hidden/touching/touching_planes.h"

namespace displayfile {

/// Which polygons of a scene may have another plane close to their own, in doubles, quickly: by one
/// sort of their planes' distances from a point, and a look at where polygons lie whose normals are
/// alike (hidden/touching/touching_planes.md, "Planes that are close and not one").
class ClosePlanes {
 public:
  ClosePlanes() = default;
  /// `reach` is that of what touches, before modelling transformations, as of TouchingPlanes;
  /// `near` the same of planes that are close at an angle of 2^-20 at most, no smaller.
  ClosePlanes(std::uint32_t polygons, const TouchingPlanes::PolygonOf& polygon_of, double reach,
              double near);

  /// The numbers, rising, of the polygons that may lie in another's plane, or another in theirs.
  /// All where doubles do not tell: where polygons are so thin that they may lie in planes of other
  /// normals.
  const std::vector<std::uint32_t>& may_touch() const { return may_touch_; }
  /// The numbers, rising, of those that may have another polygon's plane near them, or lie near
  /// another's, other than the plane that they lie in.
  std::vector<std::uint32_t> near_others(const TouchingPlanes& touching) const;

 private:
  enum class Distance : std::uint8_t { touching, near, far };
  struct Entered {
    Point3 normal;
    double off;  ///< from the point
    std::uint32_t polygon;
    Distance nearest;  ///< of others whose normals are alike
  };
  bool enter(std::uint32_t polygons, const TouchingPlanes::PolygonOf& polygon_of, double reach,
             double near);
  Distance distance_from(const EnteredPolygon& plane, const EnteredPolygon& polygon) const;
  Distance distance_of(const EnteredPolygon& a, const EnteredPolygon& b) const;
  bool find_touching(const TouchingPlanes::PolygonOf& polygon_of);

  std::vector<std::uint32_t> all() const;

  std::uint32_t polygons_ = 0;
  std::vector<Entered> planes_;      // of those that may be near, by rising distance from the point
  double window_ = 0.0;              // how much closer or farther one that is near may be
  double reach_ = 0.0, near_ = 0.0;  // in the world
  double rounding_ = 0.0;            // of points there
  bool is_known_ = true;             // all planes are, well enough
  std::vector<std::uint32_t> may_touch_;
};

}  // namespace displayfile
