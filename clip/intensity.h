#pragma once

#include <numeric>
#include <span>

namespace displayfile {

/// What a polygon has that is not shaded over its picture but evenly: the mean of its vertices'
/// intensities, of which there are some. In [0,1] each.
inline double mean_intensity(std::span<const double> intensities) {
  return std::accumulate(intensities.begin(), intensities.end(), 0.0) /
         static_cast<double>(intensities.size());
}

}  // namespace displayfile
