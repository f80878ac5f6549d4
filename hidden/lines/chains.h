#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// A piece of a line to be drawn. Pieces of different keys are never joined.
struct ChainLink {
  Point3 from, to;
  std::uint64_t key;
};

/// Pieces in the order in which a pen draws them: chain after chain, each of pieces that begin
/// where the one before ends.
struct Chains {
  struct Place {
    std::uint32_t piece;
    bool reversed;  ///< drawn from its end to where it starts
  };
  std::vector<Place> places;         ///< each piece once
  std::vector<std::uint32_t> first;  ///< of each chain, among the places

  std::span<const Place> chain(std::size_t k) const {
    assert(k < first.size());
    const std::size_t end = k + 1 < first.size() ? first[k + 1] : places.size();
    return std::span(places).subspan(first[k], end - first[k]);
  }
};

/// Joins pieces where ends of the same key are one point, all three coordinates (0 and -0 are
/// equal), into chains as long as can be (hidden/lines/chains.md): where two ends meet they are
/// joined, where more do, two and two, those first that go straightest on in the projection. Chains
/// are in order of the first of their pieces, which runs forward; a closed one begins with it.
Chains chains_of(std::span<const ChainLink> pieces);

}  // namespace displayfile
