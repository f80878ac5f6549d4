#include "clip/transformation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace displayfile {

SineCosine sine_cosine_of_degrees(double degrees) {
  const double turn = std::remainder(degrees, 360.0);  // exact, in [-180, 180]
  const double quarter = std::round(turn / 90.0);
  const double rest = (turn - quarter * 90.0) * (std::numbers::pi / 180.0);
  const double s = rest == 0.0 ? 0.0 : std::sin(rest);
  const double c = rest == 0.0 ? 1.0 : std::cos(rest);
  switch ((static_cast<int>(quarter) + 4) % 4) {
    case 0: return {s, c};
    case 1: return {c, -s};
    case 2: return {-s, -c};
    default: return {-c, s};
  }
}

namespace {

/// A turn in the plane of axes `from` and `to`, from the first toward the second.
glm::dmat4 rotation(int from, int to, double degrees) {
  const auto [sine, cosine] = sine_cosine_of_degrees(degrees);
  glm::dmat4 m(1.0);  // m[column][row]
  m[from][from] = cosine;
  m[from][to] = sine;
  m[to][from] = -sine;
  m[to][to] = cosine;
  return m;
}

}  // namespace

void ModellingTransformation::create() {
  matrix_ = glm::dmat4(1.0);
  identity_ = true;
}

void ModellingTransformation::then(const glm::dmat4& step) {
  matrix_ = step * matrix_;
  identity_ = matrix_ == glm::dmat4(1.0);
}

void ModellingTransformation::translate(const Point3& t) {
  glm::dmat4 m(1.0);
  m[3] = HomogeneousPoint(t, 1.0);
  then(m);
}

void ModellingTransformation::scale(const Point3& s) {
  glm::dmat4 m(1.0);
  m[0][0] = s.x;
  m[1][1] = s.y;
  m[2][2] = s.z;
  then(m);
}

void ModellingTransformation::rotate_x(double degrees) { then(rotation(1, 2, degrees)); }
void ModellingTransformation::rotate_y(double degrees) { then(rotation(2, 0, degrees)); }
void ModellingTransformation::rotate_z(double degrees) { then(rotation(0, 1, degrees)); }

Point3 ModellingTransformation::apply_to_normal(const Point3& n) const {
  if (identity_) return n;
  double largest = 0.0;  // scaled by it, no product overflows
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(matrix_[column][row]));
  }
  if (n == Point3(0.0) || !(largest > 0.0)) return Point3(0.0);
  const Point3 x = Point3(matrix_[0]) / largest, y = Point3(matrix_[1]) / largest,
               z = Point3(matrix_[2]) / largest, u = unit(n);
  return u.x * glm::cross(y, z) + u.y * glm::cross(z, x) + u.z * glm::cross(x, y);
}

ImageMatrix::ImageMatrix(const ImageTransformation& t)
    : tx_(t.translation.x), ty_(t.translation.y) {
  const auto [sine, cosine] = sine_cosine_of_degrees(t.rotation);
  xx_ = cosine * t.scale.x;
  xy_ = -sine * t.scale.y;
  yx_ = sine * t.scale.x;
  yy_ = cosine * t.scale.y;
}

}  // namespace displayfile
