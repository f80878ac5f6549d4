#pragma once

#include <span>
#include <vector>

namespace displayfile {

/// Joins loops into one even-odd polygon: each is joined to the first by a bridge there and back.
/// over_bridge(corner) is the corner reached over a bridge.
template <class Corner, class OverBridge>
std::vector<Corner> joined_by_bridges(std::span<const std::vector<Corner>> loops,
                                      const OverBridge& over_bridge) {
  if (loops.size() == 1) return loops.front();
  std::vector<Corner> polygon;
  for (const auto& loop : loops) {
    polygon.push_back(over_bridge(loop.front()));
    polygon.insert(polygon.end(), loop.begin() + 1, loop.end());
    polygon.push_back(loop.front());
    const bool is_last = &loop == &loops.back();  // its bridge back is the polygon's last side
    if (&loop != &loops.front() && !is_last) polygon.push_back(over_bridge(loops.front().front()));
  }
  return polygon;
}

}  // namespace displayfile
