#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// A piece of a line to be drawn. Pieces with different keys are never joined.
struct ChainLink {
  Point3 from, to;
  std::uint64_t key;
};

/// Pieces in drawing order: chain after chain, each of connected pieces.
struct Chains {
  struct Place {
    std::uint32_t piece;
    bool reversed;  ///< drawn from its end to its start
  };
  std::vector<Place> places;         ///< each piece once
  std::vector<std::uint32_t> first;  ///< of each chain, among the places

  std::span<const Place> chain(std::size_t k) const {
    assert(k < first.size());
    const std::size_t end = k + 1 < first.size() ? first[k + 1] : places.size();
    return std::span(places).subspan(first[k], end - first[k]);
  }
};

/// Joins pieces with ends of the same key at the same point, in all three coordinates (0 and -0 are
/// equal), into chains as long as possible (hidden/lines/chains.md): two ends that meet are joined;
/// more than two are paired, straightest pairs in the projection first. Chains are in order of
/// their first pieces, which run forward; a closed chain begins with it.
Chains chains_of(std::span<const ChainLink> pieces);

}  // namespace displayfile
