#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "clip/base/work_budget.h"
#include "hidden/sort/compare_polys.h"
#include "hidden/sort/polygon_table.h"
#include "hidden/sort/sort_tables.h"

namespace displayfile {

/// Null observer of PlainBsp, with the required members.
struct UnobservedBsp {
  using Index = PolygonTable::Index;
  static void begin_root(Index /*root*/, Index /*parent*/, bool /*in_front*/) {}
  static void compared(Index /*root*/, Index /*test*/, PlaneSide /*side*/) {}  ///< not linked yet
  /// Cut into halves, not linked yet; the table has one of them in its place.
  static void cut(Index /*root*/, Index /*test*/, Index /*front*/, Index /*back*/) {}
  static void kept(Index /*root*/) {}  ///< another one in the root's plane
  static void linked() {}              ///< the compared one, or its halves
  static void end_root(Index /*root*/) {}
  static void begin_walk(Index /*root*/) {}
  static void behind(Index /*root*/, Index /*back*/) {}
  static void paint(Index /*root*/, const std::vector<Index>& /*in_plane*/) {}
  static void before(Index /*root*/, Index /*front*/) {}
};

/// The binary space partition in its textbook form, for reading, for the step display, and as the
/// reference of the fast form (SortPolygons, hidden/sort/bsp.md): SORT-POLYGONS (algorithm 9.9),
/// the end of COMPARE-POLYS (9.10) and SAVE-POLYGONS-IN-ORDER (9.16), with stacks instead of
/// recursion. The polygon entered last is the root. One in the root's own plane is kept with the
/// root, where the chapter puts it in front, so that equally near ones stay in order of entry.
///
/// Comparing is COMPARE-POLYS over the scene's tables, which must outlive this, as must the
/// observer.
template <class Policy, class Observer = UnobservedBsp, class Comparing = ComparePolys<Policy>>
class PlainBsp {
 public:
  using Index = PolygonTable::Index;
  static constexpr Index kNone = PolygonTable::kNone;
  /// The textbook links each polygon at the front of a list: its first is the last here.
  using List = std::vector<Index>;

  PlainBsp(SortTables<Policy>& scene, Comparing& comparing, Observer& observer)
      : scene_(scene), table_(scene.table), comparing_(comparing), observer_(observer) {}

  /// Algorithm 9.8, HIDDEN-SURFACE-CHECK's two steps, of all entries of the table.
  void sort_all() {
    List all;
    for (Index i = 0; i < table_.free(); ++i) {
      if (table_[i].sides > 0) all.push_back(i);
    }
    waiting_.push_back({std::move(all), kNone, false, 1});
    while (!waiting_.empty()) sort_polygons();
    save_polygons_in_order();
  }

  std::span<const Index> order() const { return order_; }  ///< back to front
  std::uint32_t depth() const { return depth_; }           ///< of the tree

  /// A list on a branch of a node.
  struct Branch {
    List list;
    Index parent;
    bool in_front;
    std::uint32_t depth;
  };
  // State for observers: the lists still to be sorted, the last first; the rest of the list being
  // sorted, and the two into which it is sorted.
  std::span<const Branch> waiting() const { return waiting_; }
  const List& rest() const { return rest_; }
  const List& front() const { return front_; }
  const List& back() const { return back_; }

  /// The root and the polygons in its plane, in order of entry.
  List in_plane_of(Index root) const {
    List all;
    for (Index i = root; i != kNone; i = table_[i].on) all.push_back(i);
    std::ranges::sort(all, [&](Index a, Index b) { return scene_.entered_before(a, b); });
    return all;
  }

 private:
  /// Algorithm 9.9 for the next list.
  void sort_polygons() {
    auto [list, parent, in_front, depth] = std::move(waiting_.back());
    waiting_.pop_back();
    if (list.empty()) return;
    steps_.step(list.size());
    depth_ = std::max(depth_, depth);
    rest_ = std::move(list);
    front_.clear();
    back_.clear();
    const Index root = take_root();
    if (parent == kNone) {
      tree_ = root;
    } else {
      (in_front ? table_[parent].front : table_[parent].back) = root;
    }
    observer_.begin_root(root, parent, in_front);
    while (!rest_.empty()) {
      const Index test = rest_.back();
      rest_.pop_back();
      compare_polys(root, test);
      observer_.linked();
    }
    waiting_.push_back({back_, root, false, depth + 1});
    waiting_.push_back({front_, root, true, depth + 1});
    observer_.end_root(root);
  }

  /// The first of the list, among those that have a plane if any has: lines have none, and are
  /// behind or in front of polygons.
  Index take_root() {
    const auto has_plane = [&](Index i) { return table_[i].plane != kNoPlane; };
    auto first = std::find_if(rest_.rbegin(), rest_.rend(), has_plane);
    if (first == rest_.rend()) first = rest_.rbegin();
    const Index root = *first;
    rest_.erase(std::next(first).base());
    table_[root].front = table_[root].back = kNone;
    return root;
  }

  /// The end of algorithm 9.10: links the polygon, or each half of it, into the list of its side.
  void compare_polys(Index root, Index test) {
    const std::uint32_t plane = table_[root].plane;
    if (plane == kNoPlane) return keep_with(root, test);
    const PlaneSide side = comparing_.compare(test, plane);
    observer_.compared(root, test, side);
    switch (side) {
      case PlaneSide::front: front_.push_back(test); break;
      case PlaneSide::back: back_.push_back(test); break;
      case PlaneSide::on:
        // Seen from the front, a line is drawn after polygons that touch it from behind; it is
        // compared again with those that touch it from the front.
        if (table_[test].sides == 2) {
          front_.push_back(test);
        } else {
          keep_with(root, test);
          observer_.kept(root);
        }
        break;
      case PlaneSide::both: {
        const auto [front, back] = comparing_.split(test, plane);
        observer_.cut(root, test, front, back);
        front_.push_back(front);
        back_.push_back(back);
      }
    }
  }
  void keep_with(Index root, Index test) {
    table_[test].on = table_[root].on;
    table_[root].on = test;
  }

  /// Algorithm 9.16: everything in back of a root, the root, everything in front. A node waits on
  /// the stack until its back is in the order.
  void save_polygons_in_order() {
    List open;
    Index node = tree_;
    if (node != kNone) observer_.begin_walk(node);
    while (node != kNone || !open.empty()) {
      for (; node != kNone; node = table_[node].back) {
        open.push_back(node);
        if (table_[node].back != kNone) observer_.behind(node, table_[node].back);
      }
      node = open.back();
      open.pop_back();
      const List in_plane = in_plane_of(node);
      order_.insert(order_.end(), in_plane.begin(), in_plane.end());
      observer_.paint(node, in_plane);
      if (table_[node].front != kNone) observer_.before(node, table_[node].front);
      node = table_[node].front;
    }
  }

  SortTables<Policy>& scene_;
  PolygonTable& table_;
  Comparing& comparing_;
  Observer& observer_;

  std::vector<Branch> waiting_;
  List rest_, front_, back_;
  Index tree_ = kNone;
  std::uint32_t depth_ = 0;
  List order_;
  WorkSteps steps_;
};

}  // namespace displayfile
