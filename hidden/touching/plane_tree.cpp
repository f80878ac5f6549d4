#include "hidden/touching/plane_tree.h"

#include <algorithm>
#include <cassert>
#include <glm/common.hpp>

namespace displayfile {

PlaneTree::PlaneTree(std::span<const Plane> planes) {
  std::vector<Entry> entries;
  entries.reserve(planes.size());
  for (const Plane& plane : planes) {
    entries.push_back({plane, static_cast<std::uint32_t>(entries.size())});
  }
  // A range of planes to be divided until each part fits a branch of its node.
  struct Part {
    std::size_t first, size, unit;  // unit: the number of planes of a branch
  };
  std::size_t nodes = planes.size(), unit = 1;
  do {
    nodes = (nodes + kBranches - 1) / kBranches;
    levels_.emplace_back(nodes);
    unit *= kBranches;
  } while (nodes > 1);
  std::vector<Part> parts{{0, entries.size(), unit / kBranches}};
  while (!parts.empty()) {
    auto [first, size, branch] = parts.back();
    parts.pop_back();
    while (branch >= size) branch /= kBranches;
    if (branch <= 1) continue;  // eight or fewer planes, in any order
    const std::size_t half = (size / branch + 1) / 2 * branch;
    divide(std::span(entries).subspan(first, size), half);
    parts.push_back({first, half, branch});
    parts.push_back({first + half, size - half, branch});
  }
  place_.resize(entries.size());
  for (std::size_t k = 0; k < entries.size(); ++k) {
    order_.push_back(entries[k].index);
    place_[order_[k]] = static_cast<std::uint32_t>(k);
  }
}

/// Divides across the axis along which the planes spread most; the lower half comes first.
void PlaneTree::divide(std::span<Entry> entries, std::size_t half) {
  Plane low = entries.front().plane, high = low;
  for (const Entry& entry : entries) {
    low = glm::min(low, entry.plane);
    high = glm::max(high, entry.plane);
  }
  const Plane spread = high - low;
  int widest = 0;
  for (int axis = 1; axis < 4; ++axis) {
    if (spread[axis] > spread[widest]) widest = axis;
  }
  std::nth_element(
      entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(half), entries.end(),
      [=](const Entry& a, const Entry& b) { return a.plane[widest] < b.plane[widest]; });
}

PlaneTree::Node::Node() {
  for (std::size_t axis = 0; axis < 4; ++axis) {
    low[axis].fill(0.0);
    high[axis].fill(0.0);
  }
  radius.fill(0.0);
  largest_area.fill(-1.0);
}

void PlaneTree::Node::include(std::size_t branch, const Plane& plane, double of_radius,
                              double area) {
  const bool is_empty = largest_area[branch] < 0.0;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const double x = plane[static_cast<int>(axis)];
    low[axis][branch] = is_empty ? x : std::min(low[axis][branch], x);
    high[axis][branch] = is_empty ? x : std::max(high[axis][branch], x);
  }
  radius[branch] = std::max(radius[branch], of_radius);
  largest_area[branch] = std::max(largest_area[branch], area);
}

/// Adds the range of n . v over the planes of each branch.
void PlaneTree::Query::find_distances(const Node& node, const Point3& v, Lanes& least,
                                      Lanes& most) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = v[static_cast<int>(axis)];
    const Lanes& low = x < 0.0 ? node.high[axis] : node.low[axis];
    const Lanes& high = x < 0.0 ? node.low[axis] : node.high[axis];
    for (std::size_t k = 0; k < kBranches; ++k) {
      least[k] += low[k] * x;
      most[k] += high[k] * x;
    }
  }
}

/// A bit for each branch that may have a plane near all corners: the distances of two corners then
/// differ by at most twice `near`.
std::uint32_t PlaneTree::Query::branches(const Node& node, double least_area) const {
  Lanes least{}, most{}, first_least{}, first_most{}, second_least{}, second_most{};
  for (std::size_t k = 0; k < kBranches; ++k) {
    least[k] = -node.high[3][k];
    most[k] = -node.low[3][k];
  }
  find_distances(node, first_side, first_least, first_most);
  find_distances(node, second_side, second_least, second_most);
  find_distances(node, corner, least, most);
  std::uint32_t found = 0;
  for (std::size_t k = 0; k < kBranches; ++k) {
    const double of_sides =
        std::max({first_least[k], -first_most[k], second_least[k], -second_most[k]});
    const double distance = std::max({least[k], -most[k], 0.5 * of_sides});
    const bool is_wanted = node.largest_area[k] >= std::max(least_area, 0.0);
    if (is_wanted && !(distance > near + node.radius[k])) found |= 1U << k;
  }
  return found;
}

void PlaneTree::insert(std::uint32_t index, const Plane& plane, double radius, double area) {
  assert(index < place_.size());
  std::size_t place = place_[index];
  for (std::vector<Node>& level : levels_) {
    level[place / kBranches].include(place % kBranches, plane, radius, area);
    place /= kBranches;
  }
}

}  // namespace displayfile
