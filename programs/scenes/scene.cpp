#include "programs/scenes/scene.h"

#include "clip/geometry/rectangle.h"

namespace displayfile {

namespace {

/// Any colours will do as long as neighbours in order differ.
Colour colour_of(std::size_t polygon) {
  const auto component = [&](std::size_t step) {
    return 0.25 + static_cast<double>(polygon * step % 64) / 96.0;
  };
  return {component(37), component(23), component(11)};
}

void set_view_with_viewport(const View& view, GraphicsSystem& system) {
  set_view(view, system);
  const Rectangle& v = view.viewport;
  system.set_viewport(v.x_min, v.x_max, v.y_min, v.y_max);
}

void set_placement(const Scene::Placement& placement, GraphicsSystem& system) {
  const Point3 &move = placement.move, &turn = placement.degrees, &then_move = placement.then_move;
  system.create_transformation_3();
  system.translate_3(move.x, move.y, move.z);
  system.rotate_x_3(turn.x);
  system.rotate_y_3(turn.y);
  system.rotate_z_3(turn.z);
  system.translate_3(then_move.x, then_move.y, then_move.z);
}

/// Enters polygons one after the other, each under its placement.
class PolygonsInOrder {
 public:
  PolygonsInOrder(const Scene& scene, GraphicsSystem& system) : scene_(scene), system_(system) {}

  void enter_up_to(std::size_t end) {
    for (; polygon_ < end; ++polygon_) {
      place();
      system_.set_fill_style({FillStyle::Kind::solid, colour_of(polygon_)});
      system_.polygon_abs_3(std::span(scene_.points).subspan(vertex_, scene_.sides[polygon_]));
      vertex_ += scene_.sides[polygon_];
    }
  }

 private:
  void place() {
    for (; placement_ < scene_.placements.size(); ++placement_) {
      if (scene_.placements[placement_].first_polygon > polygon_) return;
      set_placement(scene_.placements[placement_], system_);
    }
  }

  const Scene& scene_;
  GraphicsSystem& system_;
  std::size_t polygon_ = 0, vertex_ = 0, placement_ = 0;
};

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
  system.set_hidden_surfaces({.touching = scene.touching});
  system.set_line_style({LineStyle::Kind::none});
  std::vector<Scene::Segment> segments = scene.segments;
  if (segments.empty() || segments.front().first_polygon > 0) {
    segments.insert(segments.begin(), Scene::Segment{0, {}});
  }
  if (!scene.placements.empty()) system.save_transformation_3();
  PolygonsInOrder polygons(scene, system);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const int name = static_cast<int>(s) + 1;
    if (segments[s].view) set_view_with_viewport(*segments[s].view, system);
    system.open_segment(name);
    polygons.enter_up_to(s + 1 < segments.size() ? segments[s + 1].first_polygon
                                                 : scene.polygons());
    system.close_segment();
    const ImageTransformation& image = segments[s].image;
    if (image.is_identity()) continue;
    system.set_image_scale(name, image.scale.x, image.scale.y);
    system.set_image_rotation(name, image.rotation);
    system.set_image_translation(name, image.translation.x, image.translation.y);
  }
  if (!scene.placements.empty()) system.restore_transformation_3();
}

GraphicsSystem entered(const Scene& scene) {
  GraphicsSystem system;
  enter(scene, system);
  return system;
}

}  // namespace displayfile
