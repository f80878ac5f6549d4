#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "clip/point.h"
#include "displayfile/mesh/mesh.h"
#include "tests/solid_scenes.h"

// Combined solids, judged along rays. A convex part covers one interval of a ray, which follows
// from the planes of its polygons. The combination of these intervals is the truth. Doubles
// suffice: a ray that comes near a side, or lies nearly in a plane, is not used.

namespace displayfile::test {

/// A convex solid, or the combination of several.
struct SolidTree {
  EnterSolid shape;  ///< of a convex solid
  Mesh polygons;     ///< of a convex solid, as it is entered alone
  SolidOperation operation = SolidOperation::unite;
  std::vector<SolidTree> parts;

  explicit SolidTree(const EnterSolid& convex) : shape(convex), polygons(Entered(convex).mesh()) {}
  SolidTree(SolidOperation op, std::vector<SolidTree> of) : operation(op), parts(std::move(of)) {}

  void enter(GraphicsSystem& g) const {
    if (parts.empty()) return shape(g);
    g.begin_solid(operation);
    for (const SolidTree& part : parts) part.enter(g);
    g.end_solid();
  }
};

struct Ray {
  Point3 from, direction;
};
using Interval = std::pair<double, double>;

constexpr double kSameDepth = 1e-8;  ///< faces of several parts in one plane
constexpr double kClearly = 1e-6;    ///< less is not decided

/// The area, in the direction in which the corners are counterclockwise.
inline Point3 area_of(std::span<const Point3> polygon) {
  Point3 area(0.0);
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    area += 0.5 * glm::cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
  }
  return area;
}

inline std::vector<Point3> corners_of(const Mesh& mesh, std::size_t face) {
  std::vector<Point3> polygon;
  for (const std::uint32_t corner : mesh.face(face)) polygon.push_back(mesh.vertices[corner]);
  return polygon;
}

/// Nothing if the ray passes too near a side of the solid.
inline std::optional<Interval> interval_within(const Mesh& convex, const Ray& ray) {
  Interval within(-1e9, 1e9);
  for (std::size_t i = 0; i < convex.faces(); ++i) {
    const std::vector<Point3> polygon = corners_of(convex, i);
    const Point3 normal = glm::normalize(area_of(polygon));
    const double slope = glm::dot(normal, ray.direction);
    if (std::abs(slope) < kClearly) return std::nullopt;
    const double depth = glm::dot(polygon[0] - ray.from, normal) / slope;
    if (slope < 0.0) within.first = std::max(within.first, depth);
    if (slope > 0.0) within.second = std::min(within.second, depth);
  }
  if (std::abs(within.second - within.first) < kClearly) return std::nullopt;
  return within;
}

/// Finds the intervals of the tree's convex parts, in their order. Returns false if one is not
/// decided.
inline bool find_intervals(const SolidTree& tree, const Ray& ray, std::vector<Interval>& all) {
  if (tree.parts.empty()) {
    const auto interval = interval_within(tree.polygons, ray);
    if (interval) all.push_back(*interval);
    return interval.has_value();
  }
  return std::ranges::all_of(tree.parts,
                             [&](const SolidTree& part) { return find_intervals(part, ray, all); });
}

/// True if the solid is at that depth; `next` counts its convex parts.
inline bool is_in(const SolidTree& tree, double depth, const std::vector<Interval>& intervals,
                  std::size_t& next) {
  if (tree.parts.empty()) {
    const auto& [first, last] = intervals[next++];
    return first < depth && depth < last;
  }
  bool whole = is_in(tree.parts[0], depth, intervals, next);
  for (std::size_t k = 1; k < tree.parts.size(); ++k) {
    const bool part = is_in(tree.parts[k], depth, intervals, next);
    if (tree.operation == SolidOperation::unite) whole = whole || part;
    if (tree.operation == SolidOperation::intersect) whole = whole && part;
    if (tree.operation == SolidOperation::difference) whole = whole && !part;
  }
  return whole;
}

/// The depths at which the ray enters and leaves the solid, by turns. Nothing if undecided.
inline std::optional<std::vector<double>> true_depths(const SolidTree& tree, const Ray& ray) {
  std::vector<Interval> intervals;
  if (!find_intervals(tree, ray, intervals)) return std::nullopt;
  std::vector<double> all, apart, changes;
  for (const auto& [first, last] : intervals) {
    if (first < last) all.insert(all.end(), {first, last});
  }
  std::ranges::sort(all);
  for (const double depth : all) {
    if (!apart.empty() && depth - apart.back() < kSameDepth) continue;
    if (!apart.empty() && depth - apart.back() < kClearly) return std::nullopt;
    apart.push_back(depth);
  }
  bool was_in = false;
  for (std::size_t k = 0; k < apart.size(); ++k) {
    const double next = k + 1 < apart.size() ? apart[k + 1] : apart[k] + 1.0;
    std::size_t part = 0;
    const bool now = is_in(tree, 0.5 * (apart[k] + next), intervals, part);
    if (now != was_in) changes.push_back(apart[k]);
    was_in = now;
  }
  return changes;
}

/// Where a ray passes through a polygon.
struct Crossing {
  double depth;
  int enters;  ///< 1, or -1 where it leaves the solid
};

/// Adds the crossing with an even-odd polygon, if there is one. False if it is not decided.
inline bool find_crossing(std::span<const Point3> polygon, const Ray& ray,
                          std::vector<Crossing>& all) {
  const Point3 area = area_of(polygon);
  if (glm::length(area) < 1e-12) return true;  // rounding made it too thin to be met
  const Point3 normal = glm::normalize(area);
  const double slope = glm::dot(normal, ray.direction);
  if (std::abs(slope) < kClearly) return false;
  const double depth = glm::dot(polygon[0] - ray.from, normal) / slope;
  const Point3 at = ray.from + depth * ray.direction;
  const Point3 right = glm::normalize(polygon[1] - polygon[0]), up = glm::cross(normal, right);
  bool is_within = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point3 a = polygon[k] - at, b = polygon[(k + 1) % polygon.size()] - at;
    const Point3 along = b - a;
    const double length = glm::length(along);
    if (length > 0.0) {
      const double t = std::clamp(-glm::dot(a, along) / (length * length), 0.0, 1.0);
      if (glm::length(a + t * along) < kClearly) return false;
    }
    const Point2 p(glm::dot(a, right), glm::dot(a, up)), q(glm::dot(b, right), glm::dot(b, up));
    if ((p.y > 0.0) == (q.y > 0.0)) continue;
    if (p.x + (q.x - p.x) * (p.y / (p.y - q.y)) > 0.0) is_within = !is_within;
  }
  if (is_within) all.push_back({depth, slope < 0.0 ? 1 : -1});
  return true;
}

/// The depths at which the ray enters and leaves the mesh's volume, alternately; {-1} if they do
/// not alternate. Nothing if undecided.
inline std::optional<std::vector<double>> depths_in(const Mesh& mesh, const Ray& ray) {
  std::vector<Crossing> all;
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    if (!find_crossing(corners_of(mesh, i), ray, all)) return std::nullopt;
  }
  std::ranges::sort(all, {}, &Crossing::depth);
  std::vector<double> changes;
  int inside = 0;
  for (std::size_t i = 0; i < all.size();) {
    const int before = inside;
    const double depth = all[i].depth;
    for (; i < all.size() && all[i].depth - depth < kSameDepth; ++i) inside += all[i].enters;
    if (inside < 0 || inside > 1) return std::vector{-1.0};
    if (inside != before) changes.push_back(depth);
  }
  return inside == 0 ? changes : std::vector{-1.0};
}

/// Describes the error of the mesh of the tree's solid along a ray: empty if it is right, and no
/// value if that is not decided.
inline std::optional<std::string> wrong_along(const SolidTree& tree, const Mesh& mesh,
                                              const Ray& ray) {
  const auto truth = true_depths(tree, ray);
  if (!truth) return std::nullopt;
  const auto depths = depths_in(mesh, ray);
  if (!depths) return std::nullopt;
  const auto is_near = [](double a, double b) { return std::abs(a - b) < 1e-7; };
  if (std::ranges::equal(*truth, *depths, is_near)) return "";
  std::string wrong = "expected depths";
  for (const double depth : *truth) wrong += " " + std::to_string(depth);
  wrong += ", but they are";
  for (const double depth : *depths) wrong += " " + std::to_string(depth);
  return wrong;
}

}  // namespace displayfile::test
