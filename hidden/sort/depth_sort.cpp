#include "hidden/sort/hidden_surface_sort.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "hidden/sort/depth_tests.h"
#include "hidden/sort/drawing_graph.h"
#include "hidden/sort/overlaps.h"
#include "hidden/sort/sort_polygons.h"

namespace displayfile {

namespace {

using Index = PolygonTable::Index;

template <class Policy>
class DepthSort {
 public:
  DepthSort(SortTables<Policy>& scene, const SurfacePlan& plan)
      : scene_(scene), table_(scene.table), plan_(plan) {}

  SortedPieces sorted() {
    const std::size_t most = kPairsOfAPolygon * std::size_t{table_.free()} + 4096;
    auto [extents, pairs] = overlapping_pairs(scene_, most, plan_.threads);
    extents_ = std::move(extents);
    if (pairs) {
      order_pairs(*pairs);
      draw_in_order(*pairs);
    } else {
      sort_by_tree(all_entries());
    }
    SortedPieces pieces = sorted_pieces(scene_, order_);
    pieces.comparisons += compared_;
    pieces.depth = tree_depth_;
    return pieces;
  }

 private:
  using Node = DrawingGraph::Node;

  /// With more overlapping pairs per polygon on average, a tree takes less time and memory.
  static constexpr std::size_t kPairsOfAPolygon = 48;

  std::vector<Index> all_entries() const {
    std::vector<Index> all;
    for (Index i = 0; i < table_.free(); ++i) {
      if (table_[i].sides > 0) all.push_back(i);
    }
    return all;
  }

  void sort_by_tree(std::span<const Index> polygons) {
    SurfacePlan plan = plan_;
    plan.root = RootChoice::sample;
    SortPolygons tree(scene_, plan);
    tree.sort(polygons);
    order_.insert(order_.end(), tree.order().begin(), tree.order().end());
    tree_depth_ = std::max(tree_depth_, tree.depth());
  }

  // ---- The drawing order of pairs -----------------------------------------------------------

  /// Puts the polygon drawn first at the front of each pair. Pairs that cut each other's planes are
  /// examined one by one; pairs that overlap at most in a line are dropped, and intersecting pairs
  /// are also listed separately.
  void order_pairs(std::vector<Overlaps::Pair>& pairs) {
    std::vector<DrawnFirst> orders(pairs.size());
    constexpr std::uint32_t kPart = 4096;
    in_parts(static_cast<std::uint32_t>(pairs.size()), kPart, plan_.threads,
             [&](std::uint32_t, std::uint32_t from, std::uint32_t to) {
               for (std::uint32_t k = from; k < to; ++k) {
                 const auto [a, b] = pairs[k];
                 orders[k] = tested_order(scene_, a, b, extents_[a], extents_[b]);
               }
             });
    compared_ += pairs.size();
    std::size_t kept = 0;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      auto [a, b] = pairs[k];
      const DrawnFirst order = orders[k] == DrawnFirst::neither ? order_of_halves(a, b) : orders[k];
      if (order == DrawnFirst::either) continue;
      if (order == DrawnFirst::second) std::swap(a, b);
      if (order == DrawnFirst::neither) through_.emplace_back(a, b);
      pairs[kept++] = {a, b};
    }
    pairs.resize(kept);
  }

  DrawnFirst order_of(Index a, Index b) {
    ++compared_;
    const DrawnFirst order = tested_order(scene_, a, b, extents_[a], extents_[b]);
    return order == DrawnFirst::neither ? order_of_halves(a, b) : order;
  }

  /// For polygons that are each cut by the other's plane: finds which half of a overlaps b, using a
  /// copy.
  DrawnFirst order_of_halves(Index a, Index b) {
    if (table_[b].plane == kNoPlane) return reversed(order_of_halves(b, a));
    const auto mark = table_.mark();
    const Index copy = table_.copy(a);
    const std::uint32_t plane = table_[b].plane;
    scene_.comparing.compare(copy, plane);
    const auto [front, back] = scene_.comparing.split(copy, plane);
    const Outline outline = scene_.outline(b);
    const bool in_front = overlap_in_projection(scene_.vertices, scene_.outline(front), outline);
    const bool in_back = overlap_in_projection(scene_.vertices, scene_.outline(back), outline);
    table_.take_back(mark);
    scene_.comparing.take_back_split();
    if (in_front && in_back) return DrawnFirst::neither;
    if (in_front) return DrawnFirst::second;
    return in_back ? DrawnFirst::first : DrawnFirst::either;
  }

  // ---- The order ------------------------------------------------------------------------------

  void draw_in_order(const std::vector<Overlaps::Pair>& before) {
    DrawingGraph graph = graph_of(before, through_, table_.free());
    graph.put_in_order();
    const DrawingCycles cycles = find_cycles(graph);
    graph = {};
    // Cycles from the highest number to the lowest, each with its members in order of entry.
    std::vector<std::size_t> first(cycles.count + 1, 0);
    for (const Node c : cycles.of) ++first[cycles.count - c];
    for (Node c = 0; c < cycles.count; ++c) first[c + 1] += first[c];
    assert(first.back() == cycles.of.size());
    std::vector<Index> members(cycles.of.size());
    {
      std::vector<std::size_t> next(first.begin(), first.end() - 1);
      for (Index i = 0; i < cycles.of.size(); ++i) {
        members[next[cycles.count - 1 - cycles.of[i]]++] = i;
      }
    }
    order_.reserve(members.size());
    std::optional<Overlaps> overlaps;
    for (Node c = 0; c < cycles.count; ++c) {
      const std::span cycle = std::span(members).subspan(first[c], first[c + 1] - first[c]);
      if (cycle.size() == 1) {
        if (table_[cycle[0]].sides > 0) order_.push_back(cycle[0]);
        continue;
      }
      if (!overlaps) {
        overlaps.emplace(before, cycles.of.size());
        overlaps_ = &*overlaps;
        origin_.resize(table_.free());
        for (Index i = 0; i < origin_.size(); ++i) origin_[i] = i;
        group_of_.assign(origin_.size(), 0);
        place_of_.resize(origin_.size());
      }
      draw_cycle(cycle);
    }
  }

  static DrawingGraph graph_of(const std::vector<Overlaps::Pair>& before,
                               const std::vector<Overlaps::Pair>& both_ways, std::size_t nodes) {
    DrawingGraph graph;
    graph.first.assign(nodes + 1, 0);
    for (const auto& [a, b] : before) ++graph.first[a + 1];
    for (const auto& [a, b] : both_ways) ++graph.first[b + 1];
    for (std::size_t i = 1; i <= nodes; ++i) graph.first[i] += graph.first[i - 1];
    graph.later.resize(graph.first.back());
    std::vector<std::size_t> next(graph.first.begin(), graph.first.end() - 1);
    for (const auto& [a, b] : before) graph.later[next[a]++] = b;
    for (const auto& [a, b] : both_ways) graph.later[next[b]++] = a;
    return graph;
  }

  // ---- Cycles ---------------------------------------------------------------------------------

  /// Pieces that overlap in cycles, or did so before they were cut. Pairs are indices into the
  /// pieces.
  struct Group {
    std::vector<Index> pieces;
    std::vector<std::uint8_t> fresh;  ///< pieces that have not been compared with the others
    std::vector<Overlaps::Pair> before, through;
    std::size_t cuts_left;  ///< remaining cuts before a tree takes over
  };

  void draw_cycle(std::span<const Index> cycle) {
    groups_.push_back({{cycle.begin(), cycle.end()},
                       std::vector<std::uint8_t>(cycle.size(), 1),
                       {},
                       {},
                       8 * cycle.size() + 64});
    while (!groups_.empty()) {
      Group group = std::move(groups_.back());
      groups_.pop_back();
      assert(!group.pieces.empty() && group.fresh.size() == group.pieces.size());
      if (group.pieces.size() == 1) {
        order_.push_back(group.pieces[0]);
        continue;
      }
      compare_fresh(group);
      const DrawingGraph graph = graph_of(group.before, group.through, group.pieces.size());
      const DrawingCycles cycles = find_cycles(graph);
      if (cycles.count > 1) {
        part(group, cycles);
        continue;
      }
      const std::size_t cuts = cut(group, graph);
      if (cuts == 0 || cuts > group.cuts_left) {
        sort_by_tree(group.pieces);
        track_new_entries(Index{0});
        continue;
      }
      group.cuts_left -= cuts;
      forget_fresh(group);
      groups_.push_back(std::move(group));
    }
  }

  /// Pushes the cycles so that the first to be drawn is on top.
  void part(const Group& group, const DrawingCycles& cycles) {
    const std::size_t first = groups_.size();
    groups_.resize(first + cycles.count);
    const std::size_t n = group.pieces.size();
    place_in_part_.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      Group& its = groups_[first + cycles.of[k]];
      place_in_part_[k] = static_cast<std::uint32_t>(its.pieces.size());
      its.pieces.push_back(group.pieces[k]);
      its.fresh.push_back(0);
    }
    const auto share_out = [&](std::vector<Overlaps::Pair> Group::*pairs) {
      for (const auto& [k, m] : group.*pairs) {
        if (cycles.of[k] != cycles.of[m]) continue;
        (groups_[first + cycles.of[k]].*pairs).emplace_back(place_in_part_[k], place_in_part_[m]);
      }
    };
    share_out(&Group::before);
    share_out(&Group::through);
    for (std::size_t c = first; c < groups_.size(); ++c) {
      groups_[c].cuts_left = std::min(group.cuts_left, 8 * groups_[c].pieces.size() + 64);
    }
  }

  /// Compares the fresh pieces with all whose origins overlap theirs.
  void compare_fresh(Group& group) {
    const std::vector<Index>& pieces = group.pieces;
    ++group_;
    by_origin_.clear();
    for (std::uint32_t k = 0; k < pieces.size(); ++k) {
      by_origin_.emplace_back(origin_[pieces[k]], k);
    }
    std::ranges::sort(by_origin_);
    for (std::uint32_t at = 0; at < by_origin_.size(); ++at) {
      const Index origin = by_origin_[at].first;
      if (group_of_[origin] == group_) continue;
      group_of_[origin] = group_;
      place_of_[origin] = at;
    }
    for (const auto& [origin, k] : by_origin_) {
      if (group.fresh[k] == 0) continue;
      for (const Index other : overlaps_->with(origin)) {
        if (group_of_[other] != group_) continue;
        for (std::uint32_t at = place_of_[other];
             at < by_origin_.size() && by_origin_[at].first == other; ++at) {
          const std::uint32_t m = by_origin_[at].second;
          if (group.fresh[m] != 0 && other < origin) continue;  // each pair once
          compare_pieces(group, k, m);
        }
      }
    }
    std::ranges::fill(group.fresh, std::uint8_t{0});
  }

  void compare_pieces(Group& group, std::uint32_t k, std::uint32_t m) {
    steps_.step();
    const Index a = group.pieces[k], b = group.pieces[m];
    if (!(table_[a].whole && table_[b].whole)) {
      if (!extents_[a].meets_in_projection(extents_[b])) return;
      if (!overlap_in_projection(scene_.vertices, scene_.outline(a), scene_.outline(b))) return;
    }
    switch (order_of(a, b)) {
      case DrawnFirst::either: break;
      case DrawnFirst::first: group.before.emplace_back(k, m); break;
      case DrawnFirst::second: group.before.emplace_back(m, k); break;
      case DrawnFirst::neither: group.before.emplace_back(k, m); group.through.emplace_back(k, m);
    }
  }

  /// Removes pairs of pieces that have been cut since.
  void forget_fresh(Group& group) {
    const auto is_fresh = [&](const Overlaps::Pair& pair) {
      return group.fresh[pair.first] != 0 || group.fresh[pair.second] != 0;
    };
    std::erase_if(group.before, is_fresh);
    std::erase_if(group.through, is_fresh);
  }

  /// Cuts pieces that intersect others; if there are none, one or more pieces in short cycles.
  /// Returns the number of cuts.
  std::size_t cut(Group& group, const DrawingGraph& graph) {
    touched_.assign(group.pieces.size(), 0);
    std::size_t cuts = 0;
    for (const auto& [k, m] : group.through) {
      if (touched_[k] != 0 || touched_[m] != 0) continue;
      cuts += cut_one_of(group, k, m) ? 1 : 0;
    }
    if (cuts > 0) return cuts;
    const std::size_t most = group.pieces.size() / 64 + 1;
    for (Node k = 0; k < graph.size() && cuts < most; ++k) {
      if (touched_[k] != 0 || !find_short_cycle(graph, k)) continue;
      cuts += cut_cycle(group) ? 1 : 0;
      for (const Node node : cycle_) touched_[node] = 1;
    }
    return cuts;
  }

  /// Cuts the smaller of two intersecting pieces by the larger one's plane.
  bool cut_one_of(Group& group, std::uint32_t k, std::uint32_t m) {
    if (size_of(group.pieces[k]) > size_of(group.pieces[m])) std::swap(k, m);
    if (table_[group.pieces[m]].plane == kNoPlane) std::swap(k, m);
    if (!cut_piece(group, k, table_[group.pieces[m]].plane)) return false;
    touched_[m] = 1;
    return true;
  }
  double size_of(Index i) const {
    const Extent& box = extents_[i];
    return double{box.x_max - box.x_min} * double{box.y_max - box.y_min};
  }

  bool cut_piece(Group& group, std::uint32_t k, std::uint32_t plane) {
    const Index piece = group.pieces[k];
    if (plane == kNoPlane || scene_.comparing.compare(piece, plane) != PlaneSide::both) {
      return false;
    }
    const auto [front, back] = scene_.comparing.split(piece, plane);
    track_new_entries(origin_[piece]);
    extents_[front] = scene_.extent(front);
    extents_[back] = scene_.extent(back);
    group.pieces.push_back(front == piece ? back : front);
    group.fresh[k] = touched_[k] = 1;
    group.fresh.push_back(1);
    touched_.push_back(1);
    assert(touched_.size() == group.pieces.size() && origin_.size() == table_.free());
    return true;
  }

  void track_new_entries(Index origin) {
    origin_.resize(table_.free(), origin);
    extents_.resize(table_.free());
  }

  /// Finds a shortest cycle through the node among untouched nodes, breadth first.
  bool find_short_cycle(const DrawingGraph& graph, Node start) {
    constexpr Node kUnvisited = std::numeric_limits<Node>::max();
    came_from_.assign(graph.size(), kUnvisited);
    steps_.step(graph.size() / 16 + 1);
    queue_.assign(1, start);
    for (std::size_t at = 0; at < queue_.size(); ++at) {
      const Node node = queue_[at];
      for (const Node later : graph.later_than(node)) {
        if (later == start) {
          cycle_.clear();
          for (Node n = node; n != start; n = came_from_[n]) cycle_.push_back(n);
          cycle_.push_back(start);
          std::ranges::reverse(cycle_);
          assert(cycle_.front() == start && cycle_.size() > 1);
          return true;
        }
        if (touched_[later] != 0 || came_from_[later] != kUnvisited) continue;
        came_from_[later] = node;
        queue_.push_back(later);
      }
    }
    return false;
  }

  /// Cuts one member by the plane of another so that the cycle is broken; if no cut does that,
  /// makes any possible cut.
  bool cut_cycle(Group& group) {
    const std::size_t n = cycle_.size();
    for (const bool must_break : {true, false}) {
      for (std::size_t by = 1; by < n; ++by) {  // neighbours first, on either side
        for (std::size_t k = 0; k < n; ++k) {
          const std::size_t step = by % 2 == 1 ? n - (by + 1) / 2 : by / 2;
          const Index cutter = group.pieces[cycle_[(k + step) % n]];
          const std::uint32_t plane = table_[cutter].plane;
          if (plane == kNoPlane) continue;
          if (must_break && !breaks(group, k, plane)) continue;
          if (cut_piece(group, cycle_[k], plane)) return true;
        }
      }
    }
    return false;
  }

  /// True if neither half of the member is both drawn after the previous one in the cycle and
  /// before the next one. Tested on a copy.
  bool breaks(const Group& group, std::size_t k, std::uint32_t plane) {
    steps_.step();
    const std::size_t n = cycle_.size();
    const Index piece = group.pieces[cycle_[k]];
    const Index earlier = group.pieces[cycle_[(k + n - 1) % n]];
    const Index later = group.pieces[cycle_[(k + 1) % n]];
    const auto mark = table_.mark();
    const Index copy = table_.copy(piece);
    if (scene_.comparing.compare(copy, plane) != PlaneSide::both) {
      table_.take_back(mark);
      return false;
    }
    const auto [front, back] = scene_.comparing.split(copy, plane);
    extents_.resize(table_.free());
    bool broken = true;
    for (const Index half : {front, back}) {
      extents_[half] = scene_.extent(half);
      broken = broken && !(comes_before(earlier, half) && comes_before(half, later));
    }
    table_.take_back(mark);
    extents_.resize(table_.free());
    scene_.comparing.take_back_split();
    return broken;
  }
  bool comes_before(Index a, Index b) {
    if (!overlap_in_projection(scene_.vertices, scene_.outline(a), scene_.outline(b))) return false;
    const DrawnFirst order = order_of(a, b);
    return order == DrawnFirst::first || order == DrawnFirst::neither;
  }

  SortTables<Policy>& scene_;
  PolygonTable& table_;
  const SurfacePlan& plan_;
  std::vector<Extent> extents_;
  std::vector<Index> order_;
  std::uint64_t compared_ = 0;
  std::uint32_t tree_depth_ = 0;

  std::vector<Overlaps::Pair> through_;  // indices of entries

  const Overlaps* overlaps_ = nullptr;
  std::vector<Index> origin_;                       // per piece, the entry that it was cut from
  std::vector<std::uint32_t> group_of_, place_of_;  // per origin
  std::uint32_t group_ = 0;
  std::vector<std::pair<Index, std::uint32_t>> by_origin_;
  std::vector<Group> groups_;
  std::vector<std::uint8_t> touched_;
  std::vector<std::uint32_t> place_in_part_;
  std::vector<Node> came_from_, queue_, cycle_;
  WorkSteps steps_;
};

}  // namespace

SortedPieces sort_by_depth(const Primitives& items, const SurfacePlan& plan) {
  const auto sort = [&](const auto& policy) {
    SortTables scene(items, policy);
    scene.table.most_entries = most_pieces_of_sort(plan, items.items.size());
    return DepthSort(scene, plan).sorted();
  };
  const Definitions points{items.points, {}};
  if (plan.precision.exact) return sort(Exact(points));
  return sort(Roundoff::relative(points, plan.precision.roundoff));
}

}  // namespace displayfile
