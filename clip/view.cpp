#include "clip/view.h"

#include <cmath>

#include "clip/error.h"

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

}  // namespace displayfile
