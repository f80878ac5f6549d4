#include "displayfile/viewed_primitives.h"

#include "clip/back_face.h"
#include "displayfile/lighting.h"

namespace displayfile {

void ViewedPrimitives::view(const RetainedPrimitives& world, ClipPipeline& pipeline,
                            const glm::dmat3& lights_turned) {
  points_.clear();
  edge_visible_.clear();
  viewed_.assign(world.size(), {});
  for (std::size_t i = 0; i < world.size(); ++i) {
    viewed_[i].first = points_.size();
    if (world[i].is_line()) {
      view_line(world.points(i), pipeline, viewed_[i]);
    } else {
      view_polygon(world, i, pipeline, lights_turned, viewed_[i]);
    }
  }
}

void ViewedPrimitives::view_line(std::span<const Point3> world, const ClipPipeline& pipeline,
                                 Viewed& viewed) {
  Point3 a, b;
  if (!pipeline.clip_line(world[0], world[1], a, b)) return;
  points_.insert(points_.end(), {a, b});
  edge_visible_.insert(edge_visible_.end(), {0, 1});
  viewed.sides = 2;
}

/// As GraphicsSystem enters it. Of a polygon that was cut the pieces follow it: one that crosses
/// itself may turn another way than the whole.
void ViewedPrimitives::view_polygon(const RetainedPrimitives& world, std::size_t i,
                                    ClipPipeline& pipeline, const glm::dmat3& lights_turned,
                                    Viewed& viewed) {
  const ClippedPolygon clipped = pipeline.clip_polygon(world.points(i), world.edge_visible(i));
  if (clipped.vertices.size() < 3) return;
  const RetainedScene::Attributes& attributes = world.attributes(i);
  const double c = newell_c(clipped.vertices);
  if (attributes.back_face_removal && c <= 0.0) return;
  viewed.fill = attributes.fill;
  if (attributes.light) {
    Light light = *attributes.light;
    light.toward = lights_turned * light.toward;
    viewed.fill = lit(attributes.fill, light, world[i].normal, c < 0.0);
  }
  points_.insert(points_.end(), clipped.vertices.begin(), clipped.vertices.end());
  edge_visible_.insert(edge_visible_.end(), clipped.edge_visible.begin(),
                       clipped.edge_visible.end());
  viewed.sides = clipped.vertices.size();
}

}  // namespace displayfile
