#include "clip/planarity.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "clip/back_face.h"

namespace displayfile {

bool is_flat(std::span<const Point3> world) {
  if (world.size() <= 3) return true;
  Point3 low = world.front(), high = world.front(), mean(0.0);
  for (const Point3& p : world) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const Point3 extent = high - low;
  const double size = std::max({extent.x, extent.y, extent.z});
  if (size == 0.0) return true;
  for (const Point3& p : world) mean += (p - low) / size;
  mean /= static_cast<double>(world.size());
  Point3 normal = newell_normal(world) / size / size;
  const double length = std::sqrt(glm::dot(normal, normal));
  if (length == 0.0) return true;
  normal /= length;
  return std::ranges::all_of(world, [&](const Point3& p) {
    return std::abs(glm::dot((p - low) / size - mean, normal)) <= kFlatnessTolerance;
  });
}

namespace {

double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

/// Counterclockwise when seen against the normal: the axis of its largest component dropped.
Point2 flatten(const Point3& p, const Point3& normal) {
  const Point3 size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
  if (size.z >= size.x && size.z >= size.y)
    return normal.z > 0 ? Point2(p.x, p.y) : Point2(p.y, p.x);
  if (size.x >= size.y) return normal.x > 0 ? Point2(p.y, p.z) : Point2(p.z, p.y);
  return normal.y > 0 ? Point2(p.z, p.x) : Point2(p.x, p.z);
}

bool within(const Point2& p, const Point2& a, const Point2& b, const Point2& c) {
  return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
}

}  // namespace

std::span<const Triangulation::Triangle> Triangulation::triangulate(std::span<const Point3> world) {
  const Point3 normal = newell_normal(world);
  triangles_.clear();
  flattened_.clear();
  remaining_.clear();
  for (std::uint32_t i = 0; i < world.size(); ++i) {
    flattened_.push_back(flatten(world[i], normal));
    remaining_.push_back(i);
  }
  const auto is_ear = [&](std::size_t k) {
    const std::size_t m = remaining_.size();
    const std::uint32_t a = remaining_[(k + m - 1) % m], b = remaining_[k],
                        c = remaining_[(k + 1) % m];
    if (turn(flattened_[a], flattened_[b], flattened_[c]) <= 0.0) return false;
    return std::ranges::none_of(remaining_, [&](std::uint32_t v) {
      return v != a && v != b && v != c &&
             within(flattened_[v], flattened_[a], flattened_[b], flattened_[c]);
    });
  };
  // A side of the polygon joins neighbours in its order; anything else is a diagonal.
  const auto is_side = [&](std::uint32_t from, std::uint32_t to) {
    return static_cast<std::uint8_t>((from + 1) % world.size() == to);
  };
  while (remaining_.size() >= 3) {
    std::size_t k = 1;  // where no ear is left, the polygon crosses itself: fan
    for (std::size_t i = 0; i < remaining_.size(); ++i) {
      if (is_ear((i + 1) % remaining_.size())) {
        k = (i + 1) % remaining_.size();
        break;
      }
    }
    const std::size_t m = remaining_.size();
    const std::uint32_t a = remaining_[(k + m - 1) % m], b = remaining_[k],
                        c = remaining_[(k + 1) % m];
    triangles_.push_back({{a, b, c}, {is_side(c, a), is_side(a, b), is_side(b, c)}});
    remaining_.erase(remaining_.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return triangles_;
}

}  // namespace displayfile
