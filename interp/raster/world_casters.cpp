#include "interp/raster/world_casters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace displayfile {

namespace {

/// As a fraction of the scene's size: far less than visible details, and far more than the rounding
/// of viewing and of ray tests.
constexpr double kMargin = 0x1p-24;

bool is_caster(const RetainedScene& scene, std::uint32_t i) {
  return !scene[i].is_line() && scene.attributes(i).fill.kind == FillStyle::Kind::solid;
}

Bounds box_of(const PointRow& points) {
  Bounds box;
  for (const Point3& p : points) box.include(p);
  return box;
}

/// A box swept along an infinite ray, tested against the boxes of a tree: these are enlarged by the
/// size of the box, which becomes a point.
class MovedBox {
 public:
  MovedBox(const Bounds& box, const Point3& toward)
      : half_(0.5 * (box.high - box.low)), ray_(0.5 * (box.low + box.high), toward) {}

  SpaceTree::Lanes operator()(const SpaceBoxes& boxes) const {
    SpaceBoxes grown;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double half = half_[static_cast<int>(axis)];
      for (std::size_t k = 0; k < SpaceBoxes::kBoxes; ++k) {
        grown.low[axis][k] = boxes.low[axis][k] - half;
        grown.high[axis][k] = boxes.high[axis][k] + half;
      }
    }
    return ray_(grown);
  }

 private:
  Point3 half_;
  SpaceRay ray_;
};

/// A polygon projected along the light: across, up, and its extent toward the light.
class SeenByLight {
 public:
  struct Axes {
    Point3 across, up, toward;
    explicit Axes(const Point3& unit_toward) : toward(unit_toward) {
      const Point3 size = glm::abs(toward);
      const Point3 least = size.x <= size.y && size.x <= size.z ? Point3(1, 0, 0)
                           : size.y <= size.z                   ? Point3(0, 1, 0)
                                                                : Point3(0, 0, 1);
      across = glm::normalize(glm::cross(toward, least));
      up = glm::cross(toward, across);
    }
  };

  SeenByLight(const PointRow& points, const Axes& axes) : sides_(points.size()) {
    if (sides_ > kMost) return;
    for (std::size_t i = 0; i < sides_; ++i) {
      at_[i] = {glm::dot(points[i], axes.across), glm::dot(points[i], axes.up)};
      const double toward = glm::dot(points[i], axes.toward);
      nearest_ = std::max(nearest_, toward);
      farthest_ = std::min(farthest_, toward);
    }
  }

  /// True if it certainly hides no light from any point of the other, which lies behind it if at
  /// all.
  bool misses(const SeenByLight& other, double margin) const {
    if (sides_ > kMost || other.sides_ > kMost) return false;
    return nearest_ < other.farthest_ - margin || is_apart_along_sides(other, margin) ||
           other.is_apart_along_sides(*this, margin);
  }

 private:
  static constexpr std::size_t kMost = 16;  // sides; for polygons of more, no further test is made

  /// True if the other lies beyond a line along one of the sides of this, which need not be convex.
  bool is_apart_along_sides(const SeenByLight& other, double margin) const {
    Point2 from = at_[sides_ - 1];
    for (std::size_t i = 0; i < sides_; ++i) {
      const Point2 side = at_[i] - from;
      from = at_[i];
      const Point2 axis(-side.y, side.x);
      const auto [low, high] = extent(axis);
      const auto [other_low, other_high] = other.extent(axis);
      const double gap = margin * (std::abs(side.x) + std::abs(side.y));
      if (gap > 0.0 && (other_low > high + gap || other_high < low - gap)) return true;
    }
    return false;
  }
  std::pair<double, double> extent(const Point2& axis) const {
    double low = glm::dot(at_[0], axis), high = low;
    for (std::size_t i = 1; i < sides_; ++i) {
      const double value = glm::dot(at_[i], axis);
      low = std::min(low, value);
      high = std::max(high, value);
    }
    return {low, high};
  }

  std::size_t sides_;
  std::array<Point2, kMost> at_;
  double nearest_ = -std::numeric_limits<double>::infinity();
  double farthest_ = std::numeric_limits<double>::infinity();
};

}  // namespace

WorldCasters::WorldCasters(const RetainedScene& scene, int threads) : scene_(&scene) {
  for (std::uint32_t i = 0; i < scene.size(); ++i) {
    if (!is_caster(scene, i)) continue;
    primitive_of_.push_back(i);
    for (const Point3& p : scene.points(i)) bounds_.include(p);
  }
  if (primitive_of_.empty()) return;
  const Point3 size = bounds_.high - bounds_.low;
  margin_ = kMargin * std::max({size.x, size.y, size.z});
  const auto larger_box_of = [&](SpaceTree::Item item) -> Bounds {
    const Bounds box = box_of(scene.points(primitive_of_[item]));
    return {box.low - margin_, box.high + margin_};
  };
  tree_.build(primitive_of_.size(), larger_box_of, threads);
  std::vector<Primitive> ordered;
  ordered.reserve(primitive_of_.size());
  for (const SpaceTree::Item item : tree_.order()) ordered.push_back(primitive_of_[item]);
  primitive_of_ = std::move(ordered);
}

std::optional<std::size_t> WorldCasters::find_casters_on(Primitive receiver, const Point3& toward,
                                                         std::span<Primitive> few) const {
  const PointRow points = scene_->points(receiver);
  Bounds box = box_of(points);
  box = {box.low - margin_, box.high + margin_};
  const SeenByLight::Axes axes(toward);
  const SeenByLight lit(points, axes);
  std::size_t found = 0;
  const bool too_many = tree_.any(MovedBox(box, toward), [&](SpaceTree::Position at) {
    const Primitive caster = primitive_of_[at];
    if (caster == receiver) return false;
    // Both may be off by the margin, along the axes of the light's picture by more.
    if (SeenByLight(scene_->points(caster), axes).misses(lit, 4.0 * margin_)) return false;
    if (found == few.size()) return true;
    few[found++] = caster;
    return false;
  });
  if (too_many) return std::nullopt;
  return found;
}

}  // namespace displayfile
