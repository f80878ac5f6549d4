#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "displayfile/looks/style.h"

namespace displayfile {

inline constexpr int kHeightColours = 64;

/// Colours that grow lighter evenly from a dark violet over blue-green to yellow, so that heights
/// can be told apart in grey and by the colour-blind too. `part` of the way, in [0,1].
inline Colour height_colour(double part) {
  // Even steps in lightness (CIE L* 16 to 91), chosen for this.
  static const std::array<Colour, 7> kColours{Colour{0.23, 0.06, 0.36}, Colour{0.24, 0.22, 0.52},
                                              Colour{0.16, 0.38, 0.56}, Colour{0.10, 0.53, 0.56},
                                              Colour{0.25, 0.68, 0.47}, Colour{0.60, 0.81, 0.30},
                                              Colour{0.97, 0.91, 0.25}};
  const double place = std::clamp(part, 0.0, 1.0) * (kColours.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(place), kColours.size() - 2);
  const double rest = place - static_cast<double>(k);
  return kColours[k] + rest * (kColours[k + 1] - kColours[k]);
}

/// The same in steps, as many as kHeightColours.
inline Colour height_colour_of_step(int step) {
  return height_colour((step + 0.5) / kHeightColours);
}

}  // namespace displayfile
