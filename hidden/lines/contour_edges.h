#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <vector>

#include "hidden/lines/depth_boxes.h"
#include "hidden/lines/line_table.h"
#include "hidden/lines/side_table.h"

namespace displayfile {

/// The polygons that Appel's method counts, and the edges where the count changes
/// (hidden/lines/appel.md). Counted are polygons that hide and do not cross or touch themselves, so
/// that each side has the inside on one side all along.
class ContourEdges {
 public:
  ContourEdges(const LineTable& scene, const Primitives& items, const SideTable& sides,
               int threads);

  /// 1 if the polygon is counted and runs counterclockwise, -1 if clockwise, 0 if it is not
  /// counted.
  int way(std::uint32_t item) const {
    assert(item < way_.size());
    return way_[item];
  }
  /// True if a counted polygon has all its corners on its support plane.
  bool is_even(std::uint32_t item) const { return uneven_.empty() || uneven_[item] == 0; }

  /// A side from p to q with more polygons on its left than on its right, in the projection, summed
  /// over all counted polygons with this side.
  struct Edge {
    Point3 p, q;
    std::int32_t more_on_left;  ///< not 0
  };
  /// Calls visit(edge) for edges whose boxes in the projection meet the given one and that are not
  /// behind it, until it returns true: then returns true.
  template <class Visit>
  bool any(const Extent& box, const Visit& visit) const {
    Extent before = box;
    before.z_max = std::numeric_limits<float>::infinity();
    return tree_.any([&](const DepthBoxes& boxes) { return boxes.meets(before); },
                     [&](DepthTree::Position position) { return visit(edges_[position]); });
  }
  std::size_t size() const { return edges_.size(); }

  /// The properties that are equal on both sides of a side that is not a contour: the number of
  /// polygons and their depth there; or the number only, with depths within step().
  enum class Of : std::uint8_t { depth, cover };
  /// False only if, at each side of a polygon that hides, there are equally many polygons on the
  /// left and on the right.
  bool has_contour(std::uint32_t item, Of of) const {
    return has_contour_[item] > (of == Of::depth ? 0 : kOfDepth);
  }
  /// Calls visit with the corner at which each such side ends, until it returns true: then returns
  /// true. All sides of a polygon that is not counted are contours.
  template <class Visit>
  bool any_contour(std::uint32_t item, std::uint32_t sides, Of of, const Visit& visit) const {
    if (way_[item] == 0 || is_uneven(item, of)) {
      for (std::uint32_t k = 0; k < sides; ++k) {
        if (visit(k)) return true;
      }
      return false;
    }
    const auto& names = of == Of::cover && !uneven_.empty() ? cover_sides_ : contour_sides_;
    auto at = std::ranges::lower_bound(names, LineName{item, 0});
    for (; at != names.end() && at->item == item; ++at) {
      if (visit(at->corner)) return true;
    }
    return false;
  }
  /// The maximum difference of depths of uneven polygons at a side that is not a contour of the
  /// cover; 0 if all polygons are even.
  double step() const { return step_; }

 private:
  static constexpr std::uint8_t kOfDepth = 1, kOfCover = 2;
  bool is_uneven(std::uint32_t item, Of of) const {
    return !uneven_.empty() && uneven_[item] > (of == Of::depth ? 0 : kOfDepth);
  }

  std::vector<std::int8_t> way_;
  std::vector<std::uint8_t> uneven_;  // kOfCover: by more than half of the step; empty: none
  std::vector<Edge> edges_;           // by position in the tree
  std::vector<std::uint8_t> has_contour_;
  std::vector<LineName> contour_sides_;  // in order
  std::vector<LineName> cover_sides_;    // those of the cover, unless all polygons are even
  double step_ = 0.0;
  DepthTree tree_;
};

}  // namespace displayfile
