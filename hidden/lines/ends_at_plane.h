#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "hidden/ends_as_entered.h"
#include "hidden/exact/plane.h"
#include "hidden/lines/end_on_plane.h"
#include "hidden/lines/line_table.h"

namespace displayfile {

/// The positions of a line's ends relative to a plane, where viewing may have rounded them wrongly:
/// the sign of the plane's depth minus the line's at each, 0 if the end is within reach of it. With
/// both ends on the plane the line lies in it, with one it is entirely on the side of the other.
struct EndsAtPlane {
  std::optional<int> start, end;
};
/// The ends of a line that are corners of the polygon, and so on its plane.
struct EndsAtCorners {
  bool start = false, end = false;
};

/// True if the polygon is nearer than the line as a whole, by more than that: no matter which
/// planes the line's ends are within reach of, it hides the line where it covers it.
inline bool is_nearer_than_reach(const LineTable& scene, const LineTable::Line& line,
                                 std::uint32_t polygon, const Plane& plane) {
  const double farthest = scene.extent(polygon).z_min;
  const double nearest = line.by_plane ? double{scene.extent(line).z_max}
                                       : std::max(scene.point(line.a).z, scene.point(line.b).z);
  return farthest > nearest && farthest - reach_in_depth(scene.touching(), plane) > nearest;
}

/// The positions of a line's ends as viewed, not moved onto its polygon's plane, relative to the
/// plane of another polygon, which is not edge-on. In doubles, by LineTable::touching, which bounds
/// the distance of points within reach; then by the points as entered, if available. An
/// intersection line lies only in the planes of its own polygons.
inline EndsAtPlane ends_at_plane(const LineTable& scene, const LineTable::Line& line,
                                 std::uint32_t polygon, const Plane& plane,
                                 const EndsAtCorners& corners) {
  if (!(scene.touching() > 0.0) || scene.intersection(line) != nullptr) return {};
  if (line.own != LineTable::kNone && scene.share_plane(line.own, polygon)) return {0, 0};
  if (is_nearer_than_reach(scene, line, polygon, plane)) return {};
  const double far =
      scene.touching() * (1.0 + scene.most_shares() / std::abs(plane.normal.z)) * plane.reach;
  const auto in_doubles = [&](std::uint32_t end, bool is_corner) {
    const Point3& v = scene.point(end);
    if (is_corner || std::abs(plane_value(v, plane).value) > far) return OnPlane::no;
    return on_plane(v, plane, scene.touching());
  };
  const OnPlane start = in_doubles(line.a, corners.start), end = in_doubles(line.b, corners.end);
  if (start == OnPlane::no && end == OnPlane::no) return {};
  // Sides of polygons that are close to each other have their planes' depths, with rests.
  const bool planes_tell =
      !plane.is_plain() && line.own != LineTable::kNone && scene.has_rests(line.own);
  const auto sign = [&](OnPlane rounded, EndsAsEntered::Place place) -> std::optional<int> {
    if (rounded == OnPlane::no) return std::nullopt;
    if (planes_tell && place != EndsAsEntered::Place::on_plane) return std::nullopt;
    return sign_as_entered(place, rounded);
  };
  const auto [of_start, of_end] = scene.places(line, polygon);
  return {sign(start, of_start), sign(end, of_end)};
}

}  // namespace displayfile
