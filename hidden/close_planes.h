#pragma once

#include <cstdint>
#include <vector>

#include "hidden/touching_planes.h"

namespace displayfile {

/// Which polygons of a scene may have another plane close to their own, in doubles, quickly: by one
/// sort of their planes' distances from a point (hidden/touching_planes.md, "Planes that are close
/// and not one").
class ClosePlanes {
 public:
  ClosePlanes() = default;
  /// `reach` is that of what touches, before modelling transformations, as of TouchingPlanes;
  /// `near` the same of planes that are close at an angle of 2^-20 at most, no smaller.
  ClosePlanes(std::uint32_t polygons, const TouchingPlanes::PolygonOf& polygon_of, double reach,
              double near);

  /// False: no other polygon lies in its plane, nor does it lie in another's. True of all where
  /// doubles do not tell: where polygons are so thin that they may lie in planes of other normals.
  bool may_touch(std::uint32_t polygon) const { return may_touch_.empty() || may_touch_[polygon]; }
  /// By its number whether a polygon may have a plane near its own other than the one that it lies
  /// in. Empty: none has.
  std::vector<std::uint8_t> near_others(const TouchingPlanes& touching) const;

 private:
  struct Entered {
    Point3 normal;
    double off;  ///< from the point
    std::uint32_t polygon;
  };
  bool enter(std::uint32_t polygons, const TouchingPlanes::PolygonOf& polygon_of, double reach,
             double near);
  bool find_touching();

  std::uint32_t polygons_ = 0;
  std::vector<Entered> planes_;  // by rising distance from the point
  double window_ = 0.0;          // how much closer or farther one that is close may be
  bool is_known_ = true;         // all planes are, well enough
  std::vector<std::uint8_t> may_touch_;
};

}  // namespace displayfile
