#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// Finds planes that pass near points: a tree over planes as points of four numbers, the unit
/// normal and the distance from the origin. All planes are given at construction and sorted once; a
/// search sees the inserted ones. The boxes of a branch include only inserted planes, so that
/// others cost nothing.
class PlaneTree {
 public:
  /// Normal and distance: the points v with n . v = distance.
  using Plane = glm::dvec4;

  /// The planes, approximate, since they only determine the order.
  explicit PlaneTree(std::span<const Plane> planes);

  /// Inserts a plane by index, which may be off by `radius` at searched points; searches may skip
  /// planes of smaller area.
  void insert(std::uint32_t index, const Plane& plane, double radius, double area);

  /// Calls visit(index) for each inserted plane that may be within `near` of each corner and has an
  /// area of at least the last result of visit, initially `least`, and for others too. Returns the
  /// number of nodes examined.
  template <class Visit>
  std::size_t visit_near(const std::array<Point3, 3>& corners, double near, double least,
                         Visit&& visit) const;

 private:
  static constexpr std::size_t kBranches = 8;
  using Lanes = std::array<double, kBranches>;
  /// Each branch has the box of the inserted planes; it has none if the area is negative.
  struct Node {
    std::array<Lanes, 4> low, high;
    Lanes radius, largest_area;
    Node();
    void include(std::size_t branch, const Plane& plane, double of_radius, double area);
  };
  /// A search: one corner and two sides of a triangle, to compare with branches.
  struct Query {
    Point3 corner, first_side, second_side;
    double near;
    void find_distances(const Node& node, const Point3& v, Lanes& least, Lanes& most) const;
    std::uint32_t branches(const Node& node, double least_area) const;
  };
  struct Entry {
    Plane plane;
    std::uint32_t index;
  };
  static void divide(std::span<Entry> entries, std::size_t half);

  /// Each node has eight nodes of the level below; at the first level, eight planes.
  std::vector<std::vector<Node>> levels_;
  std::vector<std::uint32_t> order_;  // indices of planes
  std::vector<std::uint32_t> place_;  // in order_, by index
};

template <class Visit>
std::size_t PlaneTree::visit_near(const std::array<Point3, 3>& corners, double near, double least,
                                  Visit&& visit) const {
  struct Waiting {
    double largest_area;
    std::uint32_t node, level;
  };
  constexpr std::size_t kDeepest = 11;  // 8^11 exceeds all indices
  std::array<Waiting, kBranches * kDeepest> waiting;
  const Query query{corners[0], corners[1] - corners[0], corners[2] - corners[0], near};
  waiting[0] = {least, 0, static_cast<std::uint32_t>(levels_.size() - 1)};
  std::size_t looked_at = 0;
  for (std::size_t count = 1; count > 0;) {
    const auto [largest_area, at, level] = waiting[--count];
    if (largest_area < least) continue;
    ++looked_at;
    const Node& node = levels_[level][at];
    const std::uint32_t branches = query.branches(node, least);
    for (std::uint32_t k = 0; k < kBranches; ++k) {
      if ((branches >> k & 1) == 0) continue;
      const std::uint32_t branch = static_cast<std::uint32_t>(kBranches) * at + k;
      if (level > 0) {
        assert(count < waiting.size());
        waiting[count++] = {node.largest_area[k], branch, level - 1};
      } else {
        least = visit(order_[branch]);
      }
    }
  }
  return looked_at;
}

}  // namespace displayfile
