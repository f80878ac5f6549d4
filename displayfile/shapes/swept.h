#pragma once

#include <span>

#include "displayfile/shapes/closed_shape.h"

namespace displayfile {

/// A profile in the x-y plane, moved along z. Its points may run either way around; its two ends
/// are polygons of as many sides, even-odd where it crosses itself. Throws Error unless it has 3
/// points or more, no two equal ones in a row, and an area, and z_min < z_max.
ClosedShape extruded(std::span<const Point2> profile, double z_min, double z_max);

/// How light falls on what is turned.
enum class TurnedLight {
  facets,  ///< each polygon is flat
  round,   ///< around the axis it is a curved surface
  smooth,  ///< along the profile too, with normals that are given
};

inline constexpr int kFewestFacets = 3, kMostFacets = 1000;
/// Throws Error for facets fewer or more than that.
void require_facets(int facets);

/// A profile, whose points are (distance from the axis, z), turned about the z axis by a whole
/// turn, in so many facets; the first point of each ring is in the direction of x. The profile is
/// closed, its last point before its first, and may run either way around. Where it touches the
/// axis there is one vertex, and a side that runs straight away from the axis makes one polygon of
/// all facets; sides along the axis make none. `normals` are of the profile's points, for smooth.
/// Throws Error as extruded does, and for a distance below 0, and as require_facets.
ClosedShape turned(std::span<const Point2> profile, int facets, TurnedLight light,
                   std::span<const Point2> normals = {});

}  // namespace displayfile
