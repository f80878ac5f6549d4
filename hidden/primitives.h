#pragma once

#include <cstdint>
#include <span>

#include "clip/point.h"

namespace displayfile {

/// The polygons and lines of a scene, in order of entry, as what finds hidden surfaces looks at
/// them: in normalised device coordinates (parallel projectors along z, larger z nearer to the
/// viewer), or in world coordinates where that is said. The arrays are the scene's own.
struct Primitives {
  enum class Kind : std::uint8_t {
    solid,   ///< hides what is behind it
    hollow,  ///< an outline: hidden by solid polygons, hides nothing
    line,    ///< two points: hidden by solid polygons, hides nothing
  };
  struct Item {
    std::uint32_t first;  ///< of its points
    std::uint32_t sides;
    Kind kind;
  };
  std::span<const Point3> points;
  /// Whether the side that ends at the point of the same index is drawn: 0 if not. Empty: all are.
  std::span<const std::uint8_t> visible;
  std::span<const Item> items;

  std::span<const Point3> points_of(const Item& item) const {
    return points.subspan(item.first, item.sides);
  }
  bool is_visible(std::uint32_t point) const { return visible.empty() || visible[point] != 0; }
};

}  // namespace displayfile
