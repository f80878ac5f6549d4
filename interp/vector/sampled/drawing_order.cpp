#include "interp/vector/sampled/drawing_order.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "hidden/sort/drawing_graph.h"

namespace displayfile {

namespace {

using Graph = DrawingGraph;
using Node = Graph::Node;
constexpr Node kUnvisited = std::numeric_limits<Node>::max();

/// Polygons by the place they take in the free order: node 0 reaches farthest back. Sorting
/// once lets every later choice compare plain integers.
struct Ranking {
  std::vector<Node> polygon_of, node_of;  // node_of: kUnvisited for what is not drawn
};

Ranking rank(std::span<const double> farthest, std::span<const std::uint8_t> drawn) {
  Ranking ranking;
  for (Node i = 0; i < drawn.size(); ++i) {
    if (drawn[i] != 0) ranking.polygon_of.push_back(i);
  }
  std::ranges::stable_sort(ranking.polygon_of, {}, [&](Node i) { return farthest[i]; });
  ranking.node_of.assign(drawn.size(), kUnvisited);
  for (Node node = 0; node < ranking.polygon_of.size(); ++node) {
    ranking.node_of[ranking.polygon_of[node]] = node;
  }
  return ranking;
}

Graph build_graph(std::vector<Overlap>& overlaps, const Ranking& ranking) {
  for (Overlap& o : overlaps) o = {ranking.node_of[o.hidden], ranking.node_of[o.seen]};
  std::erase_if(overlaps, [](const Overlap& o) {
    return o.hidden == kUnvisited || o.seen == kUnvisited || o.hidden == o.seen;
  });
  std::ranges::sort(overlaps);
  overlaps.erase(std::unique(overlaps.begin(), overlaps.end()), overlaps.end());
  Graph graph;
  graph.first.assign(ranking.polygon_of.size() + 1, 0);
  graph.later.reserve(overlaps.size());
  for (const Overlap& o : overlaps) {
    ++graph.first[o.hidden + 1];
    graph.later.push_back(o.seen);
  }
  for (std::size_t i = 1; i < graph.first.size(); ++i) graph.first[i] += graph.first[i - 1];
  return graph;
}

using NearestLast = std::priority_queue<Node, std::vector<Node>, std::greater<>>;

class StepOrder {
 public:
  StepOrder(const Graph& graph, const Ranking& ranking)
      : graph_(graph), ranking_(ranking), cycles_(find_cycles(graph)) {
    list_members();
    count_hidden();
  }

  /// Kahn's algorithm, cycles taken as one node each.
  std::vector<DrawStep> steps() {
    NearestLast ready;  // the first node of each cycle of which all that it hides is drawn
    for (Node c = 0; c < cycles_.count; ++c) {
      if (waiting_of_cycle_[c] == 0) ready.push(members(c).front());
    }
    while (!ready.empty()) {
      const Node c = cycles_.of[ready.top()];
      ready.pop();
      draw_cycle(c);
      for (const Node member : members(c)) {
        for (const Node hider : graph_.later_than(member)) {
          const Node other = cycles_.of[hider];
          if (other != c && --waiting_of_cycle_[other] == 0) ready.push(members(other).front());
        }
      }
    }
    return std::move(steps_);
  }

 private:
  std::span<const Node> members(Node cycle) const {
    return std::span(members_).subspan(first_member_[cycle],
                                       first_member_[cycle + 1] - first_member_[cycle]);
  }

  void list_members() {
    first_member_.assign(cycles_.count + 1, 0);
    for (const Node c : cycles_.of) ++first_member_[c + 1];
    for (Node c = 0; c < cycles_.count; ++c) first_member_[c + 1] += first_member_[c];
    std::vector<std::size_t> place(first_member_.begin(), first_member_.end() - 1);
    members_.resize(graph_.size());
    for (Node i = 0; i < graph_.size(); ++i) members_[place[cycles_.of[i]]++] = i;
  }

  /// For each cycle and each node, how many overlaps lead to it: from other cycles, and from
  /// within its own.
  void count_hidden() {
    waiting_of_cycle_.assign(cycles_.count, 0);
    waiting_.assign(graph_.size(), 0);
    for (Node i = 0; i < graph_.size(); ++i) {
      for (const Node hider : graph_.later_than(i)) {
        if (cycles_.of[i] == cycles_.of[hider]) {
          ++waiting_[hider];
        } else {
          ++waiting_of_cycle_[cycles_.of[hider]];
        }
      }
    }
  }

  /// Kahn's algorithm again; when nothing is ready, the member that reaches farthest back is
  /// drawn all the same, over nothing yet, and to be mended if what it hides comes later.
  void draw_cycle(Node cycle) {
    const auto all = members(cycle);
    if (all.size() == 1) return draw(all.front());
    constexpr Node kDrawn = kUnvisited;
    NearestLast ready;
    std::vector<Node> to_mend;
    std::size_t next = 0;
    for (std::size_t drawn = 0; drawn < all.size(); ++drawn) {
      Node node;
      if (!ready.empty()) {
        node = ready.top();
        ready.pop();
      } else {
        while (waiting_[all[next]] == kDrawn) ++next;
        node = all[next];
        if (waiting_[node] != 0) to_mend.push_back(node);
      }
      draw(node);
      waiting_[node] = kDrawn;
      for (const Node hider : graph_.later_than(node)) {
        if (cycles_.of[hider] != cycle || waiting_[hider] == kDrawn) continue;
        if (--waiting_[hider] == 0) ready.push(hider);
      }
    }
    for (const Node node : to_mend) steps_.push_back({ranking_.polygon_of[node], true});
  }

  void draw(Node node) { steps_.push_back({ranking_.polygon_of[node], false}); }

  const Graph& graph_;
  const Ranking& ranking_;
  DrawingCycles cycles_;
  std::vector<std::size_t> first_member_;
  std::vector<Node> members_;  // cycle after cycle, each in the free order
  std::vector<std::size_t> waiting_of_cycle_;
  std::vector<Node> waiting_;  // overlaps from undrawn members of the same cycle
  std::vector<DrawStep> steps_;
};

}  // namespace

std::vector<DrawStep> drawing_order(std::vector<Overlap> overlaps, std::span<const double> farthest,
                                    std::span<const std::uint8_t> drawn) {
  const Ranking ranking = rank(farthest, drawn);
  const Graph graph = build_graph(overlaps, ranking);
  return StepOrder(graph, ranking).steps();
}

}  // namespace displayfile
