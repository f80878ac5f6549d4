#include "displayfile/views/scene_in_one_view.h"

#include <fmt/format.h>

#include "clip/base/error.h"

namespace displayfile {

SceneInOneView scene_in_one_view(const RetainedScene& scene, const DisplayFile& attributes,
                                 const View& otherwise) {
  SceneInOneView result{otherwise, {}, {}, {}};
  const RetainedScene::Segment* first = nullptr;
  for (const RetainedScene::Segment& segment : scene.segments()) {
    if (!attributes.segment(segment.name).visible) continue;
    const auto texts = scene.texts(segment);
    if (segment.first == segment.end && texts.empty() && segment.annotations.empty()) continue;
    if (first == nullptr) {
      first = &segment;
      result.view = segment.view;
    } else if (segment.view != first->view) {
      throw Error(
          fmt::format("segments {} and {} are drawn in different views: expected one view for all",
                      first->name, segment.name));
    }
    const auto points = scene.points(segment);
    for (const Point3& p : points) result.bounds.include(p);
    result.points.insert(result.points.end(), points.begin(), points.end());
    for (const RetainedScene::Text& text : texts) {
      result.bounds.include(text.anchor);
      result.points.push_back(text.anchor);
      result.texts.push_back(
          {text.anchor, letters_at_anchor(scene.attributes(text).text, text.characters)});
    }
    for (const KeptAnnotation& annotation : segment.annotations) {
      for (const Point3& p : annotation.points) {
        result.bounds.include(p);
        result.points.push_back(p);
      }
    }
  }
  return result;
}

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
