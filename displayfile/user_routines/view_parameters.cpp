#include "displayfile/user_routines/system_state.h"

#include <fmt/format.h>

#include <optional>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "clip/view/view_volume.h"
#include "displayfile/user_routines/system_inside.h"
#include "displayfile/views/scene_in_one_view.h"

namespace displayfile {

void GraphicsSystem::State::require_view_may_change() const {
  if (open_) {
    throw Error(fmt::format(
        "segment {} is open: view parameters are set before a segment is opened", *open_));
  }
}

void GraphicsSystem::set_view_reference_point(const Point3& p) {
  const RoundToNearest nearest;
  state_->require_view_may_change();
  state_->view_.set_reference_point(p);
  state_->record_setting(Setting::camera, "set-view-reference-point", {p.x, p.y, p.z});
}

void GraphicsSystem::set_view_plane_normal(const Point3& n) {
  const RoundToNearest nearest;
  state_->require_view_may_change();
  state_->view_.set_plane_normal(n);
  state_->record_setting(Setting::camera, "set-view-plane-normal", {n.x, n.y, n.z});
}

void GraphicsSystem::set_view_distance(double d) {
  const RoundToNearest nearest;
  state_->require_view_may_change();
  state_->view_.set_distance(d);
  state_->record_setting(Setting::camera, "set-view-distance", {d});
}

void GraphicsSystem::set_view_up(const Point3& up) {
  const RoundToNearest nearest;
  state_->require_view_may_change();
  state_->view_.set_up(up);
  state_->record_setting(Setting::camera, "set-view-up", {up.x, up.y, up.z});
}

void GraphicsSystem::set_parallel(const Point3& direction) {
  const RoundToNearest nearest;
  state_->require_view_may_change();
  state_->view_.set_parallel(direction);
  state_->record_setting(Setting::camera, "set-parallel", {direction.x, direction.y, direction.z});
}

void GraphicsSystem::set_perspective(const Point3& centre) {
  const RoundToNearest nearest;
  state_->require_view_may_change();
  state_->view_.set_perspective(centre);
  state_->record_setting(Setting::camera, "set-perspective", {centre.x, centre.y, centre.z});
}

void GraphicsSystem::set_view_depth(double front, double back) {
  const RoundToNearest nearest;
  state_->require_view_may_change();
  state_->view_.set_depth(front, back);
  state_->record_setting(Setting::view_depth, "set-view-depth", {front, back});
}

void GraphicsSystem::set_front_plane_clipping(bool on) {
  state_->require_view_may_change();
  state_->view_.front_clipping = on;
  state_->record_setting(Setting::front_plane_clipping, "set-front-plane-clipping", {on});
}

void GraphicsSystem::set_back_plane_clipping(bool on) {
  state_->require_view_may_change();
  state_->view_.back_clipping = on;
  state_->record_setting(Setting::back_plane_clipping, "set-back-plane-clipping", {on});
}

void GraphicsSystem::set_window(double x_min, double x_max, double y_min, double y_max) {
  const RoundToNearest nearest;
  state_->require_view_may_change();
  state_->view_.set_window({x_min, x_max, y_min, y_max});
  state_->record_setting(Setting::window, "set-window", {x_min, x_max, y_min, y_max});
}

void GraphicsSystem::set_viewport(double x_min, double x_max, double y_min, double y_max) {
  const RoundToNearest nearest;
  state_->require_view_may_change();
  state_->view_.set_viewport({x_min, x_max, y_min, y_max});
  state_->record_setting(Setting::viewport, "set-viewport", {x_min, x_max, y_min, y_max});
}

void GraphicsSystem::set_view(const View& view) {
  Recorder::Hold recorded(state_->recorder_);
  const View before = state_->view_;
  const ExplicitSettings set_before = state_->explicit_;
  try {
    displayfile::set_view(view, *this);
    recorded.end();
  } catch (...) {
    state_->view_ = before;
    state_->explicit_ = set_before;
    throw;
  }
}

void GraphicsSystem::set_window_fit(WindowFit fit) {
  state_->require_view_may_change();
  state_->windows_.set_fit(fit);
  state_->record_setting(Setting::window_fit, "set-window-fit", {name_of(fit)});
}

void GraphicsSystem::set_aspect_ratio(double aspect) {
  const RoundToNearest nearest;
  state_->require_view_may_change();
  state_->windows_.set_aspect(aspect);
}

void SystemInside::set_scale(GraphicsSystem& system, const std::optional<ExactScale>& scale) {
  system.state_->require_view_may_change();
  system.state_->windows_.set_scale(scale);
}

const std::optional<ExactScale>& SystemInside::scale(const GraphicsSystem& system) {
  return system.state_->windows_.scale();
}

std::optional<Point3> GraphicsSystem::to_device(const Point3& p) const {
  const RoundToNearest nearest;
  const ViewVolume volume(state_->windows_.in_picture(state_->view_, state_->explicit_));
  const HomogeneousPoint viewed = volume.transform(state_->to_world(p));
  if (!(viewed.w > 0.0)) return std::nullopt;
  const Point3 device = volume.to_device(viewed);
  return in_range(device) ? std::optional(device) : std::nullopt;
}

}  // namespace displayfile
