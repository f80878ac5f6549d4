#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "hidden/sort/overlaps.h"
#include "hidden/sort/sort_scene.h"

namespace displayfile {

/// Algorithm 9.8, HIDDEN-SURFACE-CHECK's two steps: the tree of the polygons in a table, and its
/// order, back to front (hidden/sort/bsp.md).
template <class Policy>
class SortPolygons {
 public:
  using Index = PolygonTable::Index;

  /// The scene and the options must stay.
  SortPolygons(SortScene<Policy>& scene, const SortOptions& options)
      : scene_(scene), table_(scene.table), options_(options) {}

  /// All entries of the table.
  void sort_all() {
    Index list = kNone;
    for (Index i = 0; i < table_.free(); ++i) {
      if (table_[i].sides > 0) link(list, i, false);
    }
    if (options_.root == RootChoice::free) find_overlaps();
    hidden_surface_check(list);
  }
  /// These entries only.
  void sort(std::span<const Index> polygons) {
    Index list = kNone;
    for (const Index i : polygons) link(list, i, false);
    hidden_surface_check(list);
  }

  std::span<const Index> order() const { return order_; }
  Index root() const { return tree_; }  ///< of the tree in the table
  std::uint32_t depth() const { return depth_; }

 private:
  static constexpr Index kNone = PolygonTable::kNone;

  /// Algorithm 9.8.
  void hidden_surface_check(Index list) {
    sort_polygons(list);
    save_polygons_in_order();
  }

  enum class Branch : std::uint8_t { tree, front, back };
  /// A list of polygons, and where in the tree the node made of it belongs.
  struct Unsorted {
    Index list, parent;
    Branch branch;
    std::uint32_t depth;
  };

  /// Algorithm 9.9. Its recursion is a stack of lists still to be sorted.
  void sort_polygons(Index list) {
    unsorted_.push_back({list, kNone, Branch::tree, 1});
    while (!unsorted_.empty()) {
      const Unsorted task = unsorted_.back();
      unsorted_.pop_back();
      if (task.list == kNone) continue;
      depth_ = std::max(depth_, task.depth);
      gather(task.list);
      if (overlaps_ && separate_islands(task)) continue;
      const Index root = choose_root();
      attach(task, root);
      for (const Index test : members_) {
        if (test != root) compare_polys(root, test);
      }
      const Index front = table_[root].front, back = table_[root].back;
      table_[root].front = table_[root].back = kNone;
      unsorted_.push_back({back, root, Branch::back, task.depth + 1});
      unsorted_.push_back({front, root, Branch::front, task.depth + 1});
    }
  }

  void gather(Index list) {
    members_.clear();
    for (Index i = list; i != kNone; i = table_[i].front) members_.push_back(i);
  }

  void attach(const Unsorted& task, Index node) {
    table_[node].front = table_[node].back = kNone;
    switch (task.branch) {
      case Branch::tree: tree_ = node; break;
      case Branch::front: table_[task.parent].front = node; break;
      case Branch::back: table_[task.parent].back = node; break;
    }
  }

  /// The end of algorithm 9.10: hangs the polygon, or each half of it, on the root.
  void compare_polys(Index root, Index test) {
    const std::uint32_t plane = table_[root].plane;
    if (plane == kNoPlane) return link(table_[root].on, test, true);
    switch (compare(test, plane)) {
      case PlaneSide::on:
        // Seen from the front, a line is drawn after what touches it from behind; what touches it
        // from the front it meets again.
        if (table_[test].sides == 2 && scene_.space == SortSpace::device) {
          link(table_[root].front, test, false);
        } else {
          link(table_[root].on, test, true);
        }
        break;
      case PlaneSide::front: link(table_[root].front, test, false); break;
      case PlaneSide::back: link(table_[root].back, test, false); break;
      case PlaneSide::both: {
        const auto [front, back] = scene_.comparing.split(test, plane);
        if (overlaps_) {
          origin_of_.push_back(origin_of_[test]);
          extents_.resize(table_.free());
          extents_[front] = scene_.extent(front);
          extents_[back] = scene_.extent(back);
        }
        link(table_[root].front, front, false);
        link(table_[root].back, back, false);
      }
    }
  }
  /// Against a plane across an axis the extents mostly decide.
  PlaneSide compare(Index test, std::uint32_t plane) {
    if (across_ && overlaps_) {
      const Extent& box = extents_[test];
      if (box.low(across_->axis) > across_->at + across_->tolerance) return PlaneSide::front;
      if (box.high(across_->axis) < across_->at - across_->tolerance) return PlaneSide::back;
    }
    return scene_.comparing.compare(test, plane);
  }
  void link(Index& list, Index polygon, bool on) {
    (on ? table_[polygon].on : table_[polygon].front) = list;
    list = polygon;
  }

  /// A node that holds no polygon: a plane that divides, or kNoPlane.
  Index add_node(std::uint32_t plane) {
    table_.entries.push_back({0, 0, 0, plane});
    if (overlaps_) {
      origin_of_.push_back(0);
      extents_.push_back(Extent::nothing());
    }
    return table_.free() - 1;
  }

  // ---- Islands: polygons that overlap no others need not be compared with them --------------

  void find_overlaps() {
    const std::size_t most = 64 * std::size_t{table_.free()} + 4096;
    auto [extents, pairs] = overlapping_pairs(scene_, most, options_.threads);
    if (!pairs) return;
    extents_ = std::move(extents);
    overlaps_.emplace(std::move(*pairs), table_.free());
    origin_of_.resize(table_.free());
    for (Index i = 0; i < table_.free(); ++i) origin_of_[i] = i;
    origins_.resize(table_.free());
  }

  Index island_of(Index origin) {
    while (origins_[origin].island != origin) {
      Index& island = origins_[origin].island;
      island = origins_[island].island;
      origin = island;
    }
    return origin;
  }

  /// Parts the members into groups that overlap nothing of each other, if there is more than one;
  /// those in no group with another are done.
  bool separate_islands(const Unsorted& task) {
    ++list_;
    for (const Index i : members_) {
      Origin& origin = origins_[origin_of_[i]];
      origin = {list_, origin_of_[i], i, origin.list == list_, false};
    }
    for (const Index i : members_) {
      const Index a = origin_of_[i];
      for (const Index b : overlaps_->with(a)) {
        if (b < a || !still_overlaps(i, b)) continue;  // each pair once
        origins_[a].has_company = origins_[b].has_company = true;
        const Index x = island_of(a), y = island_of(b);
        if (x != y) origins_[std::max(x, y)].island = std::min(x, y);
      }
    }
    by_island_.clear();
    alone_.clear();
    for (const Index i : members_) {
      if (has_company(i)) {
        by_island_.emplace_back(island_of(origin_of_[i]), i);
      } else {
        alone_.push_back(i);
      }
    }
    std::ranges::sort(by_island_);
    const bool one_island =
        !by_island_.empty() && by_island_.front().first == by_island_.back().first;
    if (one_island && alone_.empty() && by_island_.size() > 1) return false;
    // One node holds all that are alone; from it hangs a chain of nodes, one for each island.
    const Index node = add_node(kNoPlane);
    attach(task, node);
    for (const Index i : alone_) link(table_[node].on, i, true);
    Index chain = node;
    for (std::size_t first = 0; first < by_island_.size();) {
      std::size_t end = first;
      Index list = kNone;
      for (; end < by_island_.size() && by_island_[end].first == by_island_[first].first; ++end) {
        link(list, by_island_[end].second, false);
      }
      if (end - first == 1) {
        link(table_[node].on, by_island_[first].second, true);
      } else {
        const Index island = add_node(kNoPlane);
        table_[chain].front = island;
        chain = island;
        unsorted_.push_back({list, island, Branch::back, task.depth + 1});
      }
      first = end;
    }
    return true;
  }
  bool has_company(Index i) const {
    const Origin& origin = origins_[origin_of_[i]];
    if (!origin.has_company || !origin.several) return origin.has_company;
    for (const Index b : overlaps_->with(origin_of_[i])) {
      if (still_overlaps(i, b)) return true;
    }
    return false;
  }
  /// Whether a member and what is in the list of an origin that overlapped its own still do.
  bool still_overlaps(Index i, Index origin) const {
    const Origin& its = origins_[origin];
    if (its.list != list_) return false;
    if (its.several || (table_[i].whole && table_[its.member].whole)) return true;
    return extents_[i].meets_in_projection(extents_[its.member]);
  }

  // ---- The choice of a root -------------------------------------------------------------------

  Index choose_root() {
    across_.reset();
    if (options_.root == RootChoice::last) {
      for (const Index i : members_) {
        if (table_[i].plane != kNoPlane) return i;
      }
      return add_node(kNoPlane);
    }
    candidates_.clear();
    for (const Index i : members_) {
      if (scene_.hides(i)) candidates_.push_back(i);
    }
    if (candidates_.empty()) return add_node(kNoPlane);  // what hides nothing needs no order
    thin_out(candidates_, kCandidates);
    choose_tested();
    Index best = kNone;
    double least = std::numeric_limits<double>::infinity();
    for (const Index candidate : candidates_) {
      const double cost = cost_of(table_[candidate].plane, least);
      if (cost < least) {
        best = candidate;
        least = cost;
      }
    }
    if (members_.size() < kFewestToDivide) return best;
    across_ = choose_plane(least);
    return across_ ? add_node(scene_.vertices.add_plane(across_->plane())) : best;
  }

  /// A plane across an axis; its front is where the coordinate is larger.
  struct Across {
    int axis;
    double at;
    double tolerance;  ///< no vertex farther than this from it counts as on it

    Plane plane() const {
      Point3 p(0.0), q(0.0), r(0.0);
      p[axis] = q[axis] = r[axis] = at;
      q[(axis + 1) % 3] = 1.0;
      r[(axis + 2) % 3] = 1.0;
      return {p, q, r};
    }
  };

  /// A plane that belongs to no polygon, across one of the axes where the middle of those tested
  /// lies, if it costs less: a tree of the polygons' own planes over a convex surface would be a
  /// chain.
  std::optional<Across> choose_plane(double least) {
    if (trial_plane_ == kNoPlane) trial_plane_ = scene_.vertices.add_plane(Plane());
    std::optional<Across> best;
    for (int axis = 0; axis < 3; ++axis) {
      middles_.clear();
      for (const Index i : tested_) {
        middles_.push_back(scene_.vertices.near(table_.vertices(i).front()).first[axis]);
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
  /// Evenly spaced ones, so that the choice is the same each time.
  static void thin_out(std::vector<Index>& list, std::size_t most) {
    if (list.size() <= most) return;
    for (std::size_t k = 0; k < most; ++k) list[k] = list[k * list.size() / most];
    list.resize(most);
  }

  /// Some members; where the overlaps are known, each followed by one that it overlaps.
  void choose_tested() {
    tested_ = members_;
    thin_out(tested_, kTested);
    if (!overlaps_) return;
    const std::vector<Index> some = tested_;
    tested_.clear();
    for (const Index i : some) {
      const auto others = overlaps_->with(origin_of_[i]);
      const auto near_by =
          std::ranges::find_if(others, [&](Index b) { return still_overlaps(i, b); });
      tested_.push_back(i);
      tested_.push_back(near_by == others.end() ? i : origins_[*near_by].member);
    }
  }

  /// What dividing by the plane would cost, by the members that are tested; anything not less than
  /// `least` if it is not.
  double cost_of(std::uint32_t plane, double least) {
    return overlaps_ ? cost_by_pairs(plane, least) : cost_by_balance(plane, least);
  }
  /// What counts is how many that overlap stay together.
  double cost_by_pairs(std::uint32_t plane, double least) {
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

  // ---- The order ------------------------------------------------------------------------------

  /// Algorithm 9.16: what is in back of the root, the root, what is in front. Its recursion is a
  /// stack of nodes of which the back is done.
  void save_polygons_in_order() {
    std::vector<Index> path;
    Index node = tree_;
    while (node != kNone || !path.empty()) {
      for (; node != kNone; node = table_[node].back) path.push_back(node);
      node = path.back();
      path.pop_back();
      save_plane(node);
      node = table_[node].front;
    }
  }

  /// The root and what lies in its plane, in order of entry.
  void save_plane(Index root) {
    const std::size_t first = order_.size();
    if (table_[root].sides > 0) order_.push_back(root);
    for (Index i = table_[root].on; i != kNone; i = table_[i].on) order_.push_back(i);
    std::sort(order_.begin() + static_cast<std::ptrdiff_t>(first), order_.end(),
              [&](Index a, Index b) { return scene_.entered_before(a, b); });
  }

  SortScene<Policy>& scene_;
  PolygonTable& table_;
  const SortOptions& options_;

  std::vector<Unsorted> unsorted_;
  std::vector<Index> members_;  // of the list being sorted
  Index tree_ = kNone;
  std::uint32_t depth_ = 0;
  std::vector<Index> order_;

  std::optional<Overlaps> overlaps_;
  std::vector<Extent> extents_;
  std::vector<Index> origin_of_;  // the entry that a piece was cut from
  struct Origin {
    std::uint32_t list = 0;  // in which it was last seen
    Index island = 0;
    Index member = 0;      // a piece of it in the list
    bool several = false;  // there are more
    bool has_company = false;
  };
  std::vector<Origin> origins_;
  std::uint32_t list_ = 0;
  std::vector<std::pair<Index, Index>> by_island_;
  std::vector<Index> alone_;

  std::uint32_t trial_plane_ = kNoPlane;
  std::optional<Across> across_;  // the plane compared with, if it is one
  std::vector<double> middles_;
  std::vector<Index> candidates_, tested_;
  std::array<bool, 2> divides_{};  // whether some of those tested lie in front, and in back
};

}  // namespace displayfile
