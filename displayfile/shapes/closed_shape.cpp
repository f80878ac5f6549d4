#include "displayfile/shapes/closed_shape.h"
#include "displayfile/user_routines/system_inside.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/base/work_budget.h"
#include "clip/view/transformation.h"

namespace displayfile {

namespace {

void require_enterable(const GraphicsSystem& system, const ClosedShape& solid) {
  if (!system.open_segment_name()) throw Error("no segment open: open one first");
  for (const Point3& p : solid.vertices) {
    if (in_range(p) && in_range(system.modelling_transformation().apply(p))) continue;
    throw Error("coordinate of a shape out of range: expected at most 1e100 in magnitude");
  }
}

/// The shape with its polygons reversed, each from the same first corner.
ClosedShape turned_over(ClosedShape solid) {
  std::ptrdiff_t first = 0;
  const auto reverse = [&](auto& of_corners, std::ptrdiff_t end) {
    if (of_corners.empty()) return;
    std::reverse(of_corners.begin() + first + 1, of_corners.begin() + end);
  };
  for (const std::uint32_t sides : solid.sides) {
    const std::ptrdiff_t end = first + sides;
    reverse(solid.corners, end);
    reverse(solid.normals, end);
    first = end;
  }
  return solid;
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

void enter_as_it_is(GraphicsSystem& system, const ClosedShape& solid) {
  const bool smooth =
      system.looks().attributes.light && system.looks().attributes.shading != Shading::flat;
  if (solid.normals.empty() || !smooth) {
    return system.polygons_abs_3({solid.vertices, solid.corners, solid.sides});
  }
  require_enterable(system, solid);
  SystemInside::as_solid(system, [&] { enter_with_normals(system, solid); });
}

}  // namespace

void enter(GraphicsSystem& system, const ClosedShape& solid) {
  ask_budget();
  const bool mirrored = system.modelling_transformation().mirrors();
  mirrored ? enter_as_it_is(system, turned_over(solid)) : enter_as_it_is(system, solid);
}

}  // namespace displayfile
