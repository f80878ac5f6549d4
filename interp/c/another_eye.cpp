#include <algorithm>
#include <array>
#include <utility>

#include "displayfile/views/scene_in_one_view.h"
#include "interp/c/system.h"

using namespace displayfile;
using namespace displayfile::c;

namespace displayfile::c {

const RetainedScene& retained(const df_system& system) {
  if (system.recorder) return *system.system.retained();
  throw Error("another eye: expected df_retain to be called first");
}

namespace {

/// The system's other eye, in the view set by df_look_from, or else the application's.
OtherEye& other_eye(df_system& system) {
  if (!system.other) {
    system.other.emplace(system.system, retained(system), system.recorded.str());
  }
  system.other->set_view(system.eye.value_or(system.other->as_drawn()));
  return *system.other;
}

}  // namespace

OtherEye* eye_in_force(df_system& system) { return system.eye ? &other_eye(system) : nullptr; }

const GraphicsSystem& looked_at(df_system& system) {
  OtherEye* const eye = eye_in_force(system);
  return eye != nullptr ? eye->system() : system.system;
}

}  // namespace displayfile::c

namespace {

SceneInOneView scene_drawn(const df_system& system) {
  return scene_in_one_view(retained(system), system.system.display_file(), system.system.view());
}

Point3 point_of(const double* c) { return {c[0], c[1], c[2]}; }
void hand_out_point(const Point3& from, double* to) { std::copy_n(&from.x, 3, to); }
Rectangle rectangle_of(const double* c) { return {c[0], c[1], c[2], c[3]}; }
void hand_out_rectangle(const Rectangle& r, double* to) {
  std::ranges::copy(std::array{r.x_min, r.x_max, r.y_min, r.y_max}, to);
}

View view_of(const df_view& v) {
  View view;
  view.set_reference_point(point_of(v.reference_point));
  view.set_plane_normal(point_of(v.plane_normal));
  view.set_up(point_of(v.up));
  view.set_distance(v.distance);
  if (v.is_perspective != 0) {
    view.set_perspective(point_of(v.projection));
  } else {
    view.set_parallel(point_of(v.projection));
  }
  view.set_depth(v.depth[0], v.depth[1]);
  view.front_clipping = v.clips_front != 0;
  view.back_clipping = v.clips_back != 0;
  view.set_window(rectangle_of(v.window));
  view.set_viewport(rectangle_of(v.viewport));
  return view;
}

df_view parameters_of(const View& view) {
  df_view v{};
  hand_out_point(view.reference_point, v.reference_point);
  hand_out_point(view.plane_normal, v.plane_normal);
  hand_out_point(view.up, v.up);
  v.distance = view.distance;
  v.is_perspective = view.projection == View::Projection::perspective ? 1 : 0;
  hand_out_point(v.is_perspective ? view.centre_of_projection : view.direction_of_projection,
                 v.projection);
  v.depth[0] = view.front;
  v.depth[1] = view.back;
  v.clips_front = view.front_clipping ? 1 : 0;
  v.clips_back = view.back_clipping ? 1 : 0;
  hand_out_rectangle(view.window, v.window);
  hand_out_rectangle(view.viewport, v.viewport);
  return v;
}

}  // namespace

extern "C" {

int df_retain(df_system* system) {
  return carried_out(system, [&] {
    if (system->recorder) return;
    if (!system->is_new) {
      throw Error("a routine was called already: expected df_retain before all of them");
    }
    system->system.retain();
    system->recorder.emplace(system->recorded);
    system->system.set_recorder(&*system->recorder);
  });
}

int df_drawn_view(df_system* system, df_view* view) {
  return carried_out(system,
                     [&] { hand_out(parameters_of(scene_drawn(*system).view), view, "df_view"); });
}

int df_box(df_system* system, double box[6]) {
  return carried_out(system, [&] {
    require_given(box, "the box");
    const Bounds bounds = scene_drawn(*system).bounds;
    if (bounds.empty()) throw Error("nothing is visible: expected a box around something");
    hand_out_point(bounds.low, box);
    hand_out_point(bounds.high, box + 3);
  });
}

int df_look_from(df_system* system, const df_view* view) {
  return carried_out(system, [&] {
    if (view == nullptr) {
      system->eye.reset();
      return;
    }
    retained(*system);
    const auto before = std::exchange(system->eye, view_of(known(view, "df_view")));
    try {
      eye_in_force(*system);
    } catch (...) {
      system->eye = before;
      throw;
    }
  });
}

int df_program(df_system* system, const char** text, size_t* length) {
  return carried_out(system, [&] {
    require_given(text, "where the text goes");
    require_given(length, "where the length goes");
    retained(*system);
    const OtherEye* const eye = eye_in_force(*system);
    system->bytes = eye != nullptr ? eye->program() : system->recorded.str();
    hand_out_text(system->bytes, text, length);
  });
}

}  // extern "C"
