#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// A box in space with sides along the axes, its faces included.
struct SpaceBox {
  Point3 low{std::numeric_limits<double>::infinity()};
  Point3 high{-std::numeric_limits<double>::infinity()};
  void include(const Point3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
};

/// From a point without end; the direction is not zero.
class SpaceRay {
 public:
  SpaceRay(const Point3& from, const Point3& direction) : from_(from) {
    constexpr double kLeast = 1e-300;  // in place of less: no quotient is 0/0
    for (int k = 0; k < 3; ++k) {
      const double d = direction[k];
      per_direction_[k] = 1.0 / (std::abs(d) < kLeast ? std::copysign(kLeast, d) : d);
    }
  }
  /// True if the ray meets the box; may be true too if it passes by within a few roundings.
  bool meets(const SpaceBox& box) const {
    constexpr double kFarther = 1.0 + 0x1p-48;
    double enters = 0.0, leaves = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      const double a = (box.low[k] - from_[k]) * per_direction_[k];
      const double b = (box.high[k] - from_[k]) * per_direction_[k];
      enters = std::max(enters, std::min(a, b));
      leaves = std::min(leaves, std::max(a, b));
    }
    return enters <= leaves * kFarther;
  }

 private:
  Point3 from_, per_direction_;
};

/// A hierarchy over boxes in space, for rays of any direction: each branch has the box of all that
/// is in it and is cut in two halves of as many items, across the axis along which their middles
/// spread the farthest. So no input makes a deep tree.
class SpaceTree {
 public:
  using Item = std::uint32_t;

  /// Of fewer than 2^31 boxes of finite coordinates; an item is its index in the list.
  void build(std::span<const SpaceBox> boxes);

  /// Calls visit(item) for items whose boxes' branches the ray meets, until one returns true:
  /// then true.
  template <class Visit>
  bool any(const SpaceRay& ray, Visit&& visit) const;

 private:
  static constexpr std::size_t kItemsOfLeaf = 4;
  static constexpr std::size_t kDeepest = 32;  // every level halves fewer than 2^31 items
  struct Node {
    SpaceBox box;
    std::uint32_t first;  // of its items, or the first of its two branches
    std::uint32_t items;  // 0: it has branches
  };
  struct Part {
    std::size_t node, begin, end;
  };
  void cut(const Part& part, std::span<const SpaceBox> boxes, std::vector<Part>& parts);

  std::vector<Node> nodes_;  // the first is the root
  std::vector<Item> items_;
};

template <class Visit>
bool SpaceTree::any(const SpaceRay& ray, Visit&& visit) const {
  if (nodes_.empty()) return false;
  std::array<std::uint32_t, kDeepest + 1> later;
  std::size_t waiting = 0;
  later[waiting++] = 0;
  while (waiting > 0) {
    const Node& node = nodes_[later[--waiting]];
    if (!ray.meets(node.box)) continue;
    if (node.items == 0) {
      later[waiting++] = node.first + 1;
      later[waiting++] = node.first;
      continue;
    }
    for (std::uint32_t k = node.first; k < node.first + node.items; ++k) {
      if (visit(items_[k])) return true;
    }
  }
  return false;
}

}  // namespace displayfile
