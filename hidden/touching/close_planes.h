#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hidden/touching/touching_planes.h"

namespace displayfile {

/// Finds quickly, in doubles, which polygons of a scene may have another plane close to their own:
/// by sorting their planes' distances from a point, and checking the positions of polygons with
/// similar normals (hidden/touching/touching_planes.md, "Planes that are close and not one").
class ClosePlanes {
 public:
  ClosePlanes() = default;
  /// `reach` is the touching distance, before modelling transformations, as in TouchingPlanes;
  /// `near` the same for planes that are close at an angle of at most 2^-20, no smaller.
  ClosePlanes(std::uint32_t polygons, const TouchingPlanes::PolygonOf& polygon_of, double reach,
              double near);

  /// The indices, ascending, of the polygons that may lie in another's plane, or another in theirs.
  /// All if doubles do not decide: where polygons are so thin that they may lie in planes of other
  /// normals.
  const std::vector<std::uint32_t>& may_touch() const { return may_touch_; }
  /// MayTouch::pairs of these polygons; null if unknown.
  const std::vector<TouchingPlanes::Pair>* pairs() const { return pairs_ ? &*pairs_ : nullptr; }
  /// The indices, ascending, of those that may have another polygon's plane near them, or lie near
  /// another's, other than the plane in which they lie.
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
  double window_ = 0.0;              // maximum difference in distance of near ones
  double reach_ = 0.0, near_ = 0.0;  // in the world
  double rounding_ = 0.0;            // of world points
  bool is_known_ = true;             // all planes are known accurately enough
  std::vector<std::uint32_t> may_touch_;
  std::optional<std::vector<TouchingPlanes::Pair>> pairs_;
};

}  // namespace displayfile
