#pragma once

#include <array>
#include <numbers>

namespace displayfile {

/// The smallest scale at which a trapped figure shows no seams.
inline constexpr double kSmallestScale = 0.5;

/// The width of a trap in pixels of the picture's size: twice the diagonal of a pixel, so that it
/// covers, on either side, all pixels through which the side runs (interp/vector/seams.md).
inline constexpr double kTrapWidth = 2.0 * std::numbers::sqrt2 / kSmallestScale;

/// The same sides are stroked again with decreasing widths: close to a side its own trap is on top,
/// not that of a side that ends nearby.
inline constexpr std::array<double, 5> kTrapWidths{kTrapWidth, kTrapWidth / 2, kTrapWidth / 4,
                                                   kTrapWidth / 8, kTrapWidth / 16};

}  // namespace displayfile
