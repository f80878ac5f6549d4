#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <span>

#include "clip/geometry/point_row.h"
#include "hidden/ends_as_entered.h"
#include "hidden/surface_mark.h"

namespace displayfile {

/// The polygons and lines of a scene, in order of entry, as input of hidden-surface methods: in
/// normalised device coordinates (parallel projectors along z, larger z nearer to the viewer), or
/// in world coordinates where stated. The arrays are the scene's own.
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
  /// Point indices of the corners; corners may share points. Empty: the points in order.
  std::span<const std::uint32_t> corners;
  /// For the side that ends at each corner: 0 if it is not drawn, otherwise its line kinds
  /// (clip/surfaces.h). Empty: all drawn, of unknown kind.
  std::span<const std::uint8_t> visible;
  std::span<const Item> items;
  /// The plane assigned to each polygon: three points that are not collinear in the projection,
  /// possibly another's; each of its vertices counts as moved along z onto it. Polygons with the
  /// same three points are coplanar. Empty, or with kOwnPlane first: the support plane. The sorts
  /// take coplanarity only from this.
  using PlanePoints = std::array<std::uint32_t, 3>;
  std::span<const PlanePoints> planes = {};
  static constexpr std::uint32_t kOwnPlane = 0xffffffffu;
  /// Rests of the depths of the three points of a polygon's plane, by item: of the shared plane's,
  /// or of the support vertices in their order (Plane::rest). Empty: none.
  std::span<const Point3> plane_rests = {};
  /// The surfaces over grids, in order of entry, for the perimeter method.
  std::span<const SurfaceMark> surfaces = {};
  /// Bound, per coordinate, on the error of a point entered in a plane: a line with both ends
  /// within it of a plane lies in it (hidden/lines/end_on_plane.h), and in the sorts most vertices
  /// within it are on planes (hidden/sort/touching_vertices.md). 0: only coincident parts touch.
  double touching = 0.0;
  /// Bound on the rounding of each coordinate by viewing alone; 0: unknown.
  double rounding = 0.0;
  /// The positions of line ends relative to planes. Null: nothing touches, or by `touching` only.
  const EndsAsEntered* ends = nullptr;
  /// The items' indices there; empty: the same as here.
  std::span<const std::uint32_t> numbers = {};

  /// The positions of a line's ends, by the items' indices here.
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
