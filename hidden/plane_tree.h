#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// Finds planes that pass near points: a tree over planes as points of four numbers, the unit
/// normal and the distance from the origin. All planes are known from the beginning and are put in
/// order once; a search sees those that were inserted. The boxes of a branch have the inserted ones
/// alone, so that what is not inserted costs a search nothing.
class PlaneTree {
 public:
  /// Normal and distance: the points v with n . v = distance.
  using Plane = glm::dvec4;

  explicit PlaneTree(std::span<const Plane> planes);

  /// A plane by its index; a search may leave out those of lesser area.
  void insert(std::uint32_t plane, double area);

  /// Calls visit(plane) for each inserted plane that may be within `near` of each of the points,
  /// of an area that is no less than what visit returned last, at first `least`. Returns how many
  /// nodes it looked at.
  template <class Visit>
  std::size_t visit_near(std::span<const Point3> points, double near, double least,
                         Visit&& visit) const;

 private:
  static constexpr std::size_t kLeaf = 8;
  struct Entry {
    Plane plane;
    std::uint32_t index;
    bool is_inserted;
  };
  /// Of the inserted planes; of none if the area is negative.
  struct Node {
    std::array<double, 4> low, high;
    double largest_area = -1.0;
    bool may_pass(const Point3& v, double near) const;
  };

  /// Where the entries of a node begin, of a level of so many nodes.
  std::size_t begin(std::size_t node, std::size_t nodes) const {
    return entries_.size() * node / nodes;
  }
  void divide(std::size_t node, std::size_t nodes);

  std::size_t leaves_ = 1;
  std::vector<Node> nodes_;  // the root is 1, the branches of node k are 2 k and 2 k + 1
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> place_;  // in entries_, by index
};

/// n . v - distance is 0 or nearly for some plane between the bounds.
inline bool PlaneTree::Node::may_pass(const Point3& v, double near) const {
  double least = -high[3], most = -low[3];
  for (int k = 0; k < 3; ++k) {
    const double a = low[static_cast<std::size_t>(k)] * v[k];
    const double b = high[static_cast<std::size_t>(k)] * v[k];
    least += a < b ? a : b;
    most += a < b ? b : a;
  }
  return !(least > near) && !(most < -near);
}

template <class Visit>
std::size_t PlaneTree::visit_near(std::span<const Point3> points, double near, double least,
                                  Visit&& visit) const {
  constexpr std::size_t kDeepest = 64;
  std::array<std::size_t, kDeepest> waiting;
  waiting[0] = 1;
  std::size_t looked_at = 0;
  for (std::size_t count = 1; count > 0; ++looked_at) {
    const std::size_t at = waiting[--count];
    const Node& node = nodes_[at];
    if (node.largest_area < 0.0 || node.largest_area < least) continue;
    bool may_pass = true;
    for (const Point3& v : points) may_pass = may_pass && node.may_pass(v, near);
    if (!may_pass) continue;
    if (at < leaves_) {
      waiting[count++] = 2 * at + 1;
      waiting[count++] = 2 * at;
      continue;
    }
    const std::size_t leaf = at - leaves_;
    for (std::size_t k = begin(leaf, leaves_); k < begin(leaf + 1, leaves_); ++k) {
      if (entries_[k].is_inserted) least = visit(entries_[k].index);
    }
  }
  return looked_at;
}

}  // namespace displayfile
