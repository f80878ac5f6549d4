#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// The box around a polygon, for the minimax (boxing) test; floats rounded outward, so that
/// boxes that are apart enclose polygons that are apart.
struct Extent {
  float x_min, x_max, y_min, y_max, z_min, z_max;

  /// Holds nothing, and meets only what has no bounds.
  static Extent nothing();
  /// Takes in a box of that radius around the point.
  void include(const Point3& p, double radius = 0.0);
  void include(const Extent& other);

  float low(int axis) const { return axis == 0 ? x_min : axis == 1 ? y_min : z_min; }
  float high(int axis) const { return axis == 0 ? x_max : axis == 1 ? y_max : z_max; }
  bool meets_in_projection(const Extent& o) const {
    return x_min <= o.x_max && o.x_min <= x_max && y_min <= o.y_max && o.y_min <= y_max;
  }
};

/// Finds all pairs of boxes that meet in the projection, without comparing all: a binary tree over
/// the boxes, halved at the median along the longer side. n log n to build, and for each box the
/// cost of those it meets and of the way to them.
class ExtentIndex {
 public:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  explicit ExtentIndex(std::span<const Extent> extents);

  /// Calls found(p, q) once for each pair of boxes that meets, one of which is in the leaves of
  /// the tree numbered from `from` to before `to`; for all pairs, from 0 to leaves(). p < q are
  /// positions: order()[p] is the box. Boxes at close positions are close to each other. Positions
  /// and the order of the pairs are functions of the boxes alone.
  template <class Found>
  void pairs(std::uint32_t from, std::uint32_t to, Found&& found) const;

  std::span<const std::uint32_t> order() const { return order_; }
  std::uint32_t leaves() const { return static_cast<std::uint32_t>(leaves_.size()); }

 private:
  static constexpr std::uint32_t kLeaf = 8;  ///< boxes

  struct Box {
    float x_min, x_max, y_min, y_max;
    bool meets(const Box& o) const {
      return x_min <= o.x_max && o.x_min <= x_max && y_min <= o.y_max && o.y_min <= y_max;
    }
  };
  struct Node {
    Box box;
    std::uint32_t first, end;  ///< positions in the order
    std::uint32_t right;       ///< the second half's node; the first half's follows; 0: a leaf
  };

  template <class Found>
  void pairs_of_leaves(const Node& a, const Node& b, Found&& found) const;

  std::vector<std::uint32_t> order_;
  std::vector<float> x_min_, x_max_, y_min_, y_max_;  ///< in that order, and room for a leaf
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leaves_;  ///< nodes, in order
};

template <class Found>
void ExtentIndex::pairs(std::uint32_t from, std::uint32_t to, Found&& found) const {
  std::array<std::uint32_t, 128> stack;
  for (std::uint32_t leaf = from; leaf < to; ++leaf) {
    const Node& own = nodes_[leaves_[leaf]];
    std::size_t waiting = 0;
    stack[waiting++] = 0;
    while (waiting > 0) {
      const std::uint32_t at = stack[--waiting];
      const Node& node = nodes_[at];
      // The later of two leaves is found from the earlier.
      if (node.end <= own.first || !node.box.meets(own.box)) continue;
      if (node.right != 0) {
        stack[waiting++] = node.right;
        stack[waiting++] = at + 1;
      } else {
        pairs_of_leaves(own, node, found);
      }
    }
  }
}

template <class Found>
void ExtentIndex::pairs_of_leaves(const Node& a, const Node& b, Found&& found) const {
  for (std::uint32_t p = a.first; p < a.end; ++p) {
    const Box box{x_min_[p], x_max_[p], y_min_[p], y_max_[p]};
    if (!box.meets(b.box)) continue;
    // All at once, without branches; beyond the leaf's end what is found is not used.
    std::array<std::int32_t, kLeaf> meets;
    const float *x_min = &x_min_[b.first], *x_max = &x_max_[b.first];
    const float *y_min = &y_min_[b.first], *y_max = &y_max_[b.first];
    for (std::uint32_t k = 0; k < kLeaf; ++k) {
      meets[k] = static_cast<std::int32_t>(box.x_min <= x_max[k]) &
                 static_cast<std::int32_t>(x_min[k] <= box.x_max) &
                 static_cast<std::int32_t>(box.y_min <= y_max[k]) &
                 static_cast<std::int32_t>(y_min[k] <= box.y_max);
    }
    for (std::uint32_t q = std::max(b.first, p + 1); q < b.end; ++q) {
      if (meets[q - b.first] != 0) found(p, q);
    }
  }
}

}  // namespace displayfile
