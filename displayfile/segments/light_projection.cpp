#include "displayfile/segments/lit_parts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "clip/geometry/unit.h"

namespace displayfile {

namespace {

/// The middle of the picture and of the depth range.
constexpr double kMiddle = 0.5;

/// Two unit vectors perpendicular to a direction and to each other.
struct LightAxes {
  Point3 across, up;
  explicit LightAxes(const Point3& direction) {
    const Point3 size = glm::abs(direction);
    Point3 least(0.0);
    least[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1.0;
    across = unit(glm::cross(least, direction));
    up = glm::cross(direction, across);
  }
};

}  // namespace

/// A light whose image is a distant point, or at infinity: the directions toward it from the points
/// of the scene are nearly equal. W vanishes at the light and is 1 in the middle.
LightProjection LightProjection::from_afar(const HomogeneousPoint& light) {
  const Point3 middle(kMiddle);
  const Point3 toward = Point3(light) - light.w * middle;
  const LightAxes axes(unit(toward));
  const auto along = [&](const Point3& direction) {
    return Row(direction, -glm::dot(direction, middle));
  };
  LightProjection view;
  view.across_ = along(axes.across);
  view.up_ = along(axes.up);
  view.depth_ = along(unit(toward));
  view.weight_ = Row(0.0, 0.0, 0.0, 1.0) - along(toward) * (light.w / glm::dot(toward, toward));
  return view;
}

/// For perspective views. World points at infinity are in a plane of constant depth, which contains
/// the light and has the whole scene before it.
LightProjection LightProjection::from_nearby(const HomogeneousPoint& light) {
  const Point3 at = Point3(light) / light.w;
  LightProjection view;
  view.across_ = {1.0, 0.0, 0.0, -at.x};
  view.up_ = {0.0, 1.0, 0.0, -at.y};
  view.depth_ = {0.0, 0.0, 0.0, light.w > 0.0 ? 1.0 : -1.0};
  view.weight_ = {0.0, 0.0, 1.0, -at.z};
  return view;
}

bool LightProjection::is_before(std::span<const Point3> points) const {
  return std::ranges::all_of(points, [&](const Point3& p) {
    const Point3 seen = (*this)(p);
    return weight(p) > 0.0 && in_range(seen);
  });
}

std::optional<LightProjection> LightProjection::of(const HomogeneousPoint& light,
                                                   std::span<const Point3> points) {
  constexpr double kFar = 4.0;  // pictures are 1 wide
  const double size = glm::length(Point3(light));
  if (!(size > 0.0)) return std::nullopt;
  if (size > kFar * std::abs(light.w)) {
    const LightProjection view = from_afar(light);
    if (view.is_before(points)) return view;
  }
  if (light.w == 0.0) return std::nullopt;
  const LightProjection view = from_nearby(light);
  if (view.is_before(points)) return view;
  return std::nullopt;
}

Point3 LightProjection::operator()(const Point3& p) const {
  const double w = weight(p);
  return Point3(value(across_, p), value(up_, p), value(depth_, p)) / w;
}

}  // namespace displayfile
