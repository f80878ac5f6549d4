#pragma once

#include <array>
#include <optional>
#include <span>

#include "hidden/exact/line_parameter.h"

namespace displayfile {

/// A segment of the intersection of two planes, neither of them edge-on, between two defined
/// points: answers a hidden-line method's queries exactly. Parameters are fractions of its
/// projection from 0 to 1, each the true one rounded once.
class CommonLine {
 public:
  /// The ends are on both planes, and defined by the stored points and these planes in this order.
  /// Their rounded `near` points differ in the projection. The caller owns the points.
  CommonLine(std::span<const Point3> points, const std::array<Plane, 2>& planes,
             const DefinedPoint& from, const DefinedPoint& to)
      : points_(points), planes_(planes), from_(from), to_(to) {}

  /// The side of the line on which the point is in the projection: 1 where the first plane is
  /// nearer than the second, -1 where the second is, 0 on the line. The sign flips if the planes
  /// are exchanged.
  int side(const Point3& p) const;

  /// The sign of the plane's depth less the line's, at its start or at its end; the plane faces the
  /// viewer.
  int nearer_at_start(const Plane& plane) const { return nearer(from_, plane); }
  int nearer_at_end(const Plane& plane) const { return nearer(to_, plane); }

  /// Parameters of points of the line: the crossing with the line through p and q, clamped to its
  /// ends; the point p on it; and the point at which the plane has its depth. The plane is nearer
  /// at one end only.
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
  mutable std::optional<Ends> ends_;  // found on first use
};

}  // namespace displayfile
