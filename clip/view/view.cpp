#include "clip/view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "clip/geometry/unit.h"
#include "clip/view/transformation.h"

namespace displayfile {

namespace {

void require_in_range(const Point3& p, const char* what) {
  if (!in_range(p)) {
    throw Error(std::string(what) + " is not a finite number of magnitude at most 1e100");
  }
}

void require_in_range(double value, const char* what) { require_in_range({value, 0, 0}, what); }

void require_area(const Rectangle& r, const char* what) {
  require_in_range({r.x_min, r.x_max, 0}, what);
  require_in_range({r.y_min, r.y_max, 0}, what);
  if (!(r.x_min < r.x_max && r.y_min < r.y_max)) {
    throw Error(std::string(what) +
                " has no area: expected x-min < x-max and y-min < y-max, in this order: "
                "x-min x-max y-min y-max");
  }
}

}  // namespace

void View::set_reference_point(const Point3& world) {
  require_in_range(world, "view reference point");
  reference_point = world;
}

void View::set_plane_normal(const Point3& world) {
  require_in_range(world, "view plane normal");
  if (world == Point3(0.0)) throw Error("view plane normal is zero: expected a direction");
  plane_normal = world;
}

void View::set_distance(double d) {
  require_in_range(d, "view distance");
  distance = d;
}

void View::set_up(const Point3& world) {
  require_in_range(world, "view up");
  if (world == Point3(0.0)) throw Error("view up is zero: expected a direction");
  up = world;
}

void View::set_parallel(const Point3& world_direction) {
  require_in_range(world_direction, "direction of projection");
  if (world_direction == Point3(0.0)) {
    throw Error("direction of projection is zero: expected a direction");
  }
  projection = Projection::parallel;
  direction_of_projection = world_direction;
}

void View::set_perspective(const Point3& world_centre) {
  require_in_range(world_centre, "centre of projection");
  projection = Projection::perspective;
  centre_of_projection = world_centre;
}

void View::set_depth(double front_distance, double back_distance) {
  require_in_range({front_distance, back_distance, 0}, "view depth");
  if (!(front_distance < back_distance)) {
    throw Error("front plane behind back plane: expected front distance < back distance");
  }
  front = front_distance;
  back = back_distance;
}

void View::set_window(const Rectangle& view_plane) {
  require_area(view_plane, "window");
  window = view_plane;
}

void View::set_viewport(const Rectangle& device) {
  require_area(device, "viewport");
  if (device.x_min < 0.0 || device.x_max > 1.0 || device.y_min < 0.0 || device.y_max > 1.0) {
    throw Error("viewport leaves the display: expected values within 0 to 1");
  }
  viewport = device;
}

View look_at(const Point3& eye, const Point3& target, const Point3& up, double angle_of_view) {
  constexpr double kAlongUp = 1e-9;        // the sine of an angle
  constexpr double kBeforeTarget = 0.999;  // the front plane's distance, as a fraction of the eye's
  const RoundToNearest nearest;
  require_in_range(eye, "eye");
  View view;
  view.set_reference_point(target);
  view.set_up(up);
  const Point3 along = target - eye;
  if (along == Point3(0.0)) throw Error("the eye is at the target: expected another point");
  require_in_range(along, "line of sight");
  if (glm::length(glm::cross(unit(along), unit(up))) <= kAlongUp) {
    throw Error("view up is along the line of sight: expected another direction");
  }
  if (!(angle_of_view > 0.0 && angle_of_view < 180.0)) {
    throw Error("angle of view " + std::to_string(angle_of_view) +
                ": expected degrees, more than 0 and less than 180");
  }
  const double largest = std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)});
  const double distance = largest * glm::length(along / largest);
  const auto [sine, cosine] = sine_cosine_of_degrees(0.5 * angle_of_view);
  const double half = distance * (sine / cosine);
  view.set_plane_normal(along);
  view.set_perspective(eye);
  view.set_depth(-kBeforeTarget * distance, distance);
  view.set_window({-half, half, -half, half});
  return view;
}

}  // namespace displayfile
