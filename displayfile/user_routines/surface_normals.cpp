#include "displayfile/user_routines/surface_normals.h"

#include <cmath>

#include "clip/geometry/back_face.h"
#include "clip/geometry/unit.h"

namespace displayfile {

namespace {

/// Where the triangle at each place around a point is: the cell that it is in, relative to the cell
/// whose least corner the point is, and its half of it.
struct TriangleAround {
  int column, row;
  bool is_acd;
};
constexpr TriangleAround kTrianglesAround[] = {{0, 0, false},  {0, 0, true},    {-1, 0, false},
                                               {-1, -1, true}, {-1, -1, false}, {0, -1, true}};

/// The places of a triangle around its own corners.
constexpr int kPlacesOfAbc[] = {0, 2, 4}, kPlacesOfAcd[] = {1, 3, 5};

Point3 normal_of(const Point3& a, const Point3& b, const Point3& c) {
  const std::array triangle{a, b, c};
  const Point3 normal = newell_normal(triangle);
  return normal == Point3(0.0) ? normal : unit(normal);
}

}  // namespace

SurfaceNormals::SurfaceNormals(const SurfaceGrid& grid, double crease_degrees)
    : columns_(static_cast<std::size_t>(grid.x_points)),
      x_cells_(grid.x_points - 1),
      y_cells_(grid.y_points - 1),
      has_creases_(crease_degrees < kNoCrease),
      crease_(crease_degrees) {
  points_.reserve(grid.heights.size());
  for (const double z : grid.heights) {
    const auto i = static_cast<int>(points_.size() % columns_);
    const auto j = static_cast<int>(points_.size() / columns_);
    points_.emplace_back(grid.x(i), grid.y(j), std::isnan(z) ? 0.0 : z);
  }
  const std::size_t cells = static_cast<std::size_t>(x_cells_) * static_cast<std::size_t>(y_cells_);
  normals_.reserve(2 * cells);
  has_cell_.reserve(cells);
  for (int j = 0; j < y_cells_; ++j) {
    for (int i = 0; i < x_cells_; ++i) {
      has_cell_.push_back(grid.has_cell(i, j) ? 1 : 0);
      for (int half = 0; half < 2; ++half) {
        const auto [p, q, r] = corners(normals_.size());
        normals_.push_back(has_cell_.back() != 0 ? normal_of(points_[p], points_[q], points_[r])
                                                 : Point3(0.0));
      }
    }
  }
}

std::array<Point3, 3> SurfaceNormals::of(int column, int row, Half half) const {
  const auto& places = half == Half::abc ? kPlacesOfAbc : kPlacesOfAcd;
  const int row_of_second = half == Half::abc ? row : row + 1;
  const int column_of_third = half == Half::abc ? column + 1 : column;
  return {mean_at(column, row, places[0]), mean_at(column + 1, row_of_second, places[1]),
          mean_at(column_of_third, row + 1, places[2])};
}

bool SurfaceNormals::find(int x, int y, int place, std::size_t& triangle) const {
  const auto& [column, row, is_acd] = kTrianglesAround[place];
  const int i = x + column, j = y + row;
  if (i < 0 || j < 0 || i >= x_cells_ || j >= y_cells_) return false;
  const std::size_t cell = static_cast<std::size_t>(j) * static_cast<std::size_t>(x_cells_) +
                           static_cast<std::size_t>(i);
  triangle = 2 * cell + (is_acd ? 1 : 0);
  return has_cell_[cell] != 0;
}

/// The numbers of its points, counterclockwise from the cell's least corner.
std::array<std::size_t, 3> SurfaceNormals::corners(std::size_t triangle) const {
  const std::size_t cell = triangle / 2, cells_across = columns_ - 1;
  const std::size_t a = cell / cells_across * columns_ + cell % cells_across;
  const std::size_t b = a + 1, c = a + columns_ + 1, d = a + columns_;
  if (triangle % 2 == 0) return {a, b, c};
  return {a, c, d};
}

/// Its normal times its angle at that corner.
Point3 SurfaceNormals::weighted(std::size_t triangle, std::size_t at) const {
  const auto points = corners(triangle);
  std::size_t k = 0;
  while (points[k] != at) ++k;
  const Point3& corner = points_[at];
  const Point3 after = points_[points[(k + 1) % 3]] - corner;
  const Point3 before = points_[points[(k + 2) % 3]] - corner;
  return angle_between(before, after) * normals_[triangle];
}

/// True if a crease runs between neighbours, of which one runs up their side and the other down.
bool SurfaceNormals::is_creased(std::size_t a, std::size_t b) const {
  return has_creases_ && crease_.exceeded(normals_[a], -normals_[b]);
}

/// Around the point, as far as no crease stops it in either direction; without a crease angle,
/// around all of it, across holes too. With one, a flat part beside creases keeps its own normal.
Point3 SurfaceNormals::mean_at(int x, int y, int place) const {
  const std::size_t at = point(x, y);
  std::size_t own = 0;
  find(x, y, place, own);
  Point3 sum = weighted(own, at);
  int left = kAround - 1;  // triangles that are not looked at yet
  for (const int step : {1, kAround - 1}) {
    std::size_t before = own, next = 0;
    for (int k = place; left > 0; before = next) {
      k = (k + step) % kAround;
      const bool exists = find(x, y, k, next);
      if (has_creases_ && (!exists || is_creased(before, next))) break;
      if (exists) sum += weighted(next, at);
      --left;
    }
  }
  const bool is_own = has_creases_ && angle_between(sum, normals_[own]) <= CreaseAngle::kCoplanar;
  return is_own ? Point3(0.0) : sum;
}

}  // namespace displayfile
