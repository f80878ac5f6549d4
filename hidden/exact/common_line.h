#pragma once

#include <array>
#include <optional>
#include <span>

#include "hidden/exact/line_parameter.h"

namespace displayfile {

/// A part of the line that two planes have in common, neither of them edge-on, between two points
/// that are kept as what they are: what a hidden-line method asks of a line, exactly. The
/// parameters are shares of its projection from 0 to 1, each the true one rounded once.
class CommonLine {
 public:
  /// The ends are on both planes, and defined by the stored points and these planes in this order.
  /// Rounded, as their `near`, they differ in the projection. The points stay the caller's.
  CommonLine(std::span<const Point3> points, const std::array<Plane, 2>& planes,
             const DefinedPoint& from, const DefinedPoint& to)
      : points_(points), planes_(planes), from_(from), to_(to) {}

  /// Which side of the line the point is on in the projection: 1 where the first plane is nearer
  /// than the second, -1 where the second is, 0 on the line. It flips where the planes change
  /// places.
  int side(const Point3& p) const;

  /// The sign of the plane's depth less the line's, at its start or at its end; the plane faces the
  /// viewer.
  int nearer_at_start(const Plane& plane) const { return nearer(from_, plane); }
  int nearer_at_end(const Plane& plane) const { return nearer(to_, plane); }

  /// Where the line through p and q crosses it, cut off at its ends; where the point p that lies on
  /// it is; and where the plane has its depth, which is nearer at one end only.
  double crossing(const Point2& p, const Point2& q) const;
  double at_point(const Point2& p) const;
  double meeting(const Plane& plane) const;

 private:
  Definitions definitions() const { return {points_, planes_}; }
  int nearer(const DefinedPoint& end, const Plane& plane) const;
  bool is_cut_from(const DefinedPoint& end, const Point2& p, const Point2& q) const;
  struct Ends {
    DefinedEnd from, to;
  };
  const Ends& ends() const;

  std::span<const Point3> points_;
  std::array<Plane, 2> planes_;
  DefinedPoint from_, to_;
  mutable std::optional<Ends> ends_;  // found when they are first asked for
};

}  // namespace displayfile
