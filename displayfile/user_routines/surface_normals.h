#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "clip/geometry/crease_angle.h"
#include "clip/point.h"
#include "displayfile/graphics_system.h"

namespace displayfile {

/// Normals at the corners of a surface's triangles, for smooth shading, by the rule of meshes
/// (displayfile/looks/gouraud.md): the mean of the normals of the triangles around the point,
/// weighted by their angles there; with a crease angle below 180 degrees, of those that are
/// connected with the corner's own by sides at which they meet at no more than it. Before the
/// modelling transformation, all on one side of the surface; zero: the triangle's own.
class SurfaceNormals {
 public:
  SurfaceNormals(const SurfaceGrid& grid, double crease_degrees);

  /// The triangles of a cell with the corners a (its least), b (next in x), c, d (next in y).
  enum class Half { abc, acd };
  /// At a, b and c, or a, c and d, of the cell in that column and row. Of any length.
  std::array<Point3, 3> of(int column, int row, Half half) const;

 private:
  /// A place among the triangles around a point, counterclockwise from the side along x.
  static constexpr int kAround = 6;
  std::size_t point(int x, int y) const {
    return static_cast<std::size_t>(y) * columns_ + static_cast<std::size_t>(x);
  }
  /// The number of the triangle at that place, if the surface has it.
  bool find(int x, int y, int place, std::size_t& triangle) const;
  std::array<std::size_t, 3> corners(std::size_t triangle) const;
  Point3 weighted(std::size_t triangle, std::size_t corner) const;
  bool is_creased(std::size_t a, std::size_t b) const;
  Point3 mean_at(int x, int y, int place) const;

  std::vector<Point3> points_;  // 0 for unknown heights
  std::size_t columns_;         // of points
  int x_cells_, y_cells_;
  bool has_creases_;
  CreaseAngle crease_;
  std::vector<Point3> normals_;  // of length 1, two a cell; 0 where there is no cell
  std::vector<char> has_cell_;
};

}  // namespace displayfile
