#include "displayfile/graphics_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "clip/view/transformation.h"
#include "displayfile/shapes/closed_shape.h"
#include "displayfile/shapes/swept.h"

namespace displayfile {

namespace {

void require_corners(const char* shape, const Point3& low, const Point3& high) {
  for (int a = 0; a < 3; ++a) {
    if (low[a] < high[a]) continue;
    const char axis = "xyz"[a];
    throw Error(
        fmt::format("{0} from {1} {2} to {3}: expected {1}-min < {1}-max, in this order: "
                    "x-min x-max y-min y-max z-min z-max",
                    shape, axis, low[a], high[a]));
  }
}

void require_length(const char* what, double value) {
  if (value > 0.0 && value <= kCoordinateLimit) return;
  throw Error(fmt::format("{} {}: expected a number above 0, at most 1e100", what, value));
}

void enter_moved(GraphicsSystem& system, const Point3& to, ClosedShape solid) {
  for (Point3& p : solid.vertices) p += to;
  enter(system, solid);
}

int half_of(int facets) { return (facets + 1) / 2; }

}  // namespace

void box_3(GraphicsSystem& system, const Point3& low, const Point3& high) {
  const RoundToNearest nearest;
  require_corners("box", low, high);
  const std::array base{Point2(low), Point2(high.x, low.y), Point2(high), Point2(low.x, high.y)};
  enter(system, extruded(base, low.z, high.z));
}

void wedge_3(GraphicsSystem& system, const Point3& low, const Point3& high) {
  const RoundToNearest nearest;
  require_corners("wedge", low, high);
  ClosedShape wedge;
  wedge.vertices = {low,
                    {high.x, low.y, low.z},
                    {high.x, high.y, low.z},
                    {low.x, high.y, low.z},
                    {low.x, low.y, high.z},
                    {low.x, high.y, high.z}};
  wedge.add({0, 3, 2, 1});  // the base
  wedge.add({1, 2, 5, 4});  // the slope
  wedge.add({0, 1, 4});
  wedge.add({2, 3, 5});
  wedge.add({0, 4, 5, 3});
  enter(system, wedge);
}

void prism_3(GraphicsSystem& system, const Point3& base, double radius, double height, int sides) {
  const RoundToNearest nearest;
  require_length("radius", radius);
  require_length("height", height);
  const std::array profile{Point2(0.0, 0.0), Point2(radius, 0.0), Point2(radius, height),
                           Point2(0.0, height)};
  enter_moved(system, base, turned(profile, sides, TurnedLight::facets));
}

void cylinder_3(GraphicsSystem& system, const Point3& base, double radius, double height,
                int facets) {
  const RoundToNearest nearest;
  cone_3(system, base, radius, height, facets, radius);
}

void cone_3(GraphicsSystem& system, const Point3& base, double radius, double height, int facets,
            double top_radius) {
  const RoundToNearest nearest;
  require_length("radius", radius);
  require_length("height", height);
  if (!(top_radius >= 0.0 && top_radius <= kCoordinateLimit)) {
    throw Error(fmt::format("top radius {}: expected 0 or more, at most 1e100", top_radius));
  }
  std::vector<Point2> profile{{0.0, 0.0}, {radius, 0.0}};
  if (top_radius != 0.0) profile.emplace_back(top_radius, height);
  profile.emplace_back(0.0, height);
  enter_moved(system, base, turned(profile, facets, TurnedLight::round));
}

void sphere_3(GraphicsSystem& system, const Point3& centre, double radius, int facets) {
  const RoundToNearest nearest;
  require_length("radius", radius);
  require_facets(facets);
  const int rings = std::max(2, half_of(facets));
  std::vector<Point2> profile, normals;
  for (int k = 0; k <= rings; ++k) {
    const auto [sine, cosine] = sine_cosine_of_degrees(-90.0 + 180.0 * k / rings);
    normals.emplace_back(cosine, sine);
    profile.push_back(radius * normals.back());
  }
  enter_moved(system, centre, turned(profile, facets, TurnedLight::smooth, normals));
}

void torus_3(GraphicsSystem& system, const Point3& centre, double radius, double tube_radius,
             int facets) {
  const RoundToNearest nearest;
  require_length("radius", radius);
  require_length("tube radius", tube_radius);
  require_facets(facets);
  if (!(tube_radius < radius)) {
    throw Error(
        fmt::format("tube radius {}: expected less than the ring's, {}", tube_radius, radius));
  }
  const int of_tube = std::max(kFewestFacets, half_of(facets));
  std::vector<Point2> profile, normals;
  for (int k = 0; k < of_tube; ++k) {
    const auto [sine, cosine] = sine_cosine_of_degrees(360.0 * k / of_tube);
    normals.emplace_back(cosine, sine);
    profile.push_back(Point2(radius, 0.0) + tube_radius * normals.back());
  }
  enter_moved(system, centre, turned(profile, facets, TurnedLight::smooth, normals));
}

void extrude_3(GraphicsSystem& system, double z_min, double z_max,
               std::span<const Point2> profile) {
  const RoundToNearest nearest;
  enter(system, extruded(profile, z_min, z_max));
}

void turn_3(GraphicsSystem& system, int facets, std::span<const Point2> profile) {
  const RoundToNearest nearest;
  enter(system, turned(profile, facets, TurnedLight::round));
}

}  // namespace displayfile
