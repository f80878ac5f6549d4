// The bounds are derived in hidden/touching/touching_planes.md.

#include "hidden/exact/entered_plane.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "hidden/exact/predicate_counts.h"
#include "hidden/exact/rounding.h"

namespace displayfile {

namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

double largest(const Point3& p) {
  return std::max(std::max(std::abs(p.x), std::abs(p.y)), std::abs(p.z));
}

double largest(const std::array<DoubleDouble, 3>& p) {
  return std::max({std::abs(p[0].high), std::abs(p[1].high), std::abs(p[2].high)});
}

std::array<DoubleDouble, 3> minus(const std::array<DoubleDouble, 3>& a,
                                  const std::array<DoubleDouble, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

std::array<DoubleDouble, 3> cross(const std::array<DoubleDouble, 3>& a,
                                  const std::array<DoubleDouble, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

DoubleDouble dot(const std::array<DoubleDouble, 3>& a, const std::array<DoubleDouble, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Vectors times a power of two. Each coordinate is rounded once at most, as by ldexp, which takes
/// many times as long.
class Scaling {
 public:
  /// Scales by 1 / 2^exponent, where that is the exponent of a double other than 0.
  explicit Scaling(int exponent)
      : factor_(std::ldexp(1.0, std::min(-exponent, kMost))),
        rest_(-exponent > kMost ? std::ldexp(1.0, -exponent - kMost) : 1.0) {}

  double operator()(double x) const { return x * factor_ * rest_; }
  Point3 operator()(const Point3& v) const { return v * factor_ * rest_; }

 private:
  static constexpr int kMost = 1023;
  double factor_, rest_;
};

/// The length, with an error below 2^-49 of it; squares neither overflow nor underflow.
double length(const Point3& v) {
  int exponent = 0;
  std::frexp(largest(v), &exponent);
  const Point3 scaled(std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent),
                      std::ldexp(v.z, -exponent));
  return std::ldexp(glm::length(scaled), exponent);
}

/// Bounds of a reach multiplied by the length of a modelling matrix's longest column.
Reach bounds_of_reach(double entered, double column) {
  if (!(column >= 1e-200 && column <= 1e200)) return {0.0, kNoBound};
  const double reach = entered * column;
  const Reach bounds{std::max(0.0, reach * (1.0 - 0x1p-46) - kTiny),
                     reach * (1.0 + 0x1p-46) + kTiny};
  assert(bounds.low <= bounds.high);
  return bounds;
}

bool is_zero(const ExactVector& v) { return v.x.sign() == 0 && v.y.sign() == 0 && v.z.sign() == 0; }

bool are_in_line(const Point3& p, const Point3& q, const Point3& r) {
  const Point3 u = q - p, v = r - p;
  // By Plane's bound (predicates.md, section 4).
  const auto is_not_zero = [](double ad, double bc) {
    return std::abs(ad - bc) > 4.0 * kUnit * kInflate * (std::abs(ad) + std::abs(bc)) + kTiny;
  };
  if (is_not_zero(u.y * v.z, u.z * v.y) || is_not_zero(u.z * v.x, u.x * v.z) ||
      is_not_zero(u.x * v.y, u.y * v.x)) {
    return false;
  }
  return is_zero(displayfile::cross(exact_difference(q, p), exact_difference(r, p)));
}

/// True if the determinant of the first three rows and columns is 0, exactly.
bool is_zero_determinant(const glm::dmat4& matrix) {
  const Point3 a(matrix[0]), b(matrix[1]), c(matrix[2]);
  const double value = glm::dot(a, glm::cross(b, c));
  const Point3 u = glm::abs(a), v = glm::abs(b), w = glm::abs(c);
  const double sum =
      u.x * (v.y * w.z + w.y * v.z) + u.y * (v.z * w.x + w.z * v.x) + u.z * (v.x * w.y + w.x * v.y);
  // Each of six products has at most five roundings.
  if (std::abs(value) > 6.0 * kUnit * sum + kTiny * (1.0 + u.x + u.y + u.z)) return false;
  const auto exact = [](const Point3& p) {
    return ExactVector{ExactNumber(p.x), ExactNumber(p.y), ExactNumber(p.z)};
  };
  return dot(exact(a), cross(exact(b), exact(c))).sign() == 0;
}

/// The index of the point with the greatest measure, the first of equal ones. The first point's
/// measure is 0, the smallest possible.
template <class Measure>
std::size_t index_of_greatest(std::span<const Point3> points, const Measure& measure) {
  std::size_t greatest = 0;
  double most = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double here = measure(points[i]);
    if (here > most) {
      most = here;
      greatest = i;
    }
  }
  return greatest;
}

}  // namespace

Modelling::Modelling(const glm::dmat4x3* matrix, double reach)
    : matrix_(matrix == nullptr ? glm::dmat4(1.0) : glm::dmat4(*matrix)),
      is_identity_(matrix_ == glm::dmat4(1.0)),
      is_singular_(false),
      entered_reach_(reach),
      reach_(bounds_of_reach(reach, 1.0)) {
  assert(reach >= 0.0 && std::isfinite(reach));
  if (is_identity_) return;
  reach_ = bounds_of_reach(reach, std::max({length(Point3(matrix_[0])), length(Point3(matrix_[1])),
                                            length(Point3(matrix_[2]))}));
  is_singular_ = is_zero_determinant(matrix_);
}

bool Modelling::is_of(const glm::dmat4x3* matrix) const {
  return matrix == nullptr ? is_identity_ : glm::dmat4(*matrix) == matrix_;
}

double Modelling::largest_sum(const Point3& p) const {
  const auto of_row = [&](int r) {
    return std::abs(matrix_[0][r] * p.x) + std::abs(matrix_[1][r] * p.y) +
           std::abs(matrix_[2][r] * p.z) + std::abs(matrix_[3][r]);
  };
  return std::max({of_row(0), of_row(1), of_row(2)});
}

std::array<DoubleDouble, 3> Modelling::apply_closely(const Point3& p) const {
  if (is_identity_) return {{{p.x, 0.0}, {p.y, 0.0}, {p.z, 0.0}}};
  const auto of_row = [&](int r) {
    return exact_product(matrix_[0][r], p.x) + exact_product(matrix_[1][r], p.y) +
           exact_product(matrix_[2][r], p.z) + DoubleDouble{matrix_[3][r], 0.0};
  };
  return {of_row(0), of_row(1), of_row(2)};
}

ExactVector Modelling::apply_exactly(const Point3& p) const {
  const ExactNumber x(p.x), y(p.y), z(p.z);
  if (is_identity_) return {x, y, z};
  const auto of_row = [&](int r) {
    return ExactNumber(matrix_[0][r]) * x + ExactNumber(matrix_[1][r]) * y +
           ExactNumber(matrix_[2][r]) * z + ExactNumber(matrix_[3][r]);
  };
  return {of_row(0), of_row(1), of_row(2)};
}

bool Modelling::puts_in_line(const Point3& p, const Point3& q, const Point3& r) const {
  const ExactVector first = apply_exactly(p);
  return is_zero(displayfile::cross(apply_exactly(q) - first, apply_exactly(r) - first));
}

DoubleDouble Modelling::longest_squared() const {
  DoubleDouble longest;
  for (int k = 0; k < 3; ++k) {
    const auto square = [&](int r) { return exact_product(matrix_[k][r], matrix_[k][r]); };
    const DoubleDouble squared = square(0) + square(1) + square(2);
    if ((squared - longest).high > 0.0) longest = squared;
  }
  return longest;
}

ExactNumber Modelling::exact_longest_squared() const {
  ExactNumber longest;
  for (int k = 0; k < 3; ++k) {
    const ExactVector column{ExactNumber(matrix_[k].x), ExactNumber(matrix_[k].y),
                             ExactNumber(matrix_[k].z)};
    const ExactNumber squared = displayfile::dot(column, column);
    if ((squared - longest).sign() > 0) longest = squared;
  }
  return longest;
}

std::optional<std::array<std::size_t, 3>> support_of_entered(std::span<const Point3> v) {
  if (v.size() < 3) return std::nullopt;
  const Point3& p = v[0];
  std::size_t q = 1, r = 2;
  if (v.size() > 3) {
    q = index_of_greatest(v, [&](const Point3& i) { return largest(i - p); });
    int exponent = 0;
    std::frexp(largest(v[q] - p), &exponent);
    const Scaling scaled(exponent);
    const Point3 to_q = scaled(v[q] - p);
    r = index_of_greatest(
        v, [&](const Point3& i) { return largest(glm::cross(to_q, scaled(i - p))); });
  }
  if (!are_in_line(p, v[q], v[r])) return std::array<std::size_t, 3>{0, q, r};
  for (r = 0; v.size() > 3 && r < v.size(); ++r) {
    if (!are_in_line(p, v[q], v[r])) return std::array<std::size_t, 3>{0, q, r};
  }
  return std::nullopt;
}

EnteredPlane::EnteredPlane(const Corners& corners, const Modelling& modelling)
    : corners_(corners),
      modelling_(&modelling),
      is_sound_(is_double_double_sound()),
      direction_error_(kNoBound) {
  assert(corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]);
  if (!is_sound_) return;
  constexpr double kSquare = kRounding * kRounding;
  first_ = modelling.apply_closely(corners[0]);
  const auto q = modelling.apply_closely(corners[1]), r = modelling.apply_closely(corners[2]);
  magnitude_ = std::max({largest(first_), largest(q), largest(r), modelling.magnitude(corners[0]),
                         modelling.magnitude(corners[1]), modelling.magnitude(corners[2])});
  const auto u = minus(q, first_), v = minus(r, first_);
  cross_ = cross(u, v);
  const double a = largest(u), b = largest(v);
  // The error of a coordinate of u and v; under the identity they are exact.
  const double error = modelling.is_identity() ? 0.0 : 35.0 * kSquare * magnitude_ + kTiny;
  cross_error_ = (2.0 * error * (a + b + error) + 19.0 * kSquare * a * b) * (1.0 + 0x1p-40) + kTiny;
  find_normal(cross_error_);
}

/// Finds the rounded direction, and a bound on its error besides that rounding.
void EnteredPlane::find_normal(double error) {
  const double most = largest(cross_);
  if (!(most > 0.0 && most <= std::numeric_limits<double>::max())) return;
  int exponent = 0;
  std::frexp(most, &exponent);
  const Scaling scaling(exponent);
  const Point3 scaled = scaling(Point3(cross_[0].high, cross_[1].high, cross_[2].high));
  const double length = glm::length(scaled);
  const double off = 4.0 * scaling(error) / length;
  if (!(off <= 0.25)) return;
  normal_ = scaled / length;
  direction_error_ = off + kTiny;
}

/// Decides by the distance in doubles along the rounded normal. `d` is the difference of the point
/// and the first corner, with each coordinate rounded twice and a further error of length `error`.
EnteredPlane::Answer EnteredPlane::by_doubles(const Point3& d, double error,
                                              const Reach& reach) const {
  const double x = normal_.x * d.x, y = normal_.y * d.y, z = normal_.z * d.z;
  const double value = std::abs(x + y + z);
  const double bound = 12.0 * kRounding * (std::abs(x) + std::abs(y) + std::abs(z)) +
                       direction_error_ * (std::abs(d.x) + std::abs(d.y) + std::abs(d.z)) + error +
                       kTiny;
  if (value - bound > reach.high) return Answer::no;
  if (value + bound <= reach.low) return Answer::yes;
  return Answer::undecided;
}

/// Decides by s^2 <= reach^2 n^2 with s = n . d, in sums of two doubles.
EnteredPlane::Answer EnteredPlane::closely(const std::array<DoubleDouble, 3>& v, double magnitude,
                                           const Modelling& of_point) const {
  constexpr double kSquare = kRounding * kRounding;
  const bool is_exact = modelling_->is_identity() && of_point.is_identity();
  const auto d = minus(v, first_);
  const double d_most = largest(d), n_most = largest(cross_);
  const double d_error = is_exact ? 0.0 : 18.0 * kSquare * (magnitude + magnitude_) + kTiny;
  const DoubleDouble s = dot(cross_, d);
  const double s_error = 3.0 * (cross_error_ * d_most + n_most * d_error + cross_error_ * d_error) +
                         36.0 * kSquare * n_most * d_most + kTiny;
  const DoubleDouble squared = dot(cross_, cross_);
  const double squared_error =
      3.0 * cross_error_ * (2.0 * n_most + cross_error_) + 36.0 * kSquare * n_most * n_most + kTiny;
  const DoubleDouble own = modelling_->longest_squared(), other = of_point.longest_squared();
  const DoubleDouble longest = (other - own).high > 0.0 ? other : own;
  const double entered = of_point.entered_reach();
  const DoubleDouble reach = exact_product(entered, entered) * longest;
  const auto is_ordinary = [](double x) { return x > 0x1p-900 && x < 0x1p900; };
  if (!is_ordinary(entered * entered) || !is_ordinary(longest.high) || !is_ordinary(reach.high)) {
    return Answer::undecided;
  }
  const DoubleDouble left = s * s, right = reach * squared;
  const double bound = 2.0 * std::abs(s.high) * s_error + s_error * s_error +
                       10.0 * kSquare * left.high + reach.high * squared_error +
                       55.0 * kSquare * right.high + kTiny;
  const double difference = (left - right).high;
  if (!std::isfinite(difference) || !(std::abs(difference) > bound * (1.0 + 0x1p-40))) {
    return Answer::undecided;
  }
  return difference > 0.0 ? Answer::no : Answer::yes;
}

bool EnteredPlane::exactly(const Point3& entered, const Modelling& of_point) const {
  count_exact(Predicate::within_reach);
  const ExactVector p = modelling_->apply_exactly(corners_[0]);
  const ExactVector n = displayfile::cross(modelling_->apply_exactly(corners_[1]) - p,
                                           modelling_->apply_exactly(corners_[2]) - p);
  const ExactNumber s = displayfile::dot(n, of_point.apply_exactly(entered) - p);
  const ExactNumber own = modelling_->exact_longest_squared();
  const ExactNumber other = of_point.exact_longest_squared();
  const ExactNumber reach(of_point.entered_reach());
  const ExactNumber right =
      reach * reach * ((other - own).sign() > 0 ? other : own) * displayfile::dot(n, n);
  return (right - s * s).sign() >= 0;
}

bool EnteredPlane::reaches(const Point3& entered, const Modelling& of_point) const {
  if (!is_sound_) return exactly(entered, of_point);
  constexpr double kSquare = kRounding * kRounding;
  const Reach& own = modelling_->reach();
  const Reach& other = of_point.reach();
  const Reach reach{std::max(own.low, other.low), std::max(own.high, other.high)};

  const Point3 v = of_point.apply(entered);
  const double magnitude = std::max(largest(v), of_point.magnitude(entered));
  const double close_error = 40.0 * kSquare * (magnitude + magnitude_) + kTiny;
  const Point3 d((v.x - first_[0].high) - first_[0].low, (v.y - first_[1].high) - first_[1].low,
                 (v.z - first_[2].high) - first_[2].low);
  const double v_error = of_point.is_identity() ? 0.0 : 5.3 * kRounding * magnitude;
  Answer answer = by_doubles(d, v_error + close_error, reach);
  if (answer != Answer::undecided) return answer == Answer::yes;

  const auto close = of_point.apply_closely(entered);
  if (!of_point.is_identity()) {
    const auto from_first = [&](std::size_t k) {
      return (close[k].high - first_[k].high) + (close[k].low - first_[k].low);
    };
    answer = by_doubles({from_first(0), from_first(1), from_first(2)}, close_error, reach);
    if (answer != Answer::undecided) return answer == Answer::yes;
  }
  answer = closely(close, magnitude, of_point);
  if (answer != Answer::undecided) return answer == Answer::yes;
  return exactly(entered, of_point);
}

int EnteredPlane::exact_side(const Point3& entered, const Modelling& of_point) const {
  count_exact(Predicate::within_reach);
  const ExactVector p = modelling_->apply_exactly(corners_[0]);
  const ExactVector n = displayfile::cross(modelling_->apply_exactly(corners_[1]) - p,
                                           modelling_->apply_exactly(corners_[2]) - p);
  return displayfile::dot(n, of_point.apply_exactly(entered) - p).sign();
}

/// Uses the bounds of `reaches`.
int EnteredPlane::side(const Point3& entered, const Modelling& of_point) const {
  if (!is_sound_) return exact_side(entered, of_point);
  constexpr double kSquare = kRounding * kRounding;
  const auto v = of_point.apply_closely(entered);
  const double magnitude = std::max(largest(v), of_point.magnitude(entered));
  const auto d = minus(v, first_);
  const bool is_exact = modelling_->is_identity() && of_point.is_identity();
  const double d_most = largest(d), n_most = largest(cross_);
  const double d_error = is_exact ? 0.0 : 18.0 * kSquare * (magnitude + magnitude_) + kTiny;
  const DoubleDouble s = dot(cross_, d);
  const double s_error = 3.0 * (cross_error_ * d_most + n_most * d_error + cross_error_ * d_error) +
                         36.0 * kSquare * n_most * d_most + kTiny;
  if (std::isfinite(s.high) && std::abs(s.high) > s_error * (1.0 + 0x1p-40)) {
    return s.high > 0.0 ? 1 : -1;
  }
  return exact_side(entered, of_point);
}

namespace {

/// Decides in doubles; false if undecided. The matrix stretches a distance by less than twice its
/// longest column. The error of the triple product is below eight roundings of the sum of its
/// terms' magnitudes (Shewchuk's orient3d), and so is that of each coordinate of the normal.
bool is_certainly_flat(const PointRow& points, const std::array<std::size_t, 3>& support,
                       double largest) {
  constexpr double kRoundings = 0x1p-50;
  const Point3 first = points[support[0]];
  const Point3 a = points[support[1]] - first, b = points[support[2]] - first;
  const auto products = [&](int j, int k) { return std::array{a[j] * b[k], a[k] * b[j]}; };
  const std::array x = products(1, 2), y = products(2, 0), z = products(0, 1);
  const Point3 normal(x[0] - x[1], y[0] - y[1], z[0] - z[1]);
  const Point3 sizes(std::abs(x[0]) + std::abs(x[1]), std::abs(y[0]) + std::abs(y[1]),
                     std::abs(z[0]) + std::abs(z[1]));
  const auto greatest = [](const Point3& v) { return std::max({v.x, v.y, v.z}); };
  const double length = greatest(glm::abs(normal)) - kRoundings * greatest(sizes);
  const double most = 0.5 * kFlatAsEntered * largest * length;
  return std::ranges::all_of(points, [&](const Point3& p) {
    const Point3 v = p - first;
    return std::abs(glm::dot(normal, v)) + kRoundings * glm::dot(sizes, glm::abs(v)) <= most;
  });
}

}  // namespace

bool is_bent(const EnteredPolygon& polygon, double largest) {
  const PointRow& points = polygon.points;
  if (points.size() <= 3) return false;
  const auto support = support_of_entered({points.data(), points.size()});
  if (!support || is_certainly_flat(points, *support, largest)) return false;
  const std::array corners{points[(*support)[0]], points[(*support)[1]], points[(*support)[2]]};
  const Modelling modelling(polygon.modelling, kFlatAsEntered * largest);
  if (modelling.puts_in_line(corners[0], corners[1], corners[2])) return false;
  const EnteredPlane plane(corners, modelling);
  return std::ranges::any_of(points, [&](const Point3& p) { return !plane.reaches(p, modelling); });
}

}  // namespace displayfile
