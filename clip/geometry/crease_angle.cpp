#include "clip/geometry/crease_angle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "clip/base/error.h"

namespace displayfile {

namespace {

/// The arctangent's series, t - t^3 / 3 + t^5 / 5 - ...; the relative truncation error is below
/// 2^-56 for 0 <= t <= tan(pi / 16).
double arctangent_of_small(double t) {
  const double square = t * t;
  double sum = 0.0;
  for (int power = 23; power > 0; power -= 2) sum = 1.0 / power - square * sum;
  return t * sum;
}

}  // namespace

double angle_between(const Point3& a, const Point3& b) {
  double sine = glm::length(glm::cross(a, b)), cosine = glm::dot(a, b);  // both times the lengths
  const double size = std::max(sine, std::abs(cosine));
  if (!(size > 0.0)) return 0.0;
  sine /= size;
  cosine /= size;
  const bool obtuse = cosine < 0.0;
  double tangent = sine / (std::abs(cosine) + std::sqrt(sine * sine + cosine * cosine));
  for (int halved = 0; halved < 2; ++halved) tangent /= 1.0 + std::sqrt(1.0 + tangent * tangent);
  const double acute = 8.0 * arctangent_of_small(tangent);  // the angle was halved three times
  return obtuse ? std::numbers::pi - acute : acute;
}

namespace {

constexpr double kHalfTurn = std::numbers::pi;
/// Cosines that differ by more belong to different angles, in the same order.
constexpr double kNearlyEqual = 1e-12;

}  // namespace

void require_crease_angle(double degrees) {
  if (is_crease_angle(degrees)) return;
  throw Error(fmt::format("crease of {} degrees: expected 0 to 180", degrees));
}

CreaseAngle::CreaseAngle(double degrees)
    : least_(std::max(degrees * kHalfTurn / 180.0, kCoplanar)), cosine_(std::cos(least_)) {
  assert(is_crease_angle(degrees));
}

bool CreaseAngle::exceeded(const Point3& a, const Point3& b) const {
  const double beyond = glm::dot(a, b) + cosine_;
  if (std::abs(beyond) > kNearlyEqual) return beyond > 0.0;
  return exceeded(angle_between(a, b));
}

bool CreaseAngle::exceeded(double between) const { return kHalfTurn - between > least_; }

}  // namespace displayfile
