#include "clip/crease_angle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "clip/angle.h"
#include "clip/base/error.h"

namespace displayfile {

namespace {

constexpr double kHalfTurn = std::numbers::pi;
/// Cosines that differ by more are those of different angles, in the same order.
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
