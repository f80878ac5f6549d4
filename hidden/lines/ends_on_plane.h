#pragma once

#include "clip/point.h"
#include "hidden/ends_as_entered.h"
#include "hidden/exact/plane.h"
#include "hidden/lines/end_on_plane.h"
#include "hidden/lines/line_scene.h"

namespace displayfile {

/// Which ends of a line lie on a plane, since they are within reach of it. With both ends on it the
/// line lies in the plane, with one it is wholly on the side of the other.
struct EndsOnPlane {
  bool start = false, end = false;
  bool any() const { return start || end; }
  bool both() const { return start && end; }
};

/// A line's ends, as they were viewed and not moved on to its polygon's plane, and the plane of
/// another polygon, which is not edge-on. In doubles, by LineScene::touching, which what is within
/// reach does not exceed; then by what was entered, where that is at hand. An intersection lies in
/// the planes of its own polygons alone.
inline EndsOnPlane ends_on_plane(const LineScene& scene, const LineScene::Line& line,
                                 std::uint32_t polygon, const Plane& plane) {
  if (!(scene.touching() > 0.0) || scene.intersection(line) != nullptr) return {};
  if (line.own != LineScene::kNone && scene.share_plane(line.own, polygon)) return {true, true};
  const auto in_doubles = [&](std::uint32_t end) {
    return on_plane(scene.point(end), plane.p, plane.q, plane.r, scene.touching());
  };
  const OnPlane start = in_doubles(line.a), end = in_doubles(line.b);
  if (start == OnPlane::no && end == OnPlane::no) return {};
  const auto [of_start, of_end] = scene.places(line, polygon);
  const auto is_on = [](OnPlane rounded, EndsAsEntered::Place as_entered) {
    if (as_entered == EndsAsEntered::Place::unknown) return rounded == OnPlane::yes;
    return rounded != OnPlane::no && as_entered == EndsAsEntered::Place::on_plane;
  };
  return {is_on(start, of_start), is_on(end, of_end)};
}

}  // namespace displayfile
