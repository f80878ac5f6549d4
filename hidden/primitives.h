#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <span>

#include "clip/point_row.h"
#include "hidden/ends_as_entered.h"
#include "hidden/surface_mark.h"

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
    std::uint32_t first;  ///< of its corners
    std::uint32_t sides;
    Kind kind;
  };
  std::span<const Point3> points;
  /// The points of the corners, as indices: corners that share a point name it twice. Empty: the
  /// corners are the points in a row.
  std::span<const std::uint32_t> corners;
  /// Whether the side that ends at the corner of the same index is drawn, 0 if not, and as which
  /// kinds of lines (clip/surfaces.h). Empty: all are, of no known kind.
  std::span<const std::uint8_t> visible;
  std::span<const Item> items;
  /// The plane that each polygon counts as lying in: three points that are not in line in the
  /// projection, maybe another's; each of its vertices counts as moved along z on to it. Polygons
  /// with the same three lie in one plane. Empty, and where the first is kOwnPlane: the support
  /// plane. The sorts take from it alone which polygons lie in one plane.
  using PlanePoints = std::array<std::uint32_t, 3>;
  std::span<const PlanePoints> planes = {};
  static constexpr std::uint32_t kOwnPlane = 0xffffffffu;
  /// What the depths of the three points that give a polygon's plane lack, by item: of the shared
  /// plane's, or of the support vertices in their order (Plane::rest). Empty: nothing.
  std::span<const Point3> plane_rests = {};
  /// The surfaces over grids that were entered, in order, for the perimeter method.
  std::span<const SurfaceMark> surfaces = {};
  /// By how much each coordinate of a point may be off that was entered in a plane: a line both of
  /// whose ends are no farther from a plane lies in it (hidden/lines/end_on_plane.h), and in the
  /// sorts most vertices are on planes that are no farther (hidden/sort/touching_vertices.md). 0:
  /// nothing touches but what coincides.
  double touching = 0.0;
  /// By how much viewing alone has rounded each coordinate, at most; 0 if nothing is known.
  double rounding = 0.0;
  /// Which ends of lines touch which planes. Null: nothing touches, or by `touching` alone.
  const EndsAsEntered* ends = nullptr;
  /// The items' numbers there; empty: they are counted from 0.
  std::span<const std::uint32_t> numbers = {};

  /// The places of a line's ends, by the items' numbers here.
  EndsAsEntered::Places places(std::uint32_t item, std::uint32_t corner,
                               std::uint32_t polygon) const {
    if (ends == nullptr) return EndsAsEntered::kUnknown;
    const auto number = [&](std::uint32_t i) { return numbers.empty() ? i : numbers[i]; };
    return ends->places(number(item), corner, number(polygon));
  }
  Point3 plane_rest(std::size_t item) const {
    return plane_rests.empty() ? Point3(0.0) : plane_rests[item];
  }
  bool has_own_plane(std::size_t item) const {
    assert(planes.empty() || item < planes.size());
    return planes.empty() || planes[item][0] == kOwnPlane;
  }
  std::size_t all_corners() const { return corners.empty() ? points.size() : corners.size(); }
  std::uint32_t point(std::uint32_t corner) const {
    assert(corner < all_corners());
    return corners.empty() ? corner : corners[corner];
  }
  PointRow points_of(const Item& item) const {
    if (corners.empty()) return points.subspan(item.first, item.sides);
    return {points, corners.subspan(item.first, item.sides)};
  }
  std::uint8_t visible_at(std::uint32_t corner) const {
    assert(visible.empty() || corner < visible.size());
    return visible.empty() ? std::uint8_t{1} : visible[corner];
  }
  bool is_visible(std::uint32_t corner) const { return visible_at(corner) != 0; }
};

}  // namespace displayfile
