#pragma once

#include <cassert>
#include <numeric>
#include <span>

namespace displayfile {

/// The mean of a polygon's vertex values, intensities or normals; there must be some.
template <class Value>
Value mean_of_vertices(std::span<const Value> values) {
  assert(!values.empty());
  return std::accumulate(values.begin(), values.end(), Value(0.0)) /
         static_cast<double>(values.size());
}

/// The intensity of a polygon filled with one colour: the mean of its vertices' intensities, each
/// in [0,1]; there must be some.
inline double mean_intensity(std::span<const double> intensities) {
  return mean_of_vertices(intensities);
}

}  // namespace displayfile
