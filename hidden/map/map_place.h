#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>

#include "hidden/exact/line_place.h"
#include "hidden/lines/line_table.h"

namespace displayfile {

/// A point of the projection where edges of a map may end, by its definition: indices of points and
/// polygons. The description is canonical.
struct MapPlace {
  enum class Kind : std::uint8_t {
    point,     ///< a point of the items
    crossing,  ///< where the line through two points crosses that through two others
    meeting,   ///< where two polygons' planes have the same depth above the line through two points
    planes,    ///< where three polygons' planes meet
  };
  Kind kind = Kind::point;
  /// The points, then the polygons, sorted, so that equal definitions are equal.
  std::array<std::uint32_t, 4> of{};

  bool operator==(const MapPlace&) const = default;

  static MapPlace at_point(std::uint32_t p) { return {Kind::point, {p, 0, 0, 0}}; }
  static MapPlace crossing(std::uint32_t a, std::uint32_t b, std::uint32_t p, std::uint32_t q) {
    assert(a != b && p != q);
    std::array one{std::min(a, b), std::max(a, b)}, other{std::min(p, q), std::max(p, q)};
    if (other < one) std::swap(one, other);
    return {Kind::crossing, {one[0], one[1], other[0], other[1]}};
  }
  static MapPlace meeting(std::uint32_t a, std::uint32_t b, std::uint32_t item,
                          std::uint32_t other) {
    assert(a != b && item != other);
    return {Kind::meeting,
            {std::min(a, b), std::max(a, b), std::min(item, other), std::max(item, other)}};
  }
  static MapPlace planes(std::uint32_t item, std::uint32_t second, std::uint32_t third) {
    std::array all{item, second, third};
    std::ranges::sort(all);
    assert(all[0] < all[1] && all[1] < all[2]);
    return {Kind::planes, {all[0], all[1], all[2], 0}};
  }
};

/// Each coordinate rounded once, to the nearest double.
Point2 rounded(const LineTable& scene, const MapPlace& place);
ExactPlace exact_place(const LineTable& scene, const MapPlace& place);

/// The order by x, then y, of the true points; 0 if they are one. compare_xy(p, q) =
/// -compare_xy(q, p).
int compare_xy(const LineTable& scene, const MapPlace& p, const MapPlace& q);
/// 1 if the true point r is left of the line from p to q, -1 if right of it, 0 on it.
/// orientation(p, q, r) = orientation(q, r, p) = -orientation(q, p, r).
int orientation(const LineTable& scene, const MapPlace& p, const MapPlace& q, const MapPlace& r);

}  // namespace displayfile
