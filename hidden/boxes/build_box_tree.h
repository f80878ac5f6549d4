#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "clip/base/parallel.h"
#include "hidden/boxes/box_tree.h"

// Builds a tree of boxes (hidden/boxes/box_tree.md); included by files that define the rule of
// division.

namespace displayfile {

/// A box during sorting.
template <class Box>
struct BoxEntry {
  Box box;
  std::uint32_t item;
};

/// The range of the entries' middles along each axis of Box, from box.position(axis).
template <class Box>
struct MiddlesSpread {
  std::array<double, Box::kAxes> low, high;

  explicit MiddlesSpread(std::span<const BoxEntry<Box>> entries) {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (const auto& entry : entries) {
      for (std::size_t axis = 0; axis < Box::kAxes; ++axis) {
        const double at = entry.box.position(axis);
        low[axis] = std::min(low[axis], at);
        high[axis] = std::max(high[axis], at);
      }
    }
  }
  double along(std::size_t axis) const { return high[axis] - low[axis]; }
  /// The axis with the largest range of middles, the first of equal ones.
  std::size_t widest() const {
    std::size_t widest = 0;
    for (std::size_t axis = 1; axis < Box::kAxes; ++axis) {
      if (along(axis) > along(widest)) widest = axis;
    }
    return widest;
  }
};

/// Moves the lower half along an axis to the front, and returns its size: whole nodes of eight. Of
/// equal middles the lower item comes first.
template <class Box>
std::size_t halve(std::span<BoxEntry<Box>> entries, std::size_t axis) {
  constexpr std::size_t kNode = 8;
  const std::size_t whole = (entries.size() / 2 + kNode - 1) / kNode * kNode;
  const std::size_t half = whole < entries.size() ? whole : entries.size() / 2;
  const auto middle = entries.begin() + static_cast<std::ptrdiff_t>(half);
  std::nth_element(entries.begin(), middle, entries.end(), [&](const auto& a, const auto& b) {
    const double at_a = a.box.position(axis), at_b = b.box.position(axis);
    return at_a != at_b ? at_a < at_b : a.item < b.item;
  });
  return half;
}

/// The rule that halves across the axis with the largest range of middles: quick to build. A rule
/// gives the cost of leaving a branch undivided, and divides one: the entries of the first part are
/// a function of the set of entries, not of their order; the smaller part has at least an eighth of
/// them, or as many as a node.
template <class Box>
struct Halves {
  static double cost(const Box&, std::size_t items) { return static_cast<double>(items); }
  static std::size_t divide(std::span<BoxEntry<Box>> entries) {
    return halve(entries, MiddlesSpread<Box>(entries).widest());
  }
};

template <class Boxes>
template <class Rule>
struct BoxTree<Boxes>::Builder {
  /// The items of a branch, as a range of the entries, and their box.
  struct Part {
    std::size_t begin, end;
    Box box;
    std::size_t size() const { return end - begin; }
  };
  /// A node to be built, and its result.
  struct Work {
    std::uint32_t node;
    Part part;
    std::vector<Part> branches{};
  };

  std::vector<BoxEntry<Box>> entries{};  // reordered together

  Part part(std::size_t begin, std::size_t end) const {
    Part p{begin, end, Box::nothing()};
    for (std::size_t k = begin; k < end; ++k) p.box.include(entries[k].box);
    return p;
  }

  /// Divides the branch with the highest cost until the node is full. A leaf has no branches; its
  /// items are sorted, since dividing them may have left any order.
  void branch(Work& work) {
    std::vector<Part>& branches = work.branches;
    const auto all = std::span(entries).subspan(work.part.begin, work.part.size());
    if (all.size() <= kBranches) {
      std::ranges::sort(all, {}, &BoxEntry<Box>::item);
      return;
    }
    branches.reserve(kBranches);
    branches.push_back(work.part);
    const auto cost = [](const Part& p) {
      return p.size() > kBranches ? Rule::cost(p.box, p.size()) : 0.0;
    };
    while (branches.size() < kBranches) {
      const auto most = std::ranges::max_element(branches, {}, cost);
      if (most->size() <= kBranches) break;
      const auto [begin, end] = std::pair(most->begin, most->end);
      const std::size_t second =
          begin + Rule::divide(std::span(entries).subspan(begin, end - begin));
      assert(begin < second && second < end);
      *most = part(begin, second);
      branches.insert(most + 1, part(second, end));
    }
  }
};

/// Level by level, so that a level's nodes can be built in parallel and numbered in order.
template <class Boxes>
template <class Rule>
void BoxTree<Boxes>::build_by(std::size_t items, const std::function<Box(Item)>& box_of,
                              int threads) {
  constexpr std::size_t kWorthThreads = 2000;  // fewer take less time than waking threads
  assert(items < kItem);
  nodes_.clear();
  end_.clear();
  leaves_.clear();
  order_.clear();
  depth_ = 0;
  if (items == 0) return;
  if (items < kWorthThreads) threads = 1;
  Builder<Rule> builder;
  builder.entries.reserve(items);
  for (Item i = 0; i < items; ++i) builder.entries.push_back({box_of(i), i});
  std::vector<typename Builder<Rule>::Work> level{{0, builder.part(0, items)}};
  nodes_.emplace_back();
  for (; !level.empty(); ++depth_) {
    in_parallel(threads, level.size(), [&](std::size_t k) { builder.branch(level[k]); });
    std::size_t branches = 0;  // that are nodes
    for (const auto& work : level) {
      branches += static_cast<std::size_t>(
          std::ranges::count_if(work.branches, [](const auto& part) { return part.size() > 1; }));
    }
    nodes_.reserve(nodes_.size() + branches);  // no more: levels grow eightfold
    std::vector<typename Builder<Rule>::Work> next;
    next.reserve(branches);
    for (const auto& work : level) {
      Node node;
      for (std::size_t k = 0; k < kBranches; ++k) node.boxes.set(k, Box::nothing());
      node.branch.fill(0);
      bool has_items = false;
      const auto put_item = [&](std::size_t k, std::size_t position) {
        node.boxes.set(k, builder.entries[position].box);
        node.branch[k] = kItem | static_cast<Position>(position);
        has_items = true;
      };
      if (work.branches.empty()) {
        for (std::size_t k = 0; k < work.part.size(); ++k) put_item(k, work.part.begin + k);
      }
      for (std::size_t k = 0; k < work.branches.size(); ++k) {
        const auto& part = work.branches[k];
        if (part.size() == 1) {
          put_item(k, part.begin);
          continue;
        }
        node.boxes.set(k, part.box);
        node.branch[k] = static_cast<std::uint32_t>(nodes_.size());
        next.push_back({node.branch[k], part});
        nodes_.emplace_back();
      }
      nodes_[work.node] = node;
      end_.push_back(static_cast<Position>(work.part.end));
      if (has_items) leaves_.push_back(work.node);
    }
    level = std::move(next);
  }
  assert(depth_ <= kDeepest && end_.size() == nodes_.size());
  order_.reserve(items);
  for (const auto& entry : builder.entries) order_.push_back(entry.item);
}

}  // namespace displayfile
