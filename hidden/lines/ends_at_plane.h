#pragma once

#include <cstdint>
#include <optional>

#include "hidden/ends_as_entered.h"
#include "hidden/exact/plane.h"
#include "hidden/lines/end_on_plane.h"
#include "hidden/lines/line_scene.h"

namespace displayfile {

/// Where a line's ends are to a plane, as far as viewing may have rounded that to anything else:
/// the sign of the plane's depth less the line's at each, 0 where the end is within reach of it.
/// With both ends on the plane the line lies in it, with one it is wholly on the side of the other.
struct EndsAtPlane {
  std::optional<int> start, end;
  bool are_both_on() const { return start == 0 && end == 0; }
};

/// A line's ends, as they were viewed and not moved on to its polygon's plane, and the plane of
/// another polygon, which is not edge-on. In doubles, by LineScene::touching, which what is within
/// reach does not exceed; then by what was entered, where that is at hand. An intersection lies in
/// the planes of its own polygons alone.
inline EndsAtPlane ends_at_plane(const LineScene& scene, const LineScene::Line& line,
                                 std::uint32_t polygon, const Plane& plane) {
  if (!(scene.touching() > 0.0) || scene.intersection(line) != nullptr) return {};
  if (line.own != LineScene::kNone && scene.share_plane(line.own, polygon)) return {0, 0};
  const OnPlane start = on_plane(scene.point(line.a), plane, scene.touching());
  const OnPlane end = on_plane(scene.point(line.b), plane, scene.touching());
  if (start == OnPlane::no && end == OnPlane::no) return {};
  const auto sign = [](OnPlane rounded, EndsAsEntered::Place place) -> std::optional<int> {
    using Place = EndsAsEntered::Place;
    if (rounded == OnPlane::no) return std::nullopt;
    switch (place) {
      case Place::unknown: break;
      case Place::on_plane: return 0;
      case Place::before: return -1;
      case Place::behind: return 1;
      case Place::off_plane: return std::nullopt;
    }
    return rounded == OnPlane::yes ? std::optional(0) : std::nullopt;
  };
  const auto [of_start, of_end] = scene.places(line, polygon);
  return {sign(start, of_start), sign(end, of_end)};
}

}  // namespace displayfile
