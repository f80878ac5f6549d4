#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace displayfile {

/// The polygons that cover a pixel centre, are exactly as near there as the visible polygon, and
/// were entered before it: only the order of entry hides them. Pixels are numbered as in the item
/// buffer.
class DepthTies {
 public:
  /// True if a polygon with this pick identifier ties with the one visible at the pixel.
  bool contains(std::size_t pixel, std::int32_t pick) const {
    const auto found = picks_.find(pixel);
    return found != picks_.end() && std::ranges::find(found->second, pick) != found->second.end();
  }

  void add(std::size_t pixel, std::int32_t pick) { picks_[pixel].push_back(pick); }
  /// Must be called when a polygon is nearer at the pixel than all before it.
  void clear(std::size_t pixel) {
    if (!picks_.empty()) picks_.erase(pixel);
  }

 private:
  std::unordered_map<std::size_t, std::vector<std::int32_t>> picks_;
};

}  // namespace displayfile
