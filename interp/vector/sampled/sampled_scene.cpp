#include "interp/vector/sampled/sampled_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "clip/corners.h"
#include "displayfile/display_file.h"

namespace displayfile {

SampledScene::SampledScene(const DisplayFile& display_file, const PictureSize& picture_size)
    : scene(display_file), size(picture_size) {
  depths.reserve(scene.end());
  depths.emplace_back();
  for (Fill fill = 1; fill < scene.end(); ++fill) {
    depths.push_back(depths_of(scene.vertices(fill), scene.plane(fill)));
  }
  Fill next_fill = 1;
  const auto segments = scene.segments();
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const Item end = k + 1 < segments.size() ? segments[k + 1].first : scene.items();
    add_lines_of(segments[k].first, end, next_fill);
  }
}

SampledScene::Depths SampledScene::depths_of(std::span<const Point3> vertices,
                                             const Plane& plane) const {
  const auto [farthest, nearest] = std::ranges::minmax(vertices, {}, &Point3::z);
  return {PixelDepth(plane, size.width, size.height), nearest.z, farthest.z};
}

double SampledScene::length(const Point3& a, const Point3& b) const {
  return glm::length(Point2((b.x - a.x) * size.width, (b.y - a.y) * size.height));
}

/// The items are those of one segment.
void SampledScene::add_lines_of(Item first, Item end, Fill& next_fill) {
  std::optional<Point3> line_end;
  double drawn = 0.0;
  for (Item item = first; item < end; ++item) {
    const bool is_fill = next_fill < scene.end() && scene.item_of(next_fill) == item;
    const Fill fill = is_fill ? next_fill++ : ViewedScene::kBackground;
    if (scene.line_style(item).kind == LineStyle::Kind::none) continue;
    if (scene.kind(item) != Primitives::Kind::line) {
      add_sides(item, fill);
      continue;
    }
    const auto ends = scene.points(item);
    if (line_end != ends[0]) drawn = 0.0;
    lines.push_back({item, 1, fill, ends[0].z, ends[1].z, drawn});
    drawn += length(ends[0], ends[1]);
    line_end = ends[1];
  }
}

void SampledScene::add_sides(Item item, Fill fill) {
  const auto vertices = scene.points(item);
  std::optional<Depths> of_plane;  // none if the polygon is seen edge-on
  if (fill != ViewedScene::kBackground) {
    of_plane = depths[fill];
  } else if (const SupportVertices s = support_vertices(vertices); !s.edge_on) {
    const auto& [p, q, r] = s.index;
    of_plane = depths_of(vertices, Plane(vertices[p], vertices[q], vertices[r]));
  }
  const auto z_on_plane = [&](const Point3& v) {
    if (!of_plane) return v.z;
    const double z = of_plane->plane.at_point(v.x * size.width, v.y * size.height);
    // Seen nearly edge-on, the plane's doubles are worth less than the vertex's.
    return z >= of_plane->farthest && z <= of_plane->nearest ? z : v.z;
  };
  double drawn = 0.0;
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    const Point3& from = vertices[previous_corner<std::size_t>(i, vertices.size())];
    if (scene.edge_visible(item, i)) {
      lines.push_back({item, i, fill, z_on_plane(from), z_on_plane(vertices[i]), drawn});
      drawn += length(from, vertices[i]);
    } else {
      drawn = 0.0;
    }
  }
}

SampledScene::Line SampledScene::line(std::uint32_t index) const {
  const LineEntry& entry = lines[index];
  const auto points = scene.points(entry.item);
  const Point3& from = points[previous_corner<std::size_t>(entry.to, points.size())];
  const Point3& to = points[entry.to];
  return {{from.x, from.y, entry.from_z},
          {to.x, to.y, entry.to_z},
          entry.fill,
          scene.line_style(entry.item),
          scene.kind(entry.item) == Primitives::Kind::line
              ? kDrawn
              : scene.side_kinds(entry.item, entry.to)};
}

bool SampledScene::covers(Fill fill, double x, double y) const {
  bool inside = false;
  const auto polygon = scene.vertices(fill);
  Point3 from = to_pixels(polygon.back());
  for (const Point3& vertex : polygon) {
    const Point3 to = to_pixels(vertex);
    const Point3& low = from.y < to.y ? from : to;
    const Point3& high = from.y < to.y ? to : from;
    if (low.y < y && y <= high.y) {
      const double crossing = low.x + (y - low.y) * ((high.x - low.x) / (high.y - low.y));
      if (crossing <= x) inside = !inside;
    }
    from = to;
  }
  return inside;
}

}  // namespace displayfile
