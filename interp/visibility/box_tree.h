#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "interp/scan/pixel_box.h"

namespace displayfile {

/// A hierarchy over boxes of pixel centres, for rays that run along z through them: a tree of up
/// to eight branches a node, each with the box and the nearest depth of all that is in it.
/// interp/visibility/ray_cast.md tells how it is built. Boxes are of integers, and nothing is
/// rounded.
class BoxTree {
 public:
  using Item = std::uint32_t;

  /// What is put in: an item is its index in the list.
  struct Box {
    PixelBox pixels;  ///< not empty
    float nearest;    ///< no part of the item is nearer; z grows toward the viewer
  };

  /// Of fewer than 2^31 items; on up to so many threads, with the same result.
  void build(std::span<const Box> boxes, int threads);

  /// What is still to be visited, kept from one packet of rays to the next for its memory.
  struct Entry {
    float nearest;
    std::uint32_t branch;
  };
  using Stack = std::vector<Entry>;

  /// Calls visit(item) for the items whose boxes share a centre with the rays', the branches that
  /// begin nearer first. Leaves out a branch when hidden(nearest), asked before each visit, says
  /// that nothing so far away can be seen any more.
  template <class Hidden, class Visit>
  void front_to_back(const PixelBox& rays, Stack& stack, Hidden&& hidden, Visit&& visit) const;

 private:
  static constexpr int kBranches = 8;
  static constexpr std::uint32_t kItem = 0x80000000;  // marks a branch that is an item

  struct Node {
    template <class T>
    using Each = std::array<T, kBranches>;
    Each<std::int32_t> first_column, end_column, first_row, end_row;
    Each<float> nearest;
    Each<std::uint32_t> branch;
  };
  struct Builder;

  /// As a number, for all eight branches at once.
  static std::int32_t below(std::int32_t a, std::int32_t b) { return a < b ? 1 : 0; }

  std::vector<Node> nodes_;  // the first is the root
};

template <class Hidden, class Visit>
void BoxTree::front_to_back(const PixelBox& rays, Stack& stack, Hidden&& hidden,
                            Visit&& visit) const {
  if (nodes_.empty()) return;
  stack.assign(1, {std::numeric_limits<float>::infinity(), 0});
  while (!stack.empty()) {
    const Entry entry = stack.back();
    stack.pop_back();
    if (hidden(entry.nearest)) continue;
    if ((entry.branch & kItem) != 0) {
      visit(entry.branch & ~kItem);
      continue;
    }
    const Node& node = nodes_[entry.branch];
    std::array<std::int32_t, kBranches> meets;
    for (std::size_t k = 0; k < kBranches; ++k) {
      meets[k] = below(node.first_column[k], rays.end_column) &
                 below(rays.first_column, node.end_column[k]) &
                 below(node.first_row[k], rays.end_row) & below(rays.first_row, node.end_row[k]);
    }
    // The nearest comes to lie on top.
    const auto base = static_cast<std::ptrdiff_t>(stack.size());
    for (std::size_t k = 0; k < kBranches; ++k) {
      if (meets[k] == 0) continue;
      stack.push_back({node.nearest[k], node.branch[k]});
      for (auto at = static_cast<std::ptrdiff_t>(stack.size()) - 1; at > base; --at) {
        Entry& lower = stack[static_cast<std::size_t>(at - 1)];
        Entry& upper = stack[static_cast<std::size_t>(at)];
        if (lower.nearest <= upper.nearest) break;
        std::swap(lower, upper);
      }
    }
  }
}

}  // namespace displayfile
