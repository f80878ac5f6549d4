#include "displayfile/graphics_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "clip/error.h"
#include "clip/round_to_nearest.h"
#include "clip/view_volume.h"

namespace displayfile {

void GraphicsSystem::require_view_may_change() const {
  if (open_) {
    throw Error(fmt::format(
        "segment {} is open: view parameters are set before a segment is opened", *open_));
  }
}

void GraphicsSystem::set_view_reference_point(const Point3& p) {
  const RoundToNearest nearest;
  require_view_may_change();
  view_.set_reference_point(p);
  record_said(Setting::camera, "set-view-reference-point", {p.x, p.y, p.z});
}

void GraphicsSystem::set_view_plane_normal(const Point3& n) {
  const RoundToNearest nearest;
  require_view_may_change();
  view_.set_plane_normal(n);
  record_said(Setting::camera, "set-view-plane-normal", {n.x, n.y, n.z});
}

void GraphicsSystem::set_view_distance(double d) {
  const RoundToNearest nearest;
  require_view_may_change();
  view_.set_distance(d);
  record_said(Setting::camera, "set-view-distance", {d});
}

void GraphicsSystem::set_view_up(const Point3& up) {
  const RoundToNearest nearest;
  require_view_may_change();
  view_.set_up(up);
  record_said(Setting::camera, "set-view-up", {up.x, up.y, up.z});
}

void GraphicsSystem::set_parallel(const Point3& direction) {
  const RoundToNearest nearest;
  require_view_may_change();
  view_.set_parallel(direction);
  record_said(Setting::camera, "set-parallel", {direction.x, direction.y, direction.z});
}

void GraphicsSystem::set_perspective(const Point3& centre) {
  const RoundToNearest nearest;
  require_view_may_change();
  view_.set_perspective(centre);
  record_said(Setting::camera, "set-perspective", {centre.x, centre.y, centre.z});
}

void GraphicsSystem::set_view_depth(double front, double back) {
  const RoundToNearest nearest;
  require_view_may_change();
  view_.set_depth(front, back);
  record_said(Setting::view_depth, "set-view-depth", {front, back});
}

void GraphicsSystem::set_front_plane_clipping(bool on) {
  require_view_may_change();
  view_.front_clipping = on;
  record_said(Setting::front_plane_clipping, "set-front-plane-clipping", {on});
}

void GraphicsSystem::set_back_plane_clipping(bool on) {
  require_view_may_change();
  view_.back_clipping = on;
  record_said(Setting::back_plane_clipping, "set-back-plane-clipping", {on});
}

void GraphicsSystem::set_window(double x_min, double x_max, double y_min, double y_max) {
  const RoundToNearest nearest;
  require_view_may_change();
  view_.set_window({x_min, x_max, y_min, y_max});
  record_said(Setting::window, "set-window", {x_min, x_max, y_min, y_max});
}

void GraphicsSystem::set_viewport(double x_min, double x_max, double y_min, double y_max) {
  const RoundToNearest nearest;
  require_view_may_change();
  view_.set_viewport({x_min, x_max, y_min, y_max});
  record_said(Setting::viewport, "set-viewport", {x_min, x_max, y_min, y_max});
}

void GraphicsSystem::set_window_fit(WindowFit fit) {
  require_view_may_change();
  windows_.set_fit(fit);
  record_said(Setting::window_fit, "set-window-fit", {name_of(fit)});
}

void GraphicsSystem::set_aspect_ratio(double aspect) {
  const RoundToNearest nearest;
  require_view_may_change();
  windows_.set_aspect(aspect);
}

std::optional<Point3> GraphicsSystem::to_device(const Point3& p) const {
  const RoundToNearest nearest;
  const ViewVolume volume(windows_.in_picture(view_, said_));
  const HomogeneousPoint viewed = volume.transform(to_world(p));
  if (!(viewed.w > 0.0)) return std::nullopt;
  const Point3 device = volume.to_device(viewed);
  return in_range(device) ? std::optional(device) : std::nullopt;
}

bool GraphicsSystem::view_was_set() const {
  constexpr std::array kOfView{Setting::camera,
                               Setting::view_depth,
                               Setting::front_plane_clipping,
                               Setting::back_plane_clipping,
                               Setting::window,
                               Setting::viewport};
  return std::ranges::any_of(kOfView, [&](Setting setting) { return said_.contains(setting); });
}

}  // namespace displayfile
