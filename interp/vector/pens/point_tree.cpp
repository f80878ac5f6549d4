#include "interp/vector/pens/point_tree.h"

#include <algorithm>
#include <numeric>

namespace displayfile {

PointTree::PointTree(std::span<const SheetPoint> points)
    : points_(points), numbers_(points.size()), leaf_of_(points.size(), kNone) {
  std::iota(numbers_.begin(), numbers_.end(), 0u);
  nodes_.reserve(points.size() / 2 + 2);
  nodes_.push_back({{}, {}, 0, static_cast<std::uint32_t>(points.size()), 0, kNone, 0});
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) build(node);
}

/// Finds a node's extent, and splits it across the middle of its longer side if it is no leaf.
void PointTree::build(std::uint32_t number) {
  Node node = nodes_[number];
  const auto own = std::span(numbers_).subspan(node.begin, node.end - node.begin);
  node.points_left = node.end - node.begin;
  if (own.empty()) {
    nodes_[number] = node;
    return;
  }
  node.low = node.high = points_[own.front()];
  for (const std::uint32_t k : own) {
    const SheetPoint& p = points_[k];
    node.low = {std::min(node.low.x, p.x), std::min(node.low.y, p.y)};
    node.high = {std::max(node.high.x, p.x), std::max(node.high.y, p.y)};
  }
  if (own.size() <= kLeaf) {
    for (const std::uint32_t k : own) leaf_of_[k] = number;
  } else {
    const bool across = node.high.x - node.low.x >= node.high.y - node.low.y;
    const auto middle = own.begin() + static_cast<std::ptrdiff_t>(own.size() / 2);
    std::ranges::nth_element(own, middle, [&](std::uint32_t a, std::uint32_t b) {
      const SheetPoint &p = points_[a], &q = points_[b];
      const std::int32_t of_a = across ? p.x : p.y, of_b = across ? q.x : q.y;
      return of_a != of_b ? of_a < of_b : a < b;
    });
    const auto split = node.begin + static_cast<std::uint32_t>(own.size() / 2);
    node.left = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({{}, {}, node.begin, split, 0, number, 0});
    nodes_.push_back({{}, {}, split, node.end, 0, number, 0});
  }
  nodes_[number] = node;
}

std::int64_t PointTree::squared_distance_to(const Node& node, const SheetPoint& p) {
  const SheetPoint nearest{std::clamp(p.x, node.low.x, node.high.x),
                           std::clamp(p.y, node.low.y, node.high.y)};
  return squared_distance(p, nearest);
}

void PointTree::search(std::uint32_t number, const SheetPoint& to, std::size_t count) const {
  const Node& node = nodes_[number];
  if (node.left == 0) {
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      const std::uint32_t point = numbers_[i];
      if (leaf_of_[point] == kNone) continue;
      const Candidate candidate{squared_distance(to, points_[point]), point};
      if (best_.size() == count) {
        if (!(candidate < best_.front())) continue;
        std::pop_heap(best_.begin(), best_.end());
        best_.pop_back();
      }
      best_.push_back(candidate);
      std::push_heap(best_.begin(), best_.end());
    }
    return;
  }
  std::uint32_t near = node.left, far = node.left + 1;
  std::int64_t to_near = squared_distance_to(nodes_[near], to);
  std::int64_t to_far = squared_distance_to(nodes_[far], to);
  if (to_far < to_near) {
    std::swap(near, far);
    std::swap(to_near, to_far);
  }
  const auto may_hold = [&](std::uint32_t child, std::int64_t squared) {
    return nodes_[child].points_left > 0 &&
           (best_.size() < count || squared <= best_.front().squared);
  };
  if (may_hold(near, to_near)) search(near, to, count);
  if (may_hold(far, to_far)) search(far, to, count);
}

void PointTree::nearest(const SheetPoint& to, std::size_t count,
                        std::vector<std::uint32_t>& found) const {
  best_.clear();
  search(0, to, count);
  std::ranges::sort_heap(best_);
  found.clear();
  for (const Candidate& candidate : best_) found.push_back(candidate.point);
}

std::uint32_t PointTree::nearest(const SheetPoint& to) const {
  best_.clear();
  search(0, to, 1);
  return best_.empty() ? kNone : best_.front().point;
}

void PointTree::remove(std::uint32_t point) {
  std::uint32_t node = leaf_of_[point];
  if (node == kNone) return;
  leaf_of_[point] = kNone;
  for (; node != kNone; node = nodes_[node].parent) --nodes_[node].points_left;
}

}  // namespace displayfile
