#include "clip/view/transformation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <numbers>

#include "clip/geometry/unit.h"
#include "clip/system/fused_product.h"

namespace displayfile {

namespace {

/// A number of twice a double's digits: the sum of the two, the second within the first's rounding.
struct TwoDoubles {
  double high, low;
};

TwoDoubles product(const TwoDoubles& a, const TwoDoubles& b) {
  const double high = a.high * b.high;
  return {high, fused_product(a.high, b.high, -high) + (a.high * b.low + a.low * b.high)};
}

TwoDoubles quotient(const TwoDoubles& a, double b) {
  const double high = a.high / b;
  return {high, (fused_product(-high, b, a.high) + a.low) / b};
}

/// 1 - a, for |a| < 1/2.
TwoDoubles one_minus(const TwoDoubles& a) {
  const double high = 1.0 - a.high;
  return {high, ((1.0 - high) - a.high) - a.low};
}

/// The sum of 1 - x^2 / ((p+1)(p+2)) (1 - x^2 / ((p+3)(p+4)) (...)): the cosine of x for power p =
/// 0, and for p = 1 its sine divided by x. The relative truncation error is below 2^-106 for |x| <=
/// pi / 4.
TwoDoubles series(double x, int power) {
  const TwoDoubles square = product({x, 0.0}, {x, 0.0});
  TwoDoubles sum{1.0, 0.0};
  for (int n = power + 28; n > power; n -= 2) {
    sum = one_minus(quotient(product(square, sum), n * (n - 1.0)));
  }
  return sum;
}

// The C library's own sine and cosine differ from one library to the next, by a unit in the last
// place. These are rounded once from twice a double's digits, by operations that are the same
// everywhere (Dekker, "A floating-point technique for extending the available precision",
// Numerische Mathematik 18, 1971). For |x| <= pi / 4.
double sine(double x) {
  const TwoDoubles result = product({x, 0.0}, series(x, 1));
  return result.high + result.low;
}

double cosine(double x) {
  const TwoDoubles result = series(x, 0);
  return result.high + result.low;
}

}  // namespace

SineCosine sine_cosine_of_degrees(double degrees) {
  const double turn = std::remainder(degrees, 360.0);  // exact, in [-180, 180]
  const double quarter = std::round(turn / 90.0);
  const double rest = (turn - quarter * 90.0) * (std::numbers::pi / 180.0);
  const double s = rest == 0.0 ? 0.0 : sine(rest);
  const double c = rest == 0.0 ? 1.0 : cosine(rest);
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
  called_ = glm::dmat4(1.0);
  compose();
}

void ModellingTransformation::save() {
  saved_.push_back({without_place(), called_});
  called_ = glm::dmat4(1.0);
}

void ModellingTransformation::restore() {
  assert(!saved_.empty());
  called_ = saved_.back().called;
  saved_.pop_back();
  compose();
}

void ModellingTransformation::then(const glm::dmat4& step) {
  called_ = step * called_;
  compose();
}

glm::dmat4 ModellingTransformation::without_place() const {
  return saved_.empty() ? called_ : saved_.back().matrix * called_;
}

void ModellingTransformation::place(const Point3& move) {
  place_ = move;
  compose();
}

void ModellingTransformation::compose() {
  matrix_ = without_place();
  if (place_ != Point3(0.0)) matrix_[3] += HomogeneousPoint(place_, 0.0);
  affine_ = glm::dmat4x3(matrix_);
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

bool ModellingTransformation::mirrors() const {
  if (identity_) return false;
  glm::dmat3 axes(matrix_);
  for (int column = 0; column < 3; ++column) {
    if (axes[column] == Point3(0.0)) return false;
    axes[column] = unit(axes[column]);
  }
  return glm::dot(glm::cross(axes[0], axes[1]), axes[2]) < 0.0;
}

Point3 ModellingTransformation::apply_to_normal(const Point3& n) const {
  if (identity_) return n;
  double largest = 0.0;  // dividing by it keeps products from overflowing
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
  if (t.centre == Point2(0.0, 0.0)) return;
  tx_ += t.centre.x - (xx_ * t.centre.x + xy_ * t.centre.y);
  ty_ += t.centre.y - (yx_ * t.centre.x + yy_ * t.centre.y);
}

}  // namespace displayfile
