#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/base/memory.h"
#include "clip/base/round_to_nearest.h"
#include "clip/base/work_budget.h"
#include "clip/geometry/back_face.h"
#include "displayfile/entered/instructions.h"
#include "displayfile/looks/gouraud.h"
#include "displayfile/user_routines/surface_normals.h"
#include "displayfile/user_routines/system_state.h"

namespace displayfile {

namespace {

/// A point with unknown height has no cell, but the current position may be set to it.
double known_height(double z) { return std::isnan(z) ? 0.0 : z; }

/// The point with this number, as entered.
Point3 point_of(const SurfaceGrid& grid, std::size_t k) {
  const auto columns = static_cast<std::size_t>(grid.x_points);
  return {grid.x(static_cast<int>(k % columns)), grid.y(static_cast<int>(k / columns)),
          known_height(grid.heights[k])};
}

}  // namespace

void GraphicsSystem::set_surface_curves(SurfaceCurves curves) {
  state_->looks_.surfaces.curves = curves;
  state_->record("set-surface-curves", {name_of(curves)});
}

void GraphicsSystem::set_surface_sides(SurfaceSides sides) {
  state_->looks_.surfaces.sides = sides;
  state_->record("set-surface-sides", {name_of(sides)});
}

void GraphicsSystem::set_lower_line_style(const std::optional<LineStyle>& style) {
  if (!style) {
    state_->looks_.surfaces.lower_line.reset();
    return state_->record("set-lower-line-style", {"same"});
  }
  const LineStyle checked = state_->require_line_style(*style);
  state_->record_line_style("set-lower-line-style", checked);
  state_->looks_.surfaces.lower_line = checked;
  state_->replace_width(*state_->looks_.surfaces.lower_line);
}

void GraphicsSystem::surface_3(const SurfaceGrid& grid) {
  const RoundToNearest nearest;
  state_->require_open();
  state_->require_no_solid("a surface");
  require_surface(grid);
  state_->require_no_values_of_vertices("a surface");
  ask_budget();
  const std::vector<Point3> world = with_memory(
      grid.heights.size() * sizeof(Point3),
      [&] { return fmt::format("a surface of {} x {} points", grid.x_points, grid.y_points); },
      [&] { return state_->world_points_of(grid); });
  Segment& segment = state_->display_file_.segment(*state_->open_);
  const Point3 upward = state_->modelling_.apply_to_difference({0.0, 0.0, 1.0});
  auto x_points = static_cast<std::uint32_t>(grid.x_points);
  auto y_points = static_cast<std::uint32_t>(grid.y_points);
  if (state_->modelling_.mirrors()) std::swap(x_points, y_points);
  if (RetainedScene* scene = state_->retaining()) scene->mark_surface({upward, x_points, y_points});
  std::vector<Point3> entered;
  if (!state_->is_viewed_later()) {
    segment.mark_surface(
        {state_->view_stage_->pipeline().volume().infinitely_far(upward), x_points, y_points});
    state_->view_stage_->view_vertices(world);
    if (segment.keeping_entered() != nullptr) {
      for (std::size_t k = 0; k < world.size(); ++k) entered.push_back(point_of(grid, k));
      state_->view_stage_->note_entered(entered, state_->modelling_matrix(), segment);
    }
    const std::size_t triangles = 2 * grid.cells();
    segment.reserve_polygons(triangles, 3 * triangles,
                             state_->looks_.attributes.light ? triangles : 0);
  }
  state_->enter_cells(grid, world, segment);
  state_->pen_ = {{grid.x_max, grid.y_max, known_height(grid.heights.back())}, world.back()};
  if (state_->recorder_ == nullptr) return;
  state_->recorder_->write(
      "surface-3", {grid.x_min, grid.x_max, grid.x_points, grid.y_min, grid.y_max, grid.y_points},
      grid.heights);
}

/// Enters cells in the line styles of both sides of the surface; then restores that of other
/// primitives.
void GraphicsSystem::State::enter_cells(const SurfaceGrid& grid, std::span<const Point3> world,
                                        Segment& segment) {
  const LineStyle not_drawn{LineStyle::Kind::none};
  const LineStyle in_force = looks_.attributes.line;
  const LineStyle upper = looks_.surfaces.sides == SurfaceSides::lower ? not_drawn : in_force;
  LineStyle lower = looks_.surfaces.sides == SurfaceSides::upper
                        ? not_drawn
                        : looks_.surfaces.lower_line.value_or(in_force);
  lower.of_kinds = upper.of_kinds;
  if (upper != lower) {
    looks_.attributes.line = upper;
    looks_.attributes.dark_line = lower;
  }
  const auto restore = [&] {
    looks_.attributes.line = in_force;
    looks_.attributes.dark_line.reset();
    attributes_changed();
  };
  attributes_changed();
  try {
    enter_cells_in_order(grid, world, segment);
  } catch (...) {
    restore();
    throw;
  }
  restore();
}

/// Enters cells row by row; if the modelling transformation mirrors, column by column, which is row
/// by row with x and y exchanged: so the triangles run counterclockwise from above there too.
/// Ordinals go row by row.
void GraphicsSystem::State::enter_cells_in_order(const SurfaceGrid& grid,
                                                 std::span<const Point3> world, Segment& segment) {
  const int columns = grid.x_points - 1, rows = grid.y_points - 1;
  std::optional<SurfaceNormals> normals;
  if (looks_.attributes.light && looks_.attributes.shading != Shading::flat) {
    normals.emplace(grid, looks_.crease_degrees);
  }
  const SurfaceNormals* const smooth = normals ? &*normals : nullptr;
  std::vector<std::int64_t> next_of_row;
  for (int j = 0; j < rows; ++j) {
    if (modelling_.mirrors()) next_of_row.push_back(ordinal_);
    for (int i = 0; i < columns; ++i) {
      if (!grid.has_cell(i, j)) continue;
      const std::int64_t ordinal = ordinal_++;
      if (!modelling_.mirrors()) enter_cell(grid, world, {i, j, ordinal, smooth}, segment);
    }
  }
  if (!modelling_.mirrors()) return;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      if (!grid.has_cell(i, j)) continue;
      const std::int64_t ordinal = next_of_row[static_cast<std::size_t>(j)]++;
      enter_cell(grid, world, {i, j, ordinal, smooth}, segment);
    }
  }
}

/// The points in world coordinates; all are checked before any cell is entered.
std::vector<Point3> GraphicsSystem::State::world_points_of(const SurfaceGrid& grid) const {
  std::vector<Point3> world;
  world.reserve(grid.heights.size());
  for (std::size_t k = 0; k < grid.heights.size(); ++k)
    world.push_back(to_world(point_of(grid, k)));
  return world;
}

/// Enters two triangles, counterclockwise from above, with an invisible diagonal from the least
/// corner to the greatest.
void GraphicsSystem::State::enter_cell(const SurfaceGrid& grid, std::span<const Point3> world,
                                       const SurfaceCell& cell, Segment& segment) {
  const auto index = [&](int x, int y) {
    return static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(grid.x_points) +
           static_cast<std::uint32_t>(x);
  };
  const auto& [i, j, ordinal, normals] = cell;
  std::uint32_t b = index(i + 1, j), d = index(i, j + 1);
  const std::uint32_t a = index(i, j), c = index(i + 1, j + 1);
  std::uint8_t along_ab = looks_.surfaces.curves != SurfaceCurves::y;
  std::uint8_t along_ad = looks_.surfaces.curves != SurfaceCurves::x;
  if (modelling_.mirrors()) {
    std::swap(b, d);
    std::swap(along_ab, along_ad);
  }
  const int pick = pick_ >= 0 ? pick_ : pick_of_ordinal(ordinal);
  const bool plain =
      retaining() == nullptr && !is_viewed_later() && !cutting_planes_.any() && normals == nullptr;
  const auto enter_triangle = [&](const std::array<std::uint32_t, 3>& of_triangle,
                                  const std::array<std::uint8_t, 3>& edge_visible,
                                  std::span<Point3> vertex_normals) {
    if (plain && view_stage_->enter_triangle(world, {of_triangle, edge_visible, pick},
                                             looks_.attributes, segment)) {
      return;
    }
    const Point3 normal =
        looks_.attributes.light ? newell_normal(PointRow(world, of_triangle)) : Point3(0.0);
    const std::array entered{point_of(grid, of_triangle[0]), point_of(grid, of_triangle[1]),
                             point_of(grid, of_triangle[2])};
    for (Point3& n : vertex_normals) n = modelling_.apply_to_normal(n);
    if (!vertex_normals.empty()) orient(vertex_normals, normal);
    const WorldPolygon triangle{PointRow(world, of_triangle),
                                edge_visible,
                                normal,
                                vertex_normals,
                                pick,
                                entered,
                                modelling_matrix()};
    if (cutting_planes_.any()) return enter_cut(triangle);
    if (RetainedScene* scene = retaining()) scene->enter_polygon(triangle, looks_.attributes);
    if (!is_viewed_later())
      view_stage_->enter_shared(of_triangle, triangle, looks_.attributes, segment);
  };
  if (normals == nullptr) {
    enter_triangle({a, b, c}, {0, along_ab, along_ad}, {});
    enter_triangle({a, c, d}, {along_ad, 0, along_ab}, {});
    return;
  }
  auto of_abc = normals->of(i, j, SurfaceNormals::Half::abc);
  auto of_acd = normals->of(i, j, SurfaceNormals::Half::acd);
  if (modelling_.mirrors()) {  // b and d have changed places
    std::swap(of_abc, of_acd);
    std::swap(of_abc[1], of_abc[2]);
    std::swap(of_acd[1], of_acd[2]);
  }
  enter_triangle({a, b, c}, {0, along_ab, along_ad}, of_abc);
  enter_triangle({a, c, d}, {along_ad, 0, along_ab}, of_acd);
}

}  // namespace displayfile
