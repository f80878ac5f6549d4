#include "hidden/map/map_place.h"

#include "hidden/exact/exact_point.h"
#include "hidden/exact/orientation.h"
#include "hidden/exact/predicate_counts.h"

namespace displayfile {

namespace {

struct PlanesOfPlace {
  PlanesOfPlace(const LineTable& scene, const MapPlace& place)
      : planes{scene.plane(place.of[0]), scene.plane(place.of[1]), scene.plane(place.of[2])} {}
  Definitions definitions() const { return {{}, planes}; }
  std::array<Plane, 3> planes;
};

}  // namespace

Point2 rounded(const LineTable& scene, const MapPlace& place) {
  const auto at = [&](std::size_t k) { return Point2(scene.point(place.of[k])); };
  switch (place.kind) {
    case MapPlace::Kind::point: return at(0) + 0.0;
    case MapPlace::Kind::crossing: return crossing_place(at(0), at(1), at(2), at(3));
    case MapPlace::Kind::meeting:
      return meeting_place(at(0), at(1), scene.plane(place.of[2]), scene.plane(place.of[3]));
    case MapPlace::Kind::planes: break;
  }
  return rounded(exact_place(scene, place));
}

ExactPlace exact_place(const LineTable& scene, const MapPlace& place) {
  const auto at = [&](std::size_t k) { return Point2(scene.point(place.of[k])); };
  switch (place.kind) {
    case MapPlace::Kind::point: return exact_place(at(0));
    case MapPlace::Kind::crossing: return exact_crossing_place(at(0), at(1), at(2), at(3));
    case MapPlace::Kind::meeting:
      return exact_meeting_place(at(0), at(1), scene.plane(place.of[2]), scene.plane(place.of[3]));
    case MapPlace::Kind::planes: break;
  }
  const PlanesOfPlace planes(scene, place);
  const ExactPoint p = exact_point(planes.definitions(), plane_cut(planes.definitions(), 0, 1, 2));
  return {p.xyz.x, p.xyz.y, p.w};
}

int compare_xy(const LineTable& scene, const MapPlace& p, const MapPlace& q) {
  if (p == q) return 0;
  count_exact(Predicate::line_parameter);
  return compare_xy(exact_place(scene, p), exact_place(scene, q));
}

int orientation(const LineTable& scene, const MapPlace& p, const MapPlace& q, const MapPlace& r) {
  using enum MapPlace::Kind;
  if (p.kind == point && q.kind == point && r.kind == point) {
    const auto at = [&](const MapPlace& place) { return Point2(scene.point(place.of[0])); };
    return orientation(at(p), at(q), at(r));
  }
  count_exact(Predicate::side_of_line);
  return orientation(exact_place(scene, p), exact_place(scene, q), exact_place(scene, r));
}

}  // namespace displayfile
