#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "clip/back_face.h"
#include "clip/error.h"
#include "clip/memory.h"
#include "displayfile/graphics_system.h"

namespace displayfile {

void GraphicsSystem::set_surface_curves(SurfaceCurves curves) {
  surface_curves_ = curves;
  record("set-surface-curves", {name_of(curves)});
}

void GraphicsSystem::surface_3(const SurfaceGrid& grid) {
  require_open();
  require_surface(grid);
  if (!vertex_normals_.empty()) {
    throw Error("normals of one polygon's vertices are set: expected none before a surface");
  }
  const std::vector<Point3> world = with_memory(
      grid.heights.size() * sizeof(Point3),
      [&] { return fmt::format("a surface of {} x {} points", grid.x_points, grid.y_points); },
      [&] { return world_points_of(grid); });
  for (int j = 0; j + 1 < grid.y_points; ++j) {
    for (int i = 0; i + 1 < grid.x_points; ++i) enter_cell(grid, world, i, j);
  }
  // An unknown height leaves the current position in the grid's plane.
  const double last = grid.heights.back();
  const Point3 end(grid.x_max, grid.y_max, std::isnan(last) ? 0.0 : last);
  pen_ = {end, to_world(end)};
  if (recorder_ == nullptr) return;
  recorder_->write("surface-3",
                   {grid.x_min, grid.x_max, grid.x_points, grid.y_min, grid.y_max, grid.y_points},
                   grid.heights);
}

/// All are looked at before any is entered. Those of holes are never used.
std::vector<Point3> GraphicsSystem::world_points_of(const SurfaceGrid& grid) const {
  std::vector<Point3> world;
  world.reserve(grid.heights.size());
  for (int j = 0; j < grid.y_points; ++j) {
    for (int i = 0; i < grid.x_points; ++i) {
      const double z = grid.heights[world.size()];
      world.push_back(to_world({grid.x(i), grid.y(j), std::isnan(z) ? 0.0 : z}));
    }
  }
  return world;
}

/// Two triangles, counterclockwise from above, with an invisible diagonal from the least corner to
/// the greatest; nothing if the surface has a hole in one of its corners.
void GraphicsSystem::enter_cell(const SurfaceGrid& grid, std::span<const Point3> world, int i,
                                int j) {
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.x_points) +
           static_cast<std::size_t>(x);
  };
  const std::array corners{index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)};
  for (const std::size_t corner : corners) {
    if (std::isnan(grid.heights[corner])) return;
  }
  const std::uint8_t of_x = surface_curves_ != SurfaceCurves::y;
  const std::uint8_t of_y = surface_curves_ != SurfaceCurves::x;
  const int pick = pick_ >= 0 ? pick_ : static_cast<int>(ordinal_);
  ++ordinal_;
  const auto enter_triangle = [&](const std::array<Point3, 3>& triangle,
                                  const std::array<std::uint8_t, 3>& edge_visible) {
    const Point3 normal = attributes_.light ? newell_normal(std::span(triangle)) : Point3(0.0);
    enter({std::span(triangle), edge_visible, normal, {}, pick});
  };
  const Point3 &a = world[corners[0]], &b = world[corners[1]], &c = world[corners[2]],
               &d = world[corners[3]];
  enter_triangle({a, b, c}, {0, of_x, of_y});
  enter_triangle({a, c, d}, {of_y, 0, of_x});
}

}  // namespace displayfile
