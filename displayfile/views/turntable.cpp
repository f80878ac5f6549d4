#include "displayfile/views/turntable.h"

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "clip/base/round_to_nearest.h"
#include "clip/geometry/bounds.h"
#include "clip/geometry/unit.h"
#include "clip/view/transformation.h"
#include "clip/view/view_volume.h"
#include "displayfile/views/picture_windows.h"
#include "displayfile/views/scene_in_one_view.h"

namespace displayfile {

namespace {

constexpr int kViewsOfAllPoints = 64;

/// Rodrigues' formula; counterclockwise, seen from where the axis (a unit vector) points to.
glm::dmat3 rotation_about(const Point3& axis, double degrees) {
  const auto [sine, cosine] = sine_cosine_of_degrees(degrees);
  glm::dmat3 turn;
  for (int i = 0; i < 3; ++i) {
    Point3 e(0.0);
    e[i] = 1.0;
    turn[i] = e * cosine + glm::cross(axis, e) * sine + axis * (axis[i] * (1.0 - cosine));
  }
  return turn;
}

}  // namespace

Turntable::Turntable(const RetainedScene& scene, const DisplayFile& attributes,
                     const View& otherwise) {
  const RoundToNearest nearest;
  SceneInOneView seen = scene_in_one_view(scene, attributes, otherwise);
  view_ = seen.view;
  points_ = std::move(seen.points);
  axis_ = unit(view_.up);
  middle_ = points_.empty() ? view_.reference_point : seen.bounds.middle();
}

void Turntable::set_axis(const Point3& world) {
  const RoundToNearest nearest;
  axis_ = unit(world);
}

Turntable::Turn Turntable::at(double degrees) const {
  const RoundToNearest nearest;
  if (degrees == 0.0) return {view_, glm::dmat3(1.0)};
  const glm::dmat3 turn = rotation_about(axis_, -degrees);
  const auto about_middle = [&](const Point3& p) { return middle_ + turn * (p - middle_); };
  View view = view_;
  view.set_reference_point(about_middle(view_.reference_point));
  view.set_plane_normal(turn * view_.plane_normal);
  if (unit(view_.up) != axis_) view.set_up(turn * view_.up);
  if (view_.projection == View::Projection::perspective) {
    view.set_perspective(about_middle(view_.centre_of_projection));
  } else {
    view.set_parallel(turn * view_.direction_of_projection);
  }
  return {view, turn};
}

void Turntable::fit_window(int views) {
  const RoundToNearest nearest;
  if (points_.empty()) return;
  const Rectangle window = view_.window;
  const double width = window.x_max - window.x_min, height = window.y_max - window.y_min;
  Bounds seen;
  const auto see = [&](std::span<const Point3> points, int k) {
    const ViewVolume volume(at(360.0 * k / views).view);
    for (const Point3& point : points) {
      const HomogeneousPoint p = volume.transform(point);
      if (!(p.w > 0.0)) continue;
      seen.include({window.x_min + width * (p.x / p.w), window.y_min + height * (p.y / p.w), 0.0});
    }
  };
  // A few views leave few points that may be seen farther out in another.
  const int some = std::min(views, kViewsOfAllPoints);
  for (int k = 0; k < some; ++k) {
    see(points_, static_cast<int>(std::int64_t{k} * views / some));
  }
  if (some < views) {
    const std::vector<Point3> beyond = points_beyond({points_, axis_, middle_}, view_, seen);
    for (int k = 0; k < views; ++k) see(beyond, k);
  }
  if (!(seen.low.x <= seen.high.x)) return;
  const Rectangle fitted = fitted_window(seen, width / height);
  if (fitted.y_min < fitted.y_max) view_.set_window(fitted);
}

}  // namespace displayfile
