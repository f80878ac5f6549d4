#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "hidden/sort/islands.h"
#include "hidden/sort/sort_tables.h"

namespace displayfile {

/// The root of a tree: a polygon's entry, or kNone and a plane that belongs to no polygon, which is
/// kNoPlane if the members need no order.
struct Root {
  PolygonTable::Index entry;
  std::uint32_t plane;
};

/// Chooses the roots of algorithm 9.9 (hidden/sort/bsp.md, "The choice of a root").
template <class Policy>
class RootChooser {
 public:
  using Index = PolygonTable::Index;

  /// The arguments must outlive this; the islands may be set until the first choice.
  RootChooser(SortTables<Policy>& scene, const std::optional<Islands<Policy>>& islands,
              RootChoice choice)
      : scene_(scene), table_(scene.table), islands_(islands), choice_(choice) {}

  /// The root for a list of members, which must be the one last separated if islands are known.
  Root choose(std::span<const Index> members) {
    assert(!members.empty());
    across_.reset();
    if (choice_ == RootChoice::last) return last_with_plane(members);
    if (choice_ == RootChoice::first) return first_with_plane(members);
    candidates_.clear();
    for (const Index i : members) {
      if (scene_.hides(i)) candidates_.push_back(i);
    }
    if (candidates_.empty()) return {kNone, kNoPlane};  // members that hide nothing need no order
    thin_out(candidates_, kCandidates);
    choose_tested(members);
    Root best{kNone, kNoPlane};
    double least = std::numeric_limits<double>::infinity();
    for (const Index candidate : candidates_) {
      const double cost = cost_of(table_[candidate].plane, least);
      if (cost < least) {
        best.entry = candidate;
        least = cost;
      }
    }
    assert(best.entry != kNone);
    if (members.size() < kFewestToDivide) return best;
    across_ = choose_plane(least);
    return across_ ? Root{kNone, scene_.vertices.add_plane(across_->plane())} : best;
  }

  /// COMPARE-POLYS with the plane of the root last chosen; for an axis-aligned plane the extents
  /// usually decide.
  PlaneSide compare(Index test, std::uint32_t plane) {
    if (across_ && islands_) {
      const Extent& box = islands_->extent(test);
      if (box.low(across_->axis) > across_->at + across_->tolerance) return PlaneSide::front;
      if (box.high(across_->axis) < across_->at - across_->tolerance) return PlaneSide::back;
    }
    return scene_.comparing.compare(test, plane);
  }

 private:
  static constexpr Index kNone = PolygonTable::kNone;
  Root last_with_plane(std::span<const Index> members) const {
    for (const Index i : members) {
      if (table_[i].plane != kNoPlane) return {i, kNoPlane};
    }
    return {kNone, kNoPlane};
  }

  Root first_with_plane(std::span<const Index> members) const {
    Root first{kNone, kNoPlane};
    for (const Index i : members) {
      if (table_[i].plane == kNoPlane) continue;
      if (first.entry == kNone || table_[i].item < table_[first.entry].item) first.entry = i;
    }
    return first;
  }

  /// A plane perpendicular to an axis; its front is toward larger coordinates.
  struct Across {
    int axis;
    double at;
    double tolerance;  ///< vertices within this distance count as on it

    Plane plane() const {
      Point3 p(0.0), q(0.0), r(0.0);
      p[axis] = q[axis] = r[axis] = at;
      q[(axis + 1) % 3] = 1.0;
      r[(axis + 2) % 3] = 1.0;
      return {p, q, r};
    }
  };

  /// A plane that belongs to no polygon, perpendicular to an axis at the middle of those tested, if
  /// it costs less: a tree of the polygons' own planes over a convex surface would be a chain.
  std::optional<Across> choose_plane(double least) {
    if (trial_plane_ == kNoPlane) trial_plane_ = scene_.vertices.add_plane(Plane());
    std::optional<Across> best;
    for (int axis = 0; axis < 3; ++axis) {
      middles_.clear();
      for (const Index i : tested_) {
        middles_.push_back(scene_.vertices.near(table_.vertices(i).front()).p[axis]);
      }
      const auto middle = middles_.begin() + static_cast<std::ptrdiff_t>(middles_.size() / 2);
      std::nth_element(middles_.begin(), middle, middles_.end());
      across_ = {axis, *middle, scene_.vertices.tolerance()};
      scene_.vertices.set_plane(trial_plane_, across_->plane());
      const double cost = cost_of(trial_plane_, least);
      if (cost >= least || !(divides_[0] && divides_[1])) continue;
      best = across_;
      least = cost;
    }
    return best;
  }
  static constexpr std::size_t kFewestToDivide = 32;
  static constexpr std::size_t kCandidates = 16, kTested = 24;
  /// Keeps evenly spaced ones, so that the choice is deterministic.
  static void thin_out(std::vector<Index>& list, std::size_t most) {
    if (list.size() <= most) return;
    for (std::size_t k = 0; k < most; ++k) list[k] = list[k * list.size() / most];
    list.resize(most);
  }

  /// Some members; where the overlaps are known, each followed by one that it overlaps.
  void choose_tested(std::span<const Index> members) {
    tested_.assign(members.begin(), members.end());
    thin_out(tested_, kTested);
    if (!islands_) return;
    const std::vector<Index> some = tested_;
    tested_.clear();
    for (const Index i : some) {
      tested_.push_back(i);
      tested_.push_back(islands_->one_that_overlaps(i));
    }
  }

  /// The cost of dividing by the plane, from the tested members; any value not below `least` if it
  /// is not less.
  double cost_of(std::uint32_t plane, double least) {
    return islands_ ? cost_by_pairs(plane, least) : cost_by_balance(plane, least);
  }
  /// Counts the overlapping pairs that stay together.
  double cost_by_pairs(std::uint32_t plane, double least) {
    assert(tested_.size() % 2 == 0);
    divides_.fill(false);
    double cost = 0.0;
    for (std::size_t k = 0; k < tested_.size() && cost < least; k += 2) {
      const PlaneSide a = tested_side(tested_[k], plane), b = tested_side(tested_[k + 1], plane);
      if (a == PlaneSide::both) cost += kCostOfACut;
      if (b == PlaneSide::both) cost += kCostOfACut;
      if (a == b && a != PlaneSide::on) cost += kCostOfAPair;
    }
    return cost;
  }
  double cost_by_balance(std::uint32_t plane, double least) {
    divides_.fill(false);
    int front = 0, back = 0;
    double cuts = 0.0;
    for (std::size_t k = 0; k < tested_.size() && cuts < least; ++k) {
      const PlaneSide side = tested_side(tested_[k], plane);
      front += side == PlaneSide::front ? 1 : 0;
      back += side == PlaneSide::back ? 1 : 0;
      cuts += side == PlaneSide::both ? kCostOfACut : 0.0;
    }
    return cuts + std::abs(front - back);
  }
  PlaneSide tested_side(Index i, std::uint32_t plane) {
    const PlaneSide side = compare(i, plane);
    divides_[0] = divides_[0] || side == PlaneSide::front;
    divides_[1] = divides_[1] || side == PlaneSide::back;
    return side;
  }
  static constexpr double kCostOfACut = 8.0, kCostOfAPair = 4.0;

  SortTables<Policy>& scene_;
  PolygonTable& table_;
  const std::optional<Islands<Policy>>& islands_;
  RootChoice choice_;

  std::uint32_t trial_plane_ = kNoPlane;
  std::optional<Across> across_;  // the current plane, if it is one
  std::vector<double> middles_;
  std::vector<Index> candidates_, tested_;
  std::array<bool, 2> divides_{};  // whether some tested ones are in front, and in back
};

}  // namespace displayfile
