#pragma once

namespace displayfile {

// The rule by which a vertex that viewing has moved off a plane counts as on it, in a sort
// (hidden/sort/touching_vertices.md). Lengths in normalised device coordinates.

/// Distance from a polygon's boundary, in the projection, within which the sorts may draw the wrong
/// polygon in front where vertices count as touching.
inline constexpr double kTouchingStrip = 0x1p-24;

/// Factor of the touching distance by which a polygon must extend from a plane, so that its
/// vertices near the plane count as on it: the part on the wrong side is then within kTouchingStrip
/// of its boundary, since no polygon in the picture is longer than 2 sqrt(2).
inline constexpr double kFarFromPlane = 0x1p27;

/// True if vertices may count as on planes within this distance, per coordinate
/// (Primitives::touching). If it is larger, every sign is that of the viewed coordinates.
inline constexpr bool vertices_touch(double touching) {
  return touching > 0.0 && touching <= kTouchingStrip / 8.0;
}

}  // namespace displayfile
