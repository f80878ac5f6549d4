#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "hidden/overlaps.h"
#include "hidden/sort_scene.h"

namespace displayfile {

/// Algorithm 9.8, HIDDEN-SURFACE-CHECK's two steps: the tree of the polygons in a table, and its
/// order, back to front (hidden/bsp.md).
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
    switch (scene_.comparing.compare(test, plane)) {
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
          origin_.push_back(origin_[test]);
          extents_.resize(table_.free());
          extents_[front] = scene_.extent(front);
          extents_[back] = scene_.extent(back);
        }
        link(table_[root].front, front, false);
        link(table_[root].back, back, false);
      }
    }
  }
  void link(Index& list, Index polygon, bool on) {
    (on ? table_[polygon].on : table_[polygon].front) = list;
    list = polygon;
  }

  /// A node that holds no polygon: a plane that divides, or kNoPlane.
  Index add_node(std::uint32_t plane) {
    table_.entries.push_back({0, 0, 0, plane});
    if (overlaps_) {
      origin_.push_back(0);
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
    origin_.resize(table_.free());
    for (Index i = 0; i < table_.free(); ++i) origin_[i] = i;
    list_of_.assign(table_.free(), 0);
    island_.resize(table_.free());
    member_of_.resize(table_.free());
    several_.resize(table_.free());
  }

  Index island_of(Index origin) {
    while (island_[origin] != origin) {
      island_[origin] = island_[island_[origin]];
      origin = island_[origin];
    }
    return origin;
  }

  /// Parts the members into groups that overlap nothing of each other, if there is more than one;
  /// those in no group with another are done.
  bool separate_islands(const Unsorted& task) {
    ++list_;
    for (const Index i : members_) {
      const Index origin = origin_[i];
      several_[origin] = list_of_[origin] == list_ ? 1 : 0;
      list_of_[origin] = list_;
      island_[origin] = origin;
      member_of_[origin] = i;
    }
    for (const Index i : members_) {
      const Index a = origin_[i];
      for (const Index b : overlaps_->with(a)) {
        if (!still_overlaps(i, b)) continue;
        const Index x = island_of(a), y = island_of(b);
        if (x != y) island_[std::max(x, y)] = std::min(x, y);
      }
    }
    by_island_.clear();
    alone_.clear();
    for (const Index i : members_) {
      if (has_company(i)) {
        by_island_.emplace_back(island_of(origin_[i]), i);
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
    for (const Index b : overlaps_->with(origin_[i])) {
      if (still_overlaps(i, b)) return true;
    }
    return false;
  }
  /// Whether a member and what is in the list of an origin that overlapped its own still do.
  bool still_overlaps(Index i, Index origin) const {
    if (list_of_[origin] != list_) return false;
    const Index other = member_of_[origin];
    if ((table_[i].whole && table_[other].whole) || several_[origin] != 0) return true;
    return extents_[i].meets_in_projection(extents_[other]);
  }

  // ---- The choice of a root -------------------------------------------------------------------

  Index choose_root() {
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
    double least = 0.0;
    for (const Index candidate : candidates_) {
      const double cost = cost_of(table_[candidate].plane);
      if (best == kNone || cost < least) {
        best = candidate;
        least = cost;
      }
    }
    if (members_.size() < kFewestToDivide) return best;
    const std::optional<Plane> plane = choose_plane(least);
    return plane ? add_node(scene_.vertices.add_plane(*plane)) : best;
  }

  /// A plane that belongs to no polygon, across one of the axes where the middle of those tested
  /// lies, if it costs less: a tree of the polygons' own planes over a convex surface would be a
  /// chain.
  std::optional<Plane> choose_plane(double least) {
    if (trial_plane_ == kNoPlane) trial_plane_ = scene_.vertices.add_plane(Plane());
    std::optional<Plane> best;
    for (int axis = 0; axis < 3; ++axis) {
      middles_.clear();
      for (const Index i : tested_) {
        middles_.push_back(scene_.vertices.near(table_.vertices(i).front()).first[axis]);
      }
      const auto middle = middles_.begin() + static_cast<std::ptrdiff_t>(middles_.size() / 2);
      std::nth_element(middles_.begin(), middle, middles_.end());
      const Plane plane = across(axis, *middle);
      scene_.vertices.set_plane(trial_plane_, plane);
      const double cost = cost_of(trial_plane_);
      if (cost >= least || !divides()) continue;
      best = plane;
      least = cost;
    }
    return best;
  }
  /// Some lie wholly on either side.
  bool divides() const {
    return std::ranges::find(sides_, PlaneSide::front) != sides_.end() &&
           std::ranges::find(sides_, PlaneSide::back) != sides_.end();
  }
  static Plane across(int axis, double at) {
    Point3 p(0.0), q(0.0), r(0.0);
    p[axis] = q[axis] = r[axis] = at;
    q[(axis + 1) % 3] = 1.0;
    r[(axis + 2) % 3] = 1.0;
    return {p, q, r};
  }

  static constexpr std::size_t kFewestToDivide = 32;
  static constexpr std::size_t kCandidates = 16, kTested = 24;
  /// Evenly spaced ones, so that the choice is the same each time.
  static void thin_out(std::vector<Index>& list, std::size_t most) {
    if (list.size() <= most) return;
    for (std::size_t k = 0; k < most; ++k) list[k] = list[k * list.size() / most];
    list.resize(most);
  }

  /// Some members; where the overlaps are known, members and for each one that it overlaps.
  void choose_tested() {
    tested_ = members_;
    thin_out(tested_, kTested);
    if (!overlaps_) return;
    const std::size_t some = tested_.size();
    for (std::size_t k = 0; k < some; ++k) {
      const auto others = overlaps_->with(origin_[tested_[k]]);
      const auto near_by =
          std::ranges::find_if(others, [&](Index b) { return still_overlaps(tested_[k], b); });
      tested_.push_back(near_by == others.end() ? tested_[k] : member_of_[*near_by]);
    }
  }

  double cost_of(std::uint32_t plane) {
    int front = 0, back = 0, both = 0;
    sides_.clear();
    for (const Index i : tested_) {
      const PlaneSide side = scene_.comparing.compare(i, plane);
      sides_.push_back(side);
      front += side == PlaneSide::front ? 1 : 0;
      back += side == PlaneSide::back ? 1 : 0;
      both += side == PlaneSide::both ? 1 : 0;
    }
    if (!overlaps_) return kCostOfACut * both + std::abs(front - back);
    // What counts is how many that overlap stay together.
    int together = 0;
    const std::size_t some = tested_.size() / 2;
    for (std::size_t k = 0; k < some; ++k) {
      const PlaneSide a = sides_[k], b = sides_[some + k];
      together += (a == b && a != PlaneSide::on) ? 1 : 0;
    }
    return kCostOfACut * both + kCostOfAPair * together;
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
  std::vector<Index> origin_;           // the entry that a piece was cut from
  std::vector<std::uint32_t> list_of_;  // in which list an origin was last seen
  std::uint32_t list_ = 0;
  std::vector<Index> island_, member_of_;  // of an origin: its island, and a piece of it
  std::vector<std::uint8_t> several_;      // whether there are more pieces of it in the list
  std::vector<std::pair<Index, Index>> by_island_;
  std::vector<Index> alone_;

  std::uint32_t trial_plane_ = kNoPlane;
  std::vector<double> middles_;
  std::vector<Index> candidates_, tested_;
  std::vector<PlaneSide> sides_;  // of those tested
};

}  // namespace displayfile
