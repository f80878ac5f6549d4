#include "interp/truth/whole_points.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace displayfile {

WholePoint whole(const Point3& p) {
  const std::array coordinates{p.x, p.y, p.z};
  const int places = common_places(coordinates);
  return {scaled(p.x, places), scaled(p.y, places), scaled(p.z, places), places};
}

WholePoint with_places(WholePoint point, int places) {
  if (places <= point.places) return point;
  const std::size_t more = bits(places - point.places);
  point.x <<= more;
  point.y <<= more;
  point.z <<= more;
  point.places = places;
  return point;
}

WholePoint difference(const WholePoint& a, const WholePoint& b) {
  const int places = std::max(a.places, b.places);
  const WholePoint from = with_places(b, places);
  WholePoint to = with_places(a, places);
  to.x -= from.x;
  to.y -= from.y;
  to.z -= from.z;
  return to;
}

WholePoint cross(const WholePoint& a, const WholePoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x, a.places + b.places};
}

Integer dot(const WholePoint& a, const WholePoint& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

bool is_zero(const WholePoint& d) { return d.x == 0 && d.y == 0 && d.z == 0; }

WholeMatrix::WholeMatrix(const glm::dmat4x3& m) : places_(common_places({&m[0][0], 12})) {
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      columns_[column][row] = scaled(m[static_cast<int>(column)][static_cast<int>(row)], places_);
    }
  }
  for (std::size_t column = 0; column < 3; ++column) {
    const auto& [x, y, z] = columns_[column];
    const Integer squared = x * x + y * y + z * z;
    if (squared > longest_squared_) longest_squared_ = squared;
  }
}

WholePoint WholeMatrix::apply(const Point3& point) const {
  const WholePoint p = whole(point);
  const auto along = [&](std::size_t row) -> Integer {
    const Integer moved = columns_[3][row] << bits(p.places);
    return columns_[0][row] * p.x + columns_[1][row] * p.y + columns_[2][row] * p.z + moved;
  };
  return {along(0), along(1), along(2), p.places + places_};
}

}  // namespace displayfile
