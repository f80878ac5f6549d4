#include "hidden/plane_tree.h"

#include <algorithm>

namespace displayfile {

PlaneTree::PlaneTree(std::span<const Plane> planes) {
  while (leaves_ * kLeaf < planes.size()) leaves_ *= 2;
  entries_.reserve(planes.size());
  for (const Plane& plane : planes) {
    entries_.push_back({plane, static_cast<std::uint32_t>(entries_.size()), false});
  }
  for (std::size_t nodes = 1; nodes < leaves_; nodes *= 2) {
    for (std::size_t node = 0; node < nodes; ++node) divide(node, nodes);
  }
  place_.resize(entries_.size());
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    place_[entries_[k].index] = static_cast<std::uint32_t>(k);
  }
  nodes_.resize(2 * leaves_);
}

/// Across the axis along which the planes spread the farthest, in halves.
void PlaneTree::divide(std::size_t node, std::size_t nodes) {
  const auto at = [&](std::size_t k) { return entries_.begin() + static_cast<std::ptrdiff_t>(k); };
  const auto first = at(begin(node, nodes)), end = at(begin(node + 1, nodes));
  if (end - first < 2) return;
  Plane low = first->plane, high = low;
  for (auto entry = first; entry != end; ++entry) {
    low = glm::min(low, entry->plane);
    high = glm::max(high, entry->plane);
  }
  int widest = 0;
  for (int axis = 1; axis < 4; ++axis) {
    if (high[axis] - low[axis] > high[widest] - low[widest]) widest = axis;
  }
  std::nth_element(
      first, at(begin(2 * node + 1, 2 * nodes)), end,
      [=](const Entry& a, const Entry& b) { return a.plane[widest] < b.plane[widest]; });
}

void PlaneTree::insert(std::uint32_t index, double area) {
  const std::size_t place = place_[index];
  entries_[place].is_inserted = true;
  const Plane& plane = entries_[place].plane;
  // The leaf whose entries have it: none begins after it, and the next one does.
  std::size_t leaf = place * leaves_ / entries_.size();
  while (begin(leaf + 1, leaves_) <= place) ++leaf;
  for (std::size_t at = leaves_ + leaf; at > 0; at /= 2) {
    Node& node = nodes_[at];
    const bool is_empty = node.largest_area < 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      const double x = plane[static_cast<int>(k)];
      node.low[k] = is_empty ? x : std::min(node.low[k], x);
      node.high[k] = is_empty ? x : std::max(node.high[k], x);
    }
    node.largest_area = std::max(node.largest_area, area);
  }
}

}  // namespace displayfile
