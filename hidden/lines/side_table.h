#pragma once

#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "hidden/lines/visible_lines.h"
#include "hidden/primitives.h"

namespace displayfile {

/// The sides of all polygons by position in space, in either direction, for finding shared ones.
/// Sides of length 0 are omitted.
class SideTable {
 public:
  enum class Sides {
    all,
    near_drawn,  ///< at least those with the same ends as a drawn one
  };
  explicit SideTable(const Primitives& items, Sides which = Sides::all);
  /// All sides between vertices, given the representative of each point (first_within of
  /// hidden/touching/vertices_within_reach.h).
  SideTable(const Primitives& items, std::vector<std::uint32_t> vertices);

  /// A side, in the list of its lower point.
  struct Side {
    std::uint32_t high;  ///< the other point
    LineName name;
  };
  /// The first point equal to this one, or its representative.
  std::uint32_t vertex(std::uint32_t point) const {
    assert(point < same_.size());
    return same_[point];
  }

  /// All sides with these ends, given as indices of points, in either direction; in order.
  std::span<const Side> sides_between(std::uint32_t a, std::uint32_t b) const;

  /// Calls visit with each set of sides with the same ends.
  template <class Visit>
  void for_each_set(const Visit& visit) const {
    for (std::size_t low = 0; low + 1 < first_.size(); ++low) {
      for (std::uint32_t from = first_[low]; from < first_[low + 1];) {
        std::uint32_t to = from + 1;
        while (to < first_[low + 1] && sides_[to].high == sides_[from].high) ++to;
        visit(std::span(sides_).subspan(from, to - from));
        from = to;
      }
    }
  }

 private:
  void find_low_ends_of_drawn(const Primitives& items);
  void find(const Primitives& items);

  std::vector<std::uint32_t> same_;  // per point, its vertex
  std::vector<std::uint32_t>
      first_;  // per point, the start of the list of sides with it as the lower point
  std::vector<Side> sides_;
  std::vector<std::uint8_t> is_low_;  // per point, whether a drawn side has it; empty: all
};

}  // namespace displayfile
