#include "interp/steps/step_box_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace displayfile {

StepBoxTree::StepBoxTree(const StepItems& scene)
    : depths_(scene.viewed(), scene.size(), {}), fill_of_(scene.polygons()) {
  std::vector<DeepPixelBox> boxes;
  for (Fill fill = 1; fill < scene.viewed().end(); ++fill) {
    const Polygon polygon = scene.viewed().item_of(fill);
    fill_of_[polygon] = fill;
    const PixelBox pixels = extents_of(scene.viewed().vertices(fill), scene.size());
    if (pixels.empty()) continue;
    targets_.push_back({fill, polygon, pixels});
    boxes.push_back({pixels, nearest_in(fill, pixels)});
  }
  tree_.build(boxes, 1);
  number_nodes();
}

/// An upper bound of the fill's depth over these pixels.
float StepBoxTree::nearest_in(Fill fill, const PixelBox& pixels) const {
  double z = -std::numeric_limits<double>::infinity();
  for (const int row : {pixels.first_row, pixels.end_row - 1}) {
    for (const int column : {pixels.first_column, pixels.end_column - 1}) {
      z = std::max(z, depths_.at(fill, column, row));
    }
  }
  z += 4.0 * depths_.error(fill);
  constexpr double kLargest = std::numeric_limits<float>::max();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (!(z < kLargest)) return kInfinity;
  return std::nextafter(static_cast<float>(std::max(z, -kLargest)), kInfinity);
}

/// Visits all nodes of the tree; a branch is visited before the node to which it leads.
void StepBoxTree::number_nodes() {
  std::optional<Branch> branch;
  const auto add = [&](std::optional<Polygon> polygon) {
    const int node = static_cast<int>(nodes_.size());
    nodes_.push_back({branch ? number_of_[branch->node] : -1,
                      branch ? static_cast<int>(branch->place) : 0, polygon});
    if (branch) under_[{branch->node, branch->place}] = node;
    return node;
  };
  const auto meets = [&](const PixelBoxes& boxes, Branches& nearest) {
    number_of_[&boxes] = add(std::nullopt);
    for (std::size_t k = 0; k < nearest.size(); ++k) nearest[k] = {0.0F, &boxes, k};
    PixelTree::Lanes all;
    all.fill(1);
    return all;
  };
  const auto hidden = [&](const Branch& next) {
    branch = next;
    return false;
  };
  near_to_far(meets, hidden, [&](const Target& target) { add(target.polygon); });
}

std::vector<StepBoxTree::Branch> StepBoxTree::met_by(const PixelBox& ray, const PixelBoxes& boxes,
                                                     PixelTree::Lanes& met,
                                                     Branches& nearest) const {
  met = boxes.meets(ray);
  std::vector<Branch> branches;
  for (std::size_t k = 0; k < met.size(); ++k) {
    nearest[k] = {boxes.nearest[k], &boxes, k};
    if (met[k] != 0 && under_.contains({&boxes, k})) branches.push_back(nearest[k]);
  }
  std::ranges::stable_sort(branches, [](const Branch& a, const Branch& b) { return b > a; });
  return branches;
}

bool StepBoxTree::is_behind(float nearest, Polygon polygon, int column, int row) const {
  const Fill fill = fill_of_[polygon];
  return nearest < depths_.at(fill, column, row) - 4.0 * depths_.error(fill);
}

}  // namespace displayfile
