#include "interp/raster/space_tree.h"

#include <numeric>

namespace displayfile {

void SpaceTree::build(std::span<const SpaceBox> boxes) {
  nodes_.clear();
  items_.resize(boxes.size());
  std::iota(items_.begin(), items_.end(), Item{0});
  if (boxes.empty()) return;
  nodes_.push_back({});
  std::vector<Part> parts{{0, 0, boxes.size()}};
  while (!parts.empty()) {
    const Part part = parts.back();
    parts.pop_back();
    cut(part, boxes, parts);
  }
}

void SpaceTree::cut(const Part& part, std::span<const SpaceBox> boxes, std::vector<Part>& parts) {
  const auto [node, begin, end] = part;
  SpaceBox all, middles;
  const auto twice_the_middle = [&](Item item) { return boxes[item].low + boxes[item].high; };
  for (std::size_t k = begin; k < end; ++k) {
    all.include(boxes[items_[k]].low);
    all.include(boxes[items_[k]].high);
    middles.include(twice_the_middle(items_[k]));
  }
  nodes_[node].box = all;
  if (end - begin <= kItemsOfLeaf) {
    nodes_[node].first = static_cast<std::uint32_t>(begin);
    nodes_[node].items = static_cast<std::uint32_t>(end - begin);
    return;
  }
  const Point3 spread = middles.high - middles.low;
  const int axis = spread.x >= spread.y && spread.x >= spread.z ? 0 : spread.y >= spread.z ? 1 : 2;
  const std::size_t half = begin + (end - begin) / 2;
  const auto at = [&](std::size_t k) { return items_.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(begin), at(half), at(end), [&](Item a, Item b) {
    return std::pair(twice_the_middle(a)[axis], a) < std::pair(twice_the_middle(b)[axis], b);
  });
  const std::size_t branch = nodes_.size();
  nodes_[node].first = static_cast<std::uint32_t>(branch);
  nodes_[node].items = 0;
  nodes_.resize(branch + 2);
  parts.push_back({branch, begin, half});
  parts.push_back({branch + 1, half, end});
}

}  // namespace displayfile
