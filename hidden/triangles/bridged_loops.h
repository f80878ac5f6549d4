#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// The loops of an even-odd polygon that goes from loop to loop over bridges: sides that it follows
/// there and back, as polygons with holes do (hidden/triangles/triangulation.md).
class BridgedLoops {
 public:
  /// With fewer corners a polygon has no second loop.
  static constexpr std::size_t kFewestCorners = 8;

  /// Leaves the bridges out. False if there are none.
  bool find(std::span<const Point2> polygon);

  /// Turns outlines counterclockwise and holes clockwise. A loop is a hole if an odd number of
  /// others is around it. One with each side within rounding of another loop, or without area but
  /// for rounding, stays as it is.
  void turn(std::span<const Point2> polygon);

  /// For each corner the one that follows in its loop; kInNoLoop where a bridge ends.
  std::span<const std::uint32_t> next() const { return next_; }
  /// True if turn reversed a loop.
  bool any_turned() const { return any_turned_; }

 private:
  void match_sides(std::span<const Point2> polygon);
  double area_of_loop(std::span<const Point2> polygon, std::uint32_t first, double reach);
  void reverse(std::uint32_t first);
  std::optional<bool> has_odd_around(std::span<const Point2> polygon, std::uint32_t corner,
                                     double reach) const;
  std::optional<bool> is_hole(std::span<const Point2> polygon, std::uint32_t first,
                              double reach) const;

  std::vector<std::uint32_t> sides_;    // sorted, so that those with the same ends are successive
  std::vector<std::uint32_t> partner_;  // per side, the one that leads back
  std::vector<std::uint32_t> next_;
  std::vector<std::uint32_t> loop_of_;  // per corner, the first of its loop
  bool any_turned_ = false;
};

}  // namespace displayfile
