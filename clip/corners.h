#pragma once

#include <cassert>
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

}  // namespace displayfile
