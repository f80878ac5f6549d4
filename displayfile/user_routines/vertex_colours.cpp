#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "displayfile/looks/gouraud.h"
#include "displayfile/user_routines/ranges.h"
#include "displayfile/user_routines/system_state.h"

namespace displayfile {

void GraphicsSystem::set_vertex_colours(PointList<Colour> colours) {
  if (colours.size() == 1 || colours.size() == 2) {
    throw Error(
        fmt::format("colours of {} vertices: expected at least 3, or none", colours.size()));
  }
  for (const Colour& colour : colours) require_colour(colour);
  state_->vertex_colours_.assign(colours.begin(), colours.end());
  if (state_->recorder_ != nullptr) state_->recorder_->write("set-vertex-colours", colours, 3);
}

/// `before`: the primitive that has no such values.
void GraphicsSystem::State::require_no_values_of_vertices(std::string_view before) const {
  if (vertex_normals_.empty() && vertex_colours_.empty()) return;
  throw Error(fmt::format("{} of one polygon's vertices are set: expected none before {}",
                          vertex_normals_.empty() ? "colours" : "normals", before));
}

/// Pieces have no sides, so that dashes and kinds of lines are those of the whole polygon, which
/// follows hollow for its sides alone.
void GraphicsSystem::State::enter_in_colours(const OnePolygon& polygon) {
  const auto set_fill = [this](const FillStyle& fill) {
    looks_.attributes.fill = fill;
    attributes_changed();
  };
  const FillStyle before = looks_.attributes.fill;
  restoring(
      [&] {
        if (!differ(vertex_colours_)) {
          set_fill({FillStyle::Kind::solid, vertex_colours_.front()});
          return enter_one(polygon);
        }
        ask_budget();
        enter_colour_pieces(polygon);
        if (!looks_.attributes.is_outlined()) return;
        set_fill({FillStyle::Kind::hollow});
        OnePolygon sides = polygon;
        sides.vertex_normals = {};
        enter_one(sides);
      },
      [&] { set_fill(before); });
}

void GraphicsSystem::State::enter_colour_pieces(const OnePolygon& polygon) {
  const auto& [entered, normal, vertex_normals, pick, flat] = polygon;
  std::vector<Point3> points, world, normals;
  std::vector<std::uint8_t> no_sides;
  for (const auto& triangle : triangulation_.triangulate(world_points_, bent_polygons_seen_)) {
    std::array<ColouredCorner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = triangle.vertex[k];
      corners[k] = {entered[vertex], vertex_normals.empty() ? Point3(0.0) : vertex_normals[vertex],
                    vertex_colours_[vertex]};
    }
    colour_pieces_.cut(corners);
    for (std::size_t i = 0; i < colour_pieces_.size(); ++i) {
      const ColourPieces::Piece piece = colour_pieces_[i];
      points.clear();
      world.clear();
      normals.clear();
      for (const ColouredCorner& corner : piece.corners) {
        points.push_back(corner.point);
        world.push_back(modelling_.apply(corner.point));
        if (!vertex_normals.empty()) normals.push_back(corner.normal);
      }
      no_sides.assign(points.size(), 0);
      looks_.attributes.fill = {FillStyle::Kind::solid, piece.fill};
      attributes_changed();
      enter({world, no_sides, normal, normals, pick, points, modelling_matrix()});
    }
  }
}

}  // namespace displayfile
