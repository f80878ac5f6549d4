#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace displayfile {

/// A hierarchy of bounding boxes, for all searches (hidden/boxes/box_tree.md): a tree with up to
/// eight branches per node, each with the box of its contents. An item is an index into the input
/// list. Each item also has a position in the tree; items at close positions are close to each
/// other. The tree is a function of the boxes alone.
///
/// `Boxes` are eight boxes of a type, laid out so that one loop tests all of them:
///   Boxes::Box                  one: Box::nothing(), include(const Box&)
/// and, for pairs(), Lanes meets(const Box&) const and Box box(k) const.
template <class Boxes>
class BoxTree {
 public:
  using Box = typename Boxes::Box;
  using Item = std::uint32_t;
  using Position = std::uint32_t;
  static constexpr std::size_t kBranches = 8;
  /// 1 or 0 for each of eight boxes.
  using Lanes = std::array<std::int32_t, kBranches>;

  /// Builds the tree of fewer than 2^31 items, each with its box, replacing the contents; on up to
  /// `threads` threads, with the same result. The rule of division is chosen where each type of
  /// tree is declared.
  void build(std::size_t items, const std::function<Box(Item)>& box_of, int threads);
  void build(std::span<const Box> boxes, int threads) {
    build(
        boxes.size(), [&](Item i) { return boxes[i]; }, threads);
  }

  /// Levels of nodes; at most kDeepest with 2^31 boxes.
  std::size_t depth() const { return depth_; }
  static constexpr std::size_t kDeepest = 160;

  std::size_t bytes() const {  ///< of the tree's arrays, as used
    const auto size = [](const auto& array) { return array.size() * sizeof(array[0]); };
    return size(nodes_) + size(end_) + size(leaves_) + size(order_);
  }

  /// The item at each position.
  std::span<const Item> order() const { return order_; }

  /// Calls visit(position) for items in boxes that are met, by meets(boxes) for eight boxes, until
  /// it returns true: then returns true.
  template <class Meets, class Visit>
  bool any(const Meets& meets, Visit&& visit) const;

  /// Calls visit(position) for items in boxes that are met, nearest branches first: meets(boxes,
  /// nearest) returns which of eight are met, and the nearest value of each, which grows toward the
  /// viewer. Skips a branch if hidden(nearest), called before each visit, returns true: everything
  /// that far away is hidden.
  template <class Nearness, class Meets, class Hidden, class Visit>
  void near_to_far(const Meets& meets, Hidden&& hidden, Visit&& visit) const;

  /// Calls found(p, q) once for each pair of positions p < q whose boxes meet, p in the leaves
  /// numbered [from, to); from 0 to leaves() for all pairs.
  template <class Found>
  void pairs(std::uint32_t from, std::uint32_t to, Found&& found) const;
  std::uint32_t leaves() const { return static_cast<std::uint32_t>(leaves_.size()); }

 private:
  static constexpr std::uint32_t kItem = 0x80000000;  // marks a branch that is an item's position
  /// Maximum pending branches: a search keeps the other branches of each node on its path.
  static constexpr std::size_t kMostWaiting = (kBranches - 1) * kDeepest + 1;

  struct Node {
    Boxes boxes;
    std::array<std::uint32_t, kBranches> branch;  ///< 0: no branch; the root is not one
  };

  template <class Rule>
  struct Builder;  // hidden/boxes/build_box_tree.h
  template <class Rule>
  void build_by(std::size_t items, const std::function<Box(Item)>& box_of, int threads);

  static std::uint32_t bits(const Lanes& lanes) {
    std::uint32_t set = 0;
    for (std::size_t k = 0; k < kBranches; ++k) set |= static_cast<std::uint32_t>(lanes[k]) << k;
    return set;
  }
  static bool is_item(std::uint32_t branch) { return (branch & kItem) != 0; }
  template <class Found>
  void pairs_of_leaf(const Node& own, Position first, const Box& all, Found&& found) const;

  std::vector<Node> nodes_;            // the root first
  std::vector<Position> end_;          // per node: the position after its last item
  std::vector<std::uint32_t> leaves_;  // nodes that have items
  std::vector<Item> order_;
  std::size_t depth_ = 0;
};

template <class Boxes>
template <class Meets, class Visit>
bool BoxTree<Boxes>::any(const Meets& meets, Visit&& visit) const {
  if (nodes_.empty()) return false;
  std::array<std::uint32_t, kMostWaiting> waiting;
  waiting[0] = 0;
  for (std::size_t count = 1; count > 0;) {
    const Node& node = nodes_[waiting[--count]];
    const Lanes met = meets(node.boxes);
    for (std::size_t k = 0; k < kBranches; ++k) {
      const std::uint32_t branch = node.branch[k];
      if (met[k] == 0 || branch == 0) continue;
      if (!is_item(branch)) {
        assert(count < kMostWaiting);
        waiting[count++] = branch;
      } else if (visit(branch & ~kItem)) {
        return true;
      }
    }
  }
  return false;
}

template <class Boxes>
template <class Nearness, class Meets, class Hidden, class Visit>
void BoxTree<Boxes>::near_to_far(const Meets& meets, Hidden&& hidden, Visit&& visit) const {
  if (nodes_.empty()) return;
  struct Waiting {
    Nearness nearest;
    std::uint32_t branch;
  };
  std::array<Waiting, kMostWaiting> waiting;
  std::size_t count = 0;
  std::uint32_t at = 0;
  while (true) {
    const Node& node = nodes_[at];
    std::array<Nearness, kBranches> nearest;
    const Lanes met = meets(node.boxes, nearest);
    // The nearest branches end up on top.
    const std::size_t base = count;
    for (std::size_t k = 0; k < kBranches; ++k) {
      if (met[k] == 0 || node.branch[k] == 0) continue;
      assert(count < kMostWaiting);
      std::size_t place = count++;
      for (; place > base && waiting[place - 1].nearest > nearest[k]; --place) {
        waiting[place] = waiting[place - 1];
      }
      waiting[place] = {nearest[k], node.branch[k]};
    }
    while (true) {
      if (count == 0) return;
      const auto [begins, branch] = waiting[--count];
      if (hidden(begins)) continue;
      if (!is_item(branch)) {
        at = branch;
        break;
      }
      visit(branch & ~kItem);
    }
  }
}

/// Each leaf searches for items that meet it, the whole leaf at once, and keeps those with later
/// positions.
template <class Boxes>
template <class Found>
void BoxTree<Boxes>::pairs(std::uint32_t from, std::uint32_t to, Found&& found) const {
  assert(from <= to && to <= leaves());
  for (std::uint32_t leaf = from; leaf < to; ++leaf) {
    const Node& own = nodes_[leaves_[leaf]];
    Box all = Box::nothing();
    Position first = end_[0];
    for (std::size_t k = 0; k < kBranches; ++k) {
      if (!is_item(own.branch[k])) continue;
      all.include(own.boxes.box(k));
      first = std::min(first, own.branch[k] & ~kItem);
    }
    pairs_of_leaf(own, first, all, found);
  }
}

template <class Boxes>
template <class Found>
void BoxTree<Boxes>::pairs_of_leaf(const Node& own, Position first, const Box& all,
                                   Found&& found) const {
  std::array<std::uint32_t, kMostWaiting> waiting;
  waiting[0] = 0;
  for (std::size_t count = 1; count > 0;) {
    const Node& node = nodes_[waiting[--count]];
    std::uint32_t items = 0;  // one bit per item met
    for (std::uint32_t met = bits(node.boxes.meets(all)); met != 0; met &= met - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(met));
      const std::uint32_t branch = node.branch[k];
      if (is_item(branch)) {
        items |= 1U << k;
      } else if (branch != 0 && end_[branch] > first) {
        assert(count < kMostWaiting);
        waiting[count++] = branch;
      }
    }
    if (items == 0) continue;
    for (std::size_t i = 0; i < kBranches; ++i) {
      if (!is_item(own.branch[i])) continue;
      const Position p = own.branch[i] & ~kItem;
      std::uint32_t met = bits(node.boxes.meets(own.boxes.box(i))) & items;
      for (; met != 0; met &= met - 1) {
        const Position q = node.branch[static_cast<std::size_t>(std::countr_zero(met))] & ~kItem;
        if (p < q) found(p, q);
      }
    }
  }
}

}  // namespace displayfile
