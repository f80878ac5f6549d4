#pragma once

#include <cassert>
#include <numeric>
#include <span>
#include <type_traits>

namespace displayfile {

/// The corner before corner k, around a polygon of n corners, counted from 0; k is less than n. The
/// side that ends at a corner starts there.
template <class Index>
constexpr Index previous_corner(Index k, std::type_identity_t<Index> n) {
  assert(k < n);
  return k == 0 ? n - 1 : k - 1;
}

/// The corner after corner k, around a polygon of n corners, counted from 0; k is less than n.
/// next_corner(previous_corner(k, n), n) = k.
template <class Index>
constexpr Index next_corner(Index k, std::type_identity_t<Index> n) {
  assert(k < n);
  return k + 1 == n ? 0 : k + 1;
}

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
