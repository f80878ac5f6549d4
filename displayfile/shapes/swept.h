#pragma once

#include <span>

#include "displayfile/shapes/closed_shape.h"

namespace displayfile {

/// A profile in the x-y plane, extruded along z. Its points may run in either orientation; its two
/// ends are polygons with as many sides, even-odd where it crosses itself. Throws Error unless it
/// has at least 3 points, no two successive ones equal, and an area, and z_min < z_max.
ClosedShape extruded(std::span<const Point2> profile, double z_min, double z_max);

/// How a turned shape is lit.
enum class TurnedLight {
  facets,  ///< each polygon is flat
  round,   ///< curved around the axis
  smooth,  ///< curved along the profile too, with the given normals
};

inline constexpr int kFewestFacets = 3, kMostFacets = 1000;
/// Throws Error for a number of facets out of range.
void require_facets(int facets);

/// A profile with points (distance from the axis, z), revolved about the z axis in this many
/// facets; the first point of each ring is in the direction of x. The profile is closed, its last
/// point before its first, in either orientation. Where it touches the axis there is one vertex; a
/// side perpendicular to the axis at an end on it makes one polygon of all facets; sides along the
/// axis make none. `normals` are those of the profile's points, for `smooth`. Throws Error as
/// extruded does, for a distance below 0, and as require_facets.
ClosedShape turned(std::span<const Point2> profile, int facets, TurnedLight light,
                   std::span<const Point2> normals = {});

}  // namespace displayfile
