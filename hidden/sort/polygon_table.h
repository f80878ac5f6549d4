#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "hidden/sort/side_buffer.h"

namespace displayfile {

/// The table of the polygons being sorted (the textbook's POLY-START, POLY-SIDES, POLY-FRONT,
/// POLY-BACK; the plane's coefficients are in the vertex table, the styles are the item's).
/// An entry is an item, a piece of one, or a node of the tree that holds no polygon.
struct PolygonTable {
  using Index = std::uint32_t;
  static constexpr Index kNone = std::numeric_limits<Index>::max();

  struct Entry {
    Index start = 0;          ///< in the D buffer
    std::uint32_t sides = 0;  ///< 2: a line; 0: a node without a polygon
    std::uint32_t item = 0;   ///< which item it is, or a piece of
    std::uint32_t plane =
        kNoPlane;  ///< kNoPlane of a line, and of a node whose branches need no order
    /// The branches of the tree: in front and in back of the entry's plane. In a list of polygons
    /// still to be sorted, front is the next.
    Index front = kNone, back = kNone;
    Index on = kNone;   ///< the first of the polygons in the entry's own plane, linked by `on`
    bool whole = true;  ///< not cut
  };

  std::vector<Entry> entries;
  std::size_t most_entries = kNone;  ///< no polygon is cut beyond this
  SideBuffer d;                      ///< the D buffer: sides of all polygons
  SideBuffer e;                      ///< the E buffer: one half of the polygon being split

  Entry& operator[](Index i) {
    assert(i < entries.size());
    return entries[i];
  }
  const Entry& operator[](Index i) const {
    assert(i < entries.size());
    return entries[i];
  }
  Index free() const { return static_cast<Index>(entries.size()); }  ///< POLY
  std::span<const std::uint32_t> vertices(Index i) const {
    return d.vertices(entries[i].start, entries[i].sides);
  }

  /// take_back removes additions after mark(): for trying a cut on a copy.
  struct Mark {
    Index free, d_free;
  };
  Mark mark() const { return {free(), d.free()}; }
  void take_back(const Mark& mark) {
    assert(mark.free <= free() && mark.d_free <= d.free());
    entries.resize(mark.free);
    d.shrink(mark.d_free);
  }
  Index copy(Index i) {
    Entry same = entries[i];
    same.start = d.free();
    for (std::uint32_t k = 0; k < same.sides; ++k) d.put(d[entries[i].start + k]);
    entries.push_back(same);
    return free() - 1;
  }
};

}  // namespace displayfile
