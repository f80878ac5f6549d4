#include "displayfile/retained_primitives.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "clip/error.h"
#include "hidden/exact/plane.h"
#include "hidden/exact/support_plane.h"

namespace displayfile {

namespace {

using Attributes = RetainedScene::Attributes;

bool draws(const RetainedScene::Primitive& primitive, const Attributes& attributes) {
  return primitive.is_line() || attributes.fill.kind == FillStyle::Kind::solid ||
         attributes.line.kind != LineStyle::Kind::none;
}

SortItems::Kind kind_of(const RetainedScene::Primitive& primitive, const Attributes& attributes) {
  if (primitive.is_line()) return SortItems::Kind::line;
  return attributes.fill.kind == FillStyle::Kind::solid ? SortItems::Kind::solid
                                                        : SortItems::Kind::hollow;
}

double distance_off_plane(std::span<const Point3> polygon) {
  if (polygon.size() <= 3) return 0.0;
  const SupportVertices support = spread_vertices(polygon);
  if (support.edge_on) return 0.0;
  const auto& [p, q, r] = support.index;
  const Plane plane(polygon[p], polygon[q], polygon[r]);
  double most = 0.0;
  for (const Point3& v : polygon) most = std::max(most, std::abs(plane_value(v, plane).value));
  return most / glm::length(plane.normal);
}

}  // namespace

void RetainedPrimitives::add(const RetainedScene::Segment& segment) {
  const std::size_t before = points_.size();
  if (before + segment.points.size() >= std::numeric_limits<std::uint32_t>::max()) {
    throw Error("too many points to sort hidden surfaces: expected fewer than 2^32 - 1");
  }
  points_.insert(points_.end(), segment.points.begin(), segment.points.end());
  edge_visible_.insert(edge_visible_.end(), segment.edge_visible.begin(),
                       segment.edge_visible.end());
  if (!segment.vertex_normals.empty()) {
    vertex_normals_.resize(before, Point3(0.0));
    vertex_normals_.insert(vertex_normals_.end(), segment.vertex_normals.begin(),
                           segment.vertex_normals.end());
  }
  for (RetainedScene::Primitive primitive : segment.primitives) {
    const Attributes& attributes = segment.attributes[primitive.attributes];
    primitive.first += before;
    if (draws(primitive, attributes)) {
      items_.push_back({static_cast<std::uint32_t>(primitive.first), primitive.sides,
                        kind_of(primitive, attributes)});
      primitive_of_.push_back(static_cast<std::uint32_t>(primitives_.size()));
    }
    primitives_.push_back(primitive);
    segment_of_.push_back(static_cast<std::uint32_t>(segments_.size()));
    off_plane_.push_back(distance_off_plane(points(primitives_.size() - 1)));
  }
  segments_.push_back({segment.name, primitives_.size(), segment.attributes});
}

}  // namespace displayfile
