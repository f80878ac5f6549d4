#include "displayfile/views/set_view.h"

namespace displayfile {

void set_camera(const View& view, GraphicsSystem& system) {
  system.set_view_reference_point(view.reference_point);
  system.set_view_plane_normal(view.plane_normal);
  system.set_view_distance(view.distance);
  system.set_view_up(view.up);
  if (view.projection == View::Projection::perspective) {
    system.set_perspective(view.centre_of_projection);
  } else {
    system.set_parallel(view.direction_of_projection);
  }
}

void set_view(const View& view, GraphicsSystem& system) {
  set_camera(view, system);
  system.set_view_depth(view.front, view.back);
  system.set_front_plane_clipping(view.front_clipping);
  system.set_back_plane_clipping(view.back_clipping);
  const auto& [x_min, x_max, y_min, y_max] = view.window;
  system.set_window(x_min, x_max, y_min, y_max);
}

}  // namespace displayfile
