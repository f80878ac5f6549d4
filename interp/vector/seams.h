#pragma once

#include <numbers>

namespace displayfile {

/// The smallest scale at which a figure that is trapped shows no seams.
inline constexpr double kSmallestScale = 0.5;

/// The widths of traps, drawn one over the other, in pixels of the picture's size.
inline constexpr int kTraps = 4;

/// The width of a trap in pixels of the picture's size: twice the diagonal of a pixel, so that it
/// covers, on either side, all pixels through which the side runs (interp/vector/seams.md).
inline constexpr double kTrapWidth = 2.0 * std::numbers::sqrt2 / kSmallestScale;

}  // namespace displayfile
