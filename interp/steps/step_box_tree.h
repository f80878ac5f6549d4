#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "interp/steps/step_items.h"
#include "interp/visibility/fill_depths.h"
#include "interp/visibility/pixel_tree.h"

namespace displayfile {

/// The tree of boxes that the system casts rays through (interp/visibility/ray_cast.md), of a
/// scene's fills, with a number for each of its nodes and for each polygon in it.
class StepBoxTree {
 public:
  using Polygon = StepItems::Polygon;
  using Fill = ViewedScene::Fill;

  explicit StepBoxTree(const StepItems& scene);

  struct Target {
    Fill fill;
    Polygon polygon;
    PixelBox pixels;
  };
  /// The polygons that have pixels, in order of entry.
  const std::vector<Target>& targets() const { return targets_; }

  /// A node, or a polygon under one; nodes come before what is under them.
  struct Node {
    int parent;  ///< -1 of the root
    int branch;
    std::optional<Polygon> polygon;
  };
  const std::vector<Node>& nodes() const { return nodes_; }

  /// A branch of a node: its place there, and the nearest depth in it.
  struct Branch {
    float nearest;
    const PixelBoxes* node;
    std::size_t place;
    bool operator>(const Branch& other) const { return nearest > other.nearest; }
  };
  using Branches = std::array<Branch, PixelBoxes::kBoxes>;
  /// The number of the node with these boxes, or of the target of a branch.
  int number(const PixelBoxes& boxes) const { return number_of_.at(&boxes); }
  int number(const Branch& branch) const { return under_.at({branch.node, branch.place}); }
  /// The branches of a node that a ray meets, the nearest last; writes the nearest depths of all
  /// branches.
  std::vector<Branch> met_by(const PixelBox& ray, const PixelBoxes& boxes, PixelTree::Lanes& met,
                             Branches& nearest) const;
  /// True only if everything beginning there is behind the polygon at the centre of a pixel that it
  /// covers.
  bool is_behind(float nearest, Polygon polygon, int column, int row) const;

  /// As BoxTree::near_to_far, except for visit(target).
  template <class Meets, class Hidden, class Visit>
  void near_to_far(const Meets& meets, Hidden&& hidden, Visit&& visit) const {
    tree_.near_to_far<Branch>(meets, hidden, [&](PixelTree::Position position) {
      visit(targets_[tree_.order()[position]]);
    });
  }

 private:
  float nearest_in(Fill fill, const PixelBox& pixels) const;
  void number_nodes();

  FillDepths depths_;
  std::vector<Target> targets_;
  std::vector<Fill> fill_of_;  // of each polygon
  PixelTree tree_;
  std::vector<Node> nodes_;
  std::map<const PixelBoxes*, int> number_of_;
  std::map<std::pair<const PixelBoxes*, std::size_t>, int> under_;
};

}  // namespace displayfile
