#pragma once

#include <algorithm>
#include <cassert>
#include <optional>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "hidden/sort/choose_root.h"
#include "hidden/sort/islands.h"
#include "hidden/sort/sort_tables.h"

namespace displayfile {

/// Algorithm 9.8, HIDDEN-SURFACE-CHECK's two steps: the tree of the polygons in a table, and its
/// order, back to front (hidden/sort/bsp.md).
template <class Policy>
class SortPolygons {
 public:
  using Index = PolygonTable::Index;

  /// The scene and the plan must outlive this.
  SortPolygons(SortTables<Policy>& scene, const SurfacePlan& plan)
      : scene_(scene), table_(scene.table), plan_(plan), roots_(scene, islands_, plan.root) {}

  SortPolygons(const SortPolygons&) = delete;  // its parts know each other by reference
  SortPolygons& operator=(const SortPolygons&) = delete;

  /// Sorts all entries of the table.
  void sort_all() {
    Index list = kNone;
    for (Index i = 0; i < table_.free(); ++i) {
      if (table_[i].sides > 0) link(list, i, false);
    }
    if (plan_.root == RootChoice::free) islands_ = Islands<Policy>::find(scene_, plan_.threads);
    hidden_surface_check(list);
    assert(order_.size() == number_of_polygons());
  }
  /// Sorts these entries only.
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

  /// Includes pieces of polygons, in the whole table.
  std::size_t number_of_polygons() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        table_.entries, [](const PolygonTable::Entry& entry) { return entry.sides > 0; }));
  }

  /// Algorithm 9.8.
  void hidden_surface_check(Index list) {
    sort_polygons(list);
    save_polygons_in_order();
  }

  enum class Branch : std::uint8_t { tree, front, back };
  /// A list of polygons, and the place in the tree of the node made from it.
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
      if (islands_ && separate_islands(task)) continue;
      const Root chosen = roots_.choose(members_);
      const Index root = chosen.entry != kNone ? chosen.entry : add_node(chosen.plane);
      attach(task, root);
      steps_.step(members_.size());
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

  /// The end of algorithm 9.10: links the polygon, or each half of it, to the root.
  void compare_polys(Index root, Index test) {
    assert(root != test);
    const std::uint32_t plane = table_[root].plane;
    if (plane == kNoPlane) return link(table_[root].on, test, true);
    switch (roots_.compare(test, plane)) {
      case PlaneSide::on:
        // Seen from the front, a line is drawn after polygons that touch it from behind; it is
        // compared again with those that touch it from the front.
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
        if (islands_) islands_->add_cut(test, front, back);
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
    if (islands_) islands_->add_node();
    return table_.free() - 1;
  }

  // ---- Islands --------------------------------------------------------------------------------

  /// True if the members are separate islands or singletons, which are sorted separately.
  bool separate_islands(const Unsorted& task) {
    if (!islands_->separate(members_)) return false;
    // One node holds all singletons; a chain of nodes hangs from it, one for each island.
    const Index node = add_node(kNoPlane);
    attach(task, node);
    for (const Index i : islands_->alone()) link(table_[node].on, i, true);
    Index chain = node;
    islands_->for_each([&](auto island) {
      if (island.size() == 1) return link(table_[node].on, island[0].second, true);
      Index list = kNone;
      for (const auto& [name, member] : island) link(list, member, false);
      const Index top = add_node(kNoPlane);
      table_[chain].front = top;
      chain = top;
      unsorted_.push_back({list, top, Branch::back, task.depth + 1});
    });
    return true;
  }

  // ---- The order ------------------------------------------------------------------------------

  /// Algorithm 9.16: everything in back of the root, the root, everything in front. Its recursion
  /// is a stack of nodes whose back is done.
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

  /// Saves the root and the polygons in its plane, in order of entry.
  void save_plane(Index root) {
    const std::size_t first = order_.size();
    if (table_[root].sides > 0) order_.push_back(root);
    for (Index i = table_[root].on; i != kNone; i = table_[i].on) order_.push_back(i);
    std::ranges::sort(order_.begin() + static_cast<std::ptrdiff_t>(first), order_.end(),
                      [&](Index a, Index b) { return scene_.entered_before(a, b); });
  }

  SortTables<Policy>& scene_;
  PolygonTable& table_;
  const SurfacePlan& plan_;

  std::vector<Unsorted> unsorted_;
  std::vector<Index> members_;  // of the list being sorted
  Index tree_ = kNone;
  std::uint32_t depth_ = 0;
  std::vector<Index> order_;

  std::optional<Islands<Policy>> islands_;
  RootChooser<Policy> roots_;
  WorkSteps steps_;
};

}  // namespace displayfile
