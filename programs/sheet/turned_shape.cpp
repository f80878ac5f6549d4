#include "programs/sheet/turned_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "displayfile/text/program_line.h"

namespace displayfile {

namespace {

constexpr double kRounding = 1e-9;  // of coordinates, in parts of the largest

/// The shape that a routine turns about the line along z through a point.
struct Turned {
  Point3 base{0.0};
  std::vector<Point2> profile;
  int facets = 0;
  double profile_radius = 0.0;  ///< where it is round itself, with as many facets
  bool is_sphere = false;
};

std::vector<Point2> circle(double middle, double radius, double first, double last) {
  constexpr int kSides = 180;
  std::vector<Point2> points;
  for (int k = 0; k <= kSides; ++k) {
    const double angle = first + (last - first) * k / kSides;
    points.emplace_back(middle + radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

/// Arguments are read as the routines read them; they are right.
std::optional<Turned> turned_by(ProgramLine& line) {
  constexpr double kPi = std::numbers::pi;
  Turned turned;
  const std::string_view routine = line.name();
  if (routine == "turn-3") {
    turned.facets = line.take<int>();
    for (const Point2& p : line.take_points<Point2>()) turned.profile.push_back(p);
  } else if (routine == "cylinder-3" || routine == "cone-3") {
    turned.base = line.take<Point3>();
    const auto radius = line.take<double>(), height = line.take<double>();
    turned.facets = line.take<int>();
    const bool is_cone = routine == "cone-3";
    const double top = !is_cone ? radius : line.arguments() > 6 ? line.take<double>() : 0.0;
    turned.profile = {{0.0, 0.0}, {radius, 0.0}, {top, height}, {0.0, height}};
  } else if (routine == "sphere-3") {
    turned.base = line.take<Point3>();
    turned.profile_radius = line.take<double>();
    turned.profile = circle(0.0, turned.profile_radius, -kPi / 2.0, kPi / 2.0);
    turned.facets = line.take<int>();
    turned.is_sphere = true;
  } else if (routine == "torus-3") {
    turned.base = line.take<Point3>();
    const auto ring = line.take<double>();
    turned.profile_radius = line.take<double>();
    turned.profile = circle(ring, turned.profile_radius, 0.0, 2.0 * kPi);
    turned.facets = line.take<int>();
  } else {
    return std::nullopt;
  }
  return turned;
}

double distance_to_side(const Point2& p, const Point2& a, const Point2& b) {
  const Point2 side = b - a;
  const double length = glm::dot(side, side);
  const double t = length > 0.0 ? std::clamp(glm::dot(p - a, side) / length, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + t * side);
}

/// The factors by which a transformation stretches across an axis along z and along it; nothing
/// where circles about the axis do not stay circles about one.
std::optional<Point2> stretch(const ModellingTransformation& modelling) {
  const Point3 x = modelling.apply_to_difference({1.0, 0.0, 0.0});
  const Point3 y = modelling.apply_to_difference({0.0, 1.0, 0.0});
  const Point3 z = modelling.apply_to_difference({0.0, 0.0, 1.0});
  const double across = glm::length(x), along = glm::length(z);
  constexpr double kRight = 1e-9;
  const bool is_round = std::abs(glm::length(y) - across) <= kRight * across &&
                        std::abs(glm::dot(x, y)) <= kRight * across * across &&
                        std::abs(glm::dot(x, z)) <= kRight * across * along &&
                        std::abs(glm::dot(y, z)) <= kRight * across * along;
  if (!is_round || !(across > 0.0) || !(along > 0.0)) return std::nullopt;
  return Point2(across, along);
}

}  // namespace

bool TurnedShape::is_on_surface(const Point2& p) const {
  const double tolerance = sagitta_ * p.x + bulge_ + kRounding * largest_;
  Point2 from = profile_.back();
  for (const Point2& to : profile_) {
    const bool is_end = from.y == to.y, is_axis = from.x == 0.0 && to.x == 0.0;
    if (!is_end && !is_axis && distance_to_side(p, from, to) <= tolerance) return true;
    from = to;
  }
  return false;
}

std::optional<CentreAxis> TurnedShape::axis_at(std::span<const Point3> points) const {
  double low = HUGE_VAL, high = -HUGE_VAL, radius = 0.0;
  int found = 0;
  for (const Point3& p : points) {
    const Point3 from_origin = p - origin_;
    const double place = glm::dot(from_origin, along_);
    const Point2 in_profile(glm::length(from_origin - place * along_), place);
    if (!is_on_surface(in_profile)) continue;
    ++found;
    low = std::min(low, place);
    high = std::max(high, place);
    radius = std::max(radius, in_profile.x);
  }
  if (found < 3) return std::nullopt;
  if (is_sphere_) return CentreAxis{origin_, origin_, -profile_.front().y};
  return CentreAxis{origin_ + low * along_, origin_ + high * along_, radius};
}

bool makes_turned_shape(std::string_view routine) {
  constexpr std::array kRoutines{"cylinder-3", "cone-3", "sphere-3", "torus-3", "turn-3"};
  return std::ranges::find(kRoutines, routine) != kRoutines.end();
}

std::optional<TurnedShape> turned_shape(std::string_view text,
                                        const ModellingTransformation& modelling) {
  ProgramLine line;
  line.split(text);
  if (line.empty()) return std::nullopt;
  const std::optional<Turned> turned = turned_by(line);
  if (!turned) return std::nullopt;
  const std::optional<Point2> stretched = stretch(modelling);
  if (!stretched ||
      (turned->is_sphere && std::abs(stretched->x - stretched->y) > kRounding * stretched->x)) {
    return std::nullopt;
  }
  TurnedShape shape;
  shape.origin_ = modelling.apply(turned->base);
  shape.along_ = glm::normalize(modelling.apply_to_difference({0.0, 0.0, 1.0}));
  shape.sagitta_ = 1.0 / std::cos(std::numbers::pi / turned->facets) - 1.0;
  shape.bulge_ = shape.sagitta_ * turned->profile_radius * std::max(stretched->x, stretched->y);
  shape.is_sphere_ = turned->is_sphere;
  shape.largest_ =
      std::max({std::abs(shape.origin_.x), std::abs(shape.origin_.y), std::abs(shape.origin_.z)});
  for (const Point2& p : turned->profile) {
    const Point2& placed = shape.profile_.emplace_back(*stretched * p);
    shape.largest_ = std::max({shape.largest_, placed.x, std::abs(placed.y)});
  }
  return shape;
}

}  // namespace displayfile
