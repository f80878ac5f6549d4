#include "displayfile/viewed_primitives.h"

#include <optional>

#include "clip/back_face.h"
#include "displayfile/lighting.h"

namespace displayfile {

void ViewedPrimitives::view(const RetainedPrimitives& world, ClipPipeline& pipeline,
                            const glm::dmat3& lights_turned) {
  points_.clear();
  edge_visible_.clear();
  intensities_.clear();
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
  const RetainedScene::Attributes& attributes = world.attributes(i);
  std::optional<Light> light = attributes.light;
  if (light) light->toward = lights_turned * light->toward;
  const std::span<const Point3> normals = world.vertex_normals(i);
  const bool smooth = light && !normals.empty();
  ClippedPolygon clipped =
      smooth ? lighting_.clip(pipeline, world.points(i), world.edge_visible(i), normals, *light)
             : pipeline.clip_polygon(world.points(i), world.edge_visible(i));
  if (clipped.vertices.size() < 3) return;
  const double c = newell_c(clipped.vertices);
  if (attributes.back_face_removal && c <= 0.0) return;
  viewed.fill = attributes.fill;
  if (smooth) {
    viewed.fill = shaded_fill(attributes.fill, clipped);
  } else if (light) {
    viewed.fill = lit(attributes.fill, *light, world[i].normal, c < 0.0);
  }
  if (attributes.shadows && light) {
    viewed.fill.shadow = shadow_on(viewed.fill, attributes.fill, *light, pipeline.volume());
  }
  viewed.shaded = !clipped.intensities.empty();
  if (viewed.shaded) {
    intensities_.resize(points_.size());
    intensities_.insert(intensities_.end(), clipped.intensities.begin(), clipped.intensities.end());
  }
  points_.insert(points_.end(), clipped.vertices.begin(), clipped.vertices.end());
  edge_visible_.insert(edge_visible_.end(), clipped.edge_visible.begin(),
                       clipped.edge_visible.end());
  viewed.sides = clipped.vertices.size();
}

}  // namespace displayfile
