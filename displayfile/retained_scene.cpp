#include "displayfile/retained_scene.h"

#include <algorithm>
#include <array>

namespace displayfile {

void RetainedScene::open_segment(int name, const View& view) {
  segments_.push_back({name, view, {}, {}, {}, {}, {}});
}

void RetainedScene::remove(int name) {
  std::erase_if(segments_, [&](const Segment& segment) { return segment.name == name; });
}

void RetainedScene::rename(int from, int to) {
  const auto segment = std::ranges::find(segments_, from, &Segment::name);
  if (segment != segments_.end()) segment->name = to;
}

void RetainedScene::enter_polygon(std::span<const Point3> world,
                                  std::span<const std::uint8_t> edge_visible,
                                  const Attributes& attributes, const Point3& normal,
                                  std::span<const Point3> vertex_normals, std::int32_t pick) {
  enter(world, edge_visible, attributes, normal, pick);
  if (vertex_normals.empty() || segments_.empty()) return;
  Segment& segment = segments_.back();
  segment.vertex_normals.resize(segment.points.size() - world.size(), Point3(0.0));
  segment.vertex_normals.insert(segment.vertex_normals.end(), vertex_normals.begin(),
                                vertex_normals.end());
}

void RetainedScene::enter_line(const Point3& from, const Point3& to, const Attributes& attributes) {
  enter(std::array{from, to}, {}, attributes, Point3(0.0), -1);
}

void RetainedScene::enter(std::span<const Point3> points,
                          std::span<const std::uint8_t> edge_visible, const Attributes& attributes,
                          const Point3& normal, std::int32_t pick) {
  if (segments_.empty()) return;  // opened before the scene was retained
  Segment& segment = segments_.back();
  if (segment.attributes.empty() || segment.attributes.back() != attributes) {
    segment.attributes.push_back(attributes);
  }
  segment.primitives.push_back({segment.points.size(), static_cast<std::uint32_t>(points.size()),
                                static_cast<std::uint32_t>(segment.attributes.size() - 1), pick,
                                normal});
  segment.points.insert(segment.points.end(), points.begin(), points.end());
  segment.edge_visible.insert(segment.edge_visible.end(), edge_visible.begin(), edge_visible.end());
  segment.edge_visible.resize(segment.points.size(), 1);
}

}  // namespace displayfile
