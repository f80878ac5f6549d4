#include "displayfile/shapes/closed_shape.h"

#include <algorithm>
#include <span>

#include "clip/error.h"

namespace displayfile {

namespace {

void require_enterable(const GraphicsSystem& system, const ClosedShape& solid) {
  if (!system.open_segment_name()) throw Error("no segment open: open one first");
  for (const Point3& p : solid.vertices) {
    if (in_range(p) && in_range(system.modelling_transformation().apply(p))) continue;
    throw Error("coordinate of a shape out of range: expected at most 1e100 in magnitude");
  }
}

void enter_with_normals(GraphicsSystem& system, const ClosedShape& solid) {
  std::vector<Point3> vertices;
  std::size_t first = 0;
  for (const std::uint32_t sides : solid.sides) {
    vertices.clear();
    for (const std::uint32_t corner : std::span(solid.corners).subspan(first, sides)) {
      vertices.push_back(solid.vertices[corner]);
    }
    const auto normals = std::span(solid.normals).subspan(first, sides);
    const bool is_flat = std::ranges::count(normals, Point3(0.0)) > 0;
    system.set_vertex_normals(is_flat ? std::span<const Point3>() : normals);
    system.polygon_abs_3(vertices);
    first += sides;
  }
}

}  // namespace

void enter(GraphicsSystem& system, const ClosedShape& solid) {
  const bool smooth = system.attributes().light && system.shading() != Shading::flat;
  if (solid.normals.empty() || !smooth) {
    return system.polygons_abs_3(solid.vertices, solid.corners, solid.sides);
  }
  require_enterable(system, solid);
  system.as_solid([&] { enter_with_normals(system, solid); });
}

}  // namespace displayfile
