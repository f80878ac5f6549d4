#pragma once

namespace displayfile::row_bounds {

/// Bounds on the errors of single precision, in any rounding mode; derived in
/// interp/visibility/z_buffer.md.
inline constexpr double kEdgeUnit = 0x1p-21, kDepthUnit = 0x1p-20, kDepthError = 0x1p-17;
inline constexpr double kLargestEdgeError = 0.25;
/// Depths of larger magnitude are uncertain: smaller ones, and their sums, fit into floats.
inline constexpr double kLargestDepth = 0x1p126;
/// Bounds on the errors of a triangle's coordinates in pixels, near a picture, and of values
/// computed from them.
inline constexpr double kOfCoordinates = 0x1p-50, kColumnError = 0x1p-50;

}  // namespace displayfile::row_bounds
