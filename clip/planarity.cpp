#include "clip/planarity.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "clip/back_face.h"
#include "clip/corners.h"

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
  const auto sides = static_cast<std::uint32_t>(world.size());
  triangles_.clear();
  flattened_.clear();
  ring_.resize(sides);
  for (std::uint32_t i = 0; i < sides; ++i) {
    flattened_.push_back(flatten(world[i], normal));
    ring_[i] = {previous_corner(i, sides), next_corner(i, sides)};
  }
  const auto is_ear = [&](std::uint32_t b) {
    const auto [a, c] = ring_[b];
    const Point2 &p = flattened_[a], &q = flattened_[b], &r = flattened_[c];
    if (turn(p, q, r) <= 0.0) return false;
    for (std::uint32_t v = ring_[c].next; v != a; v = ring_[v].next) {
      const Point2& other = flattened_[v];  // the polygon may pass through a vertex again
      if (other != p && other != q && other != r && within(other, p, q, r)) return false;
    }
    return true;
  };
  // A side of the polygon joins neighbours in its order; anything else is a diagonal.
  const auto is_side = [&](std::uint32_t from, std::uint32_t to) {
    return static_cast<std::uint8_t>(next_corner(from, sides) == to);
  };
  const auto cut_off = [&](std::uint32_t b) {
    const auto [a, c] = ring_[b];
    triangles_.push_back({{a, b, c}, {is_side(c, a), is_side(a, b), is_side(b, c)}});
    ring_[a].next = c;
    ring_[c].previous = a;
  };
  std::uint32_t vertex = 1, tried = 0;
  for (std::uint32_t left = sides; left >= 3;) {
    // Once round without an ear: the polygon crosses itself. Fan what is left.
    if (tried < left && !is_ear(vertex)) {
      ++tried;
      vertex = ring_[vertex].next;
      continue;
    }
    const std::uint32_t next = ring_[vertex].next;
    cut_off(vertex);
    if (tried < left--) {
      tried = 0;
      vertex = ring_[next].next;  // not the neighbour: that would cut slivers round one vertex
    } else {
      tried = left;
      vertex = next;
    }
  }
  return triangles_;
}

}  // namespace displayfile
