#pragma once

namespace displayfile {

// When a vertex that viewing has moved off a plane counts as on it, in a sort
// (hidden/sort/touching_vertices.md). Lengths in normalised device coordinates.

/// How far from a polygon's boundary, in the projection, the sorts may have the wrong polygon in
/// front where vertices count as touching.
inline constexpr double kTouchingStrip = 0x1p-24;

/// By how many times what counts as touching a polygon must be farther from a plane somewhere, so
/// that its vertices near the plane count as on it: what of it then lies on the wrong side is
/// within kTouchingStrip of its boundary, since no polygon in the picture is longer than 2 sqrt(2).
inline constexpr double kFarFromPlane = 0x1p27;

/// True if vertices may count as on planes that they are no farther from, in each coordinate
/// (Primitives::touching). Where it is more, every sign is that of what is viewed.
inline constexpr bool vertices_touch(double touching) {
  return touching > 0.0 && touching <= kTouchingStrip / 8.0;
}

}  // namespace displayfile
