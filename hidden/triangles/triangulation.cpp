#include "hidden/triangles/triangulation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "clip/geometry/back_face.h"
#include "clip/geometry/corners.h"
#include "hidden/triangles/ear_cutting.h"

namespace displayfile {

namespace {

/// Drops the axis of the normal's largest component. Orientation is as seen against the normal.
Point2 along_axis(const Point3& p, const Point3& normal) {
  const Point3 size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
  if (size.z >= size.x && size.z >= size.y)
    return normal.z > 0 ? Point2(p.x, p.y) : Point2(p.y, p.x);
  if (size.x >= size.y) return normal.x > 0 ? Point2(p.y, p.z) : Point2(p.z, p.y);
  return normal.y > 0 ? Point2(p.z, p.x) : Point2(p.x, p.z);
}

/// Newell's normal, or that of a large triangle where crossing sides leave next to nothing of it.
Point3 direction_of(std::span<const Point3> polygon) {
  const Point3 normal = newell_normal(polygon);
  Point3 farthest(0.0), widest(0.0);
  for (const Point3& p : polygon) {
    const Point3 way = p - polygon[0];
    if (glm::dot(way, way) > glm::dot(farthest, farthest)) farthest = way;
  }
  for (const Point3& p : polygon) {
    const Point3 of_triangle = glm::cross(farthest, p - polygon[0]);
    if (glm::dot(of_triangle, of_triangle) > glm::dot(widest, widest)) widest = of_triangle;
  }
  constexpr double kNextToNothing = 0x1p-40;
  return glm::length(normal) > kNextToNothing * glm::length(widest) ? normal : widest;
}

}  // namespace

void Triangulation::flatten(std::span<const Point3> polygon, const Point3& along) {
  flattened_.clear();
  for (const Point3& p : polygon) flattened_.push_back(along_axis(p, along));
}

void Triangulation::find_corners_of_one_loop() {
  corners_.clear();
  is_by_loops_ = false;
  is_bridged_ = is_swept_ = is_uncrossed_ = false;
  if (flattened_.size() <= kMostForEars) {
    ears_.cut(flattened_, std::numeric_limits<std::size_t>::max(), corners_);
    return;
  }
  is_swept_ = sweep_triangles(flattened_, corners_);
  if (!is_swept_) ears_.cut(flattened_, kLooksPerCorner * flattened_.size(), corners_);
}

/// Bridges within the polygon's inside disturb nothing. With others, and where a hole has the
/// direction of the outline, only the loops can be tiled.
void Triangulation::find_corners() {
  find_corners_of_one_loop();
  is_bridged_ = bridged_.find(flattened_);
  if (!is_bridged_) return;
  bridged_.turn(flattened_);
  if (tiles() && !bridged_.any_turned()) return;
  std::vector<CornerTriple> of_loops;
  if (!sweep_triangles(flattened_, of_loops, bridged_.next())) return;
  corners_ = std::move(of_loops);
  is_by_loops_ = true;
}

/// True if no triangle is reversed: together they then wind around each point as often as the
/// polygon does.
bool Triangulation::tiles() const {
  return std::ranges::none_of(corners_, [&](const CornerTriple& corners) {
    const Point2 &a = flattened_[corners[0]], &b = flattened_[corners[1]],
                 &c = flattened_[corners[2]];
    return (b.x - a.x) * (c.y - a.y) < (c.x - a.x) * (b.y - a.y);
  });
}

/// The triangles with marked sides: a polygon's side joins successive vertices, or those of a loop;
/// all others are diagonals.
std::span<const Triangulation::Triangle> Triangulation::with_sides() {
  const auto sides = static_cast<std::uint32_t>(flattened_.size());
  const auto next = bridged_.next();
  const auto is_side = [&](std::uint32_t from, std::uint32_t to) {
    return static_cast<std::uint8_t>((is_by_loops_ ? next[from] : next_corner(from, sides)) == to);
  };
  triangles_.clear();
  for (const auto& [a, b, c] : corners_) {
    triangles_.push_back({{a, b, c}, {is_side(c, a), is_side(a, b), is_side(b, c)}});
  }
  return triangles_;
}

std::span<const Triangulation::Triangle> Triangulation::triangulate(std::span<const Point3> polygon,
                                                                    SeenAlong along) {
  const Point3 normal = direction_of(polygon);
  if (along == SeenAlong::z_axis && normal.z != 0.0) {
    flatten(polygon, {0.0, 0.0, normal.z});
    find_corners();
    if (tiles()) return with_sides();
  }
  flatten(polygon, normal);
  find_corners();
  return with_sides();
}

bool Triangulation::crosses_itself() const {
  const std::size_t corners = flattened_.size();
  if (corners <= 3 || is_swept_ || is_by_loops_) return false;
  if (corners > UncrossedLoops::kMostCorners) return true;
  return is_bridged_ ? UncrossedLoops::crosses(flattened_, bridged_.next())
                     : UncrossedLoops::crosses(flattened_);
}

std::span<const Triangulation::Triangle> Triangulation::tile(std::span<const Point3> polygon,
                                                             SeenAlong along) {
  const auto triangles = triangulate(polygon, along);
  if (!crosses_itself() || !uncrossed_.find(flattened_)) return triangles;
  corners_.clear();
  is_uncrossed_ = sweep_triangles(uncrossed_.corners(), corners_, uncrossed_.next());
  return is_uncrossed_ ? uncrossed_triangles() : triangles;
}

std::span<const Triangulation::Triangle> Triangulation::uncrossed_triangles() {
  const auto next = uncrossed_.next(), vertex = uncrossed_.vertex();
  const auto is_side = [&](std::uint32_t from, std::uint32_t to) {
    return static_cast<std::uint8_t>(next[from] == to);
  };
  triangles_.clear();
  for (const auto& [a, b, c] : corners_) {
    triangles_.push_back(
        {{vertex[a], vertex[b], vertex[c]}, {is_side(c, a), is_side(a, b), is_side(b, c)}});
  }
  return triangles_;
}

std::span<const UncrossedLoops::Crossing> Triangulation::crossings() const {
  if (!is_uncrossed_) return {};
  return uncrossed_.crossings();
}

std::vector<Point3> Triangulation::with_crossings(std::span<const Point3> values) const {
  std::vector<Point3> all(values.begin(), values.end());
  const auto at = [&](std::uint32_t side, double share) {
    const Point3 &from = values[side],
                 &to = values[next_corner(side, static_cast<std::uint32_t>(values.size()))];
    return from + share * (to - from);
  };
  for (const auto& [side, share] : crossings()) {
    all.push_back(0.5 * at(side[0], share[0]) + 0.5 * at(side[1], share[1]));
  }
  return all;
}

std::span<const Triangulation::Triangle> Triangulation::triangulate_by_ears(
    std::span<const Point3> polygon) {
  flatten(polygon, newell_normal(polygon));
  corners_.clear();
  is_by_loops_ = is_bridged_ = is_swept_ = is_uncrossed_ = false;
  ears_.cut(flattened_, std::numeric_limits<std::size_t>::max(), corners_);
  return with_sides();
}

}  // namespace displayfile
