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
/// normal and the distance from the origin. All planes are known from the beginning and are put in
/// order once; a search sees those that were inserted. The boxes of a branch are those of the
/// inserted ones alone, so that what is not inserted costs a search nothing.
class PlaneTree {
 public:
  /// Normal and distance: the points v with n . v = distance.
  using Plane = glm::dvec4;

  /// The planes have indices from 0; they are rough, since they are only put in order.
  explicit PlaneTree(std::span<const Plane> planes);

  /// A plane by its index, which may be off by `radius` at points that are looked for; a search may
  /// leave out those of lesser area.
  void insert(std::uint32_t index, const Plane& plane, double radius, double area);

  /// Calls visit(index) for each inserted plane that may be within `near` of each corner and has an
  /// area no less than what visit returned last, at first `least`, and for others too. Returns how
  /// many nodes it looked at.
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
  /// A search: one corner and two sides of a triangle, which branches are held against.
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

  /// A level's nodes have eight nodes of the level below each, those of the first eight planes.
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
