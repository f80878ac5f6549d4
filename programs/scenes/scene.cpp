#include "programs/scenes/scene.h"

namespace displayfile {

namespace {

/// Any colours will do as long as neighbours in order differ.
Colour colour_of(std::size_t polygon) {
  const auto component = [&](std::size_t step) {
    return 0.25 + static_cast<double>(polygon * step % 64) / 96.0;
  };
  return {component(37), component(23), component(11)};
}

}  // namespace

View unit_view() {
  View view;
  view.set_window({0.0, 1.0, 0.0, 1.0});
  view.set_depth(-1.0, 0.0);
  return view;
}

void Scene::add(std::span<const Point3> polygon) {
  points.insert(points.end(), polygon.begin(), polygon.end());
  sides.push_back(static_cast<std::uint32_t>(polygon.size()));
}

void Scene::add(const std::vector<Polygon>& polygons) {
  for (const Polygon& polygon : polygons) add(polygon);
}

void enter(const Scene& scene, GraphicsSystem& system) {
  set_view(scene.view, system);
  system.set_touching(scene.touching);
  system.set_line_style({LineStyle::Kind::none});
  std::vector<Scene::Segment> segments = scene.segments;
  if (segments.empty() || segments.front().first_polygon > 0) {
    segments.insert(segments.begin(), Scene::Segment{0, {}});
  }
  const Point3* vertex = scene.points.data();
  std::size_t polygon = 0;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const std::size_t end =
        s + 1 < segments.size() ? segments[s + 1].first_polygon : scene.polygons();
    const int name = static_cast<int>(s) + 1;
    system.open_segment(name);
    for (; polygon < end; ++polygon) {
      system.set_fill_style({FillStyle::Kind::solid, colour_of(polygon)});
      system.polygon_abs_3(std::span(vertex, scene.sides[polygon]));
      vertex += scene.sides[polygon];
    }
    system.close_segment();
    const ImageTransformation& image = segments[s].image;
    if (image.is_identity()) continue;
    system.set_image_scale(name, image.scale.x, image.scale.y);
    system.set_image_rotation(name, image.rotation);
    system.set_image_translation(name, image.translation.x, image.translation.y);
  }
}

GraphicsSystem entered(const Scene& scene) {
  GraphicsSystem system;
  enter(scene, system);
  return system;
}

}  // namespace displayfile
