#pragma once

#include <cassert>
#include <numeric>
#include <span>

namespace displayfile {

/// The mean of what a polygon has at its vertices, of which there are some: intensities or normals.
template <class Value>
Value mean_of_vertices(std::span<const Value> values) {
  assert(!values.empty());
  return std::accumulate(values.begin(), values.end(), Value(0.0)) /
         static_cast<double>(values.size());
}

/// What a polygon has that is not shaded over its picture but evenly: the mean of its vertices'
/// intensities, of which there are some. In [0,1] each.
inline double mean_intensity(std::span<const double> intensities) {
  return mean_of_vertices(intensities);
}

}  // namespace displayfile
