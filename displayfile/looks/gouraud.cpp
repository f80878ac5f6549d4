#include "displayfile/looks/gouraud.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>

#include "clip/geometry/back_face.h"
#include "clip/geometry/unit.h"

namespace displayfile {

namespace {

template <class T>
bool all_equal(std::span<const T> values) {
  return std::ranges::adjacent_find(values, std::not_equal_to<>()) == values.end();
}

Point3 unit_or_zero(const Point3& v) { return v == Point3(0.0) ? v : unit(v); }

}  // namespace

bool differ(std::span<const Point3> normals) { return !all_equal(normals); }

void orient(std::span<Point3> normals, const Point3& own) {
  Point3 sum(0.0);
  for (const Point3& n : normals) sum += unit_or_zero(n);
  const double sign = glm::dot(sum, unit_or_zero(own)) < 0.0 ? -1.0 : 1.0;
  for (Point3& n : normals) n = n == Point3(0.0) ? own : sign * n;
}

/// The visible side is known when the polygon is clipped; a back face that is not removed is
/// clipped again with the other side's intensities.
ClippedPolygon GouraudLighting::clip(ClipPipeline& pipeline, std::span<const Point3> world,
                                     std::span<const std::uint8_t> edge_visible,
                                     std::span<const Point3> normals, const Light& light) {
  assert(world.size() == normals.size());
  const auto clip_with_side_seen = [&](bool turned_away) {
    intensities_.clear();
    for (const Point3& n : normals) intensities_.push_back(intensity(light, n, turned_away));
    return pipeline.clip_polygon(world, edge_visible, intensities_);
  };
  const ClippedPolygon clipped = clip_with_side_seen(false);
  return newell_c(clipped.vertices) < 0.0 ? clip_with_side_seen(true) : clipped;
}

FillStyle shaded_fill(const FillStyle& fill, ClippedPolygon& clipped) {
  if (fill.kind == FillStyle::Kind::solid && !all_equal(clipped.intensities)) return fill;
  assert(clipped.intensities.size() == clipped.vertices.size());
  const double everywhere = clipped.intensities.front();
  clipped.intensities = {};
  return lit(fill, everywhere);
}

}  // namespace displayfile
