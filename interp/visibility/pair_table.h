#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "displayfile/segments/viewed_scene.h"

namespace displayfile {

/// A cache of data about pairs of fills, by a hash of the two. It grows from a few places up to a
/// limit; then a new pair replaces another. A default `Known` has no data; its forgotten() is what
/// remains of it for the new pair.
template <class Known>
class PairTable {
 public:
  using Fill = ViewedScene::Fill;

  /// The data of two fills; the reference is valid until the next call.
  Known& operator()(Fill earlier, Fill later) {
    if (places_.empty()) make_places(kFewest);
    Place* place = place_of(earlier, later);
    while (place == nullptr && power_ < kMost) {
      make_places(power_ + 1);
      place = place_of(earlier, later);
    }
    if (place == nullptr) {
      place = &places_[first_place_of(earlier, later)];
      place->known = place->known.forgotten();
    }
    place->earlier = earlier;
    place->later = later;
    return place->known;
  }

  /// Clears the data of all pairs, keeping the capacity.
  void forget() { std::ranges::fill(places_, Place{}); }

 private:
  static constexpr int kFewest = 5, kMost = 12;  ///< places, as powers of two
  static constexpr std::size_t kProbed = 4;      ///< places probed from the pair's hash on
  struct Place {
    Fill earlier = ViewedScene::kBackground, later = ViewedScene::kBackground;
    Known known;
  };

  std::size_t first_place_of(Fill earlier, Fill later) const {
    return (earlier * 0x9E3779B1u ^ later * 0x85EBCA77u) >> (32 - power_);
  }

  /// The pair's place, or an empty one; null if all of its possible places are occupied.
  Place* place_of(Fill earlier, Fill later) {
    const std::size_t first = first_place_of(earlier, later);
    for (std::size_t k = 0; k < kProbed; ++k) {
      Place& place = places_[(first + k) & (places_.size() - 1)];
      if (place.later == later && place.earlier == earlier) return &place;
      if (place.later == ViewedScene::kBackground) return &place;
    }
    return nullptr;
  }

  /// Pairs for which no place is left there are dropped.
  void make_places(int power) {
    const std::vector<Place> before = std::move(places_);
    power_ = power;
    places_ = std::vector<Place>(std::size_t{1} << power);
    for (const Place& known : before) {
      if (known.later == ViewedScene::kBackground) continue;
      if (Place* const place = place_of(known.earlier, known.later)) *place = known;
    }
  }

  std::vector<Place> places_;
  int power_ = 0;
};

}  // namespace displayfile
