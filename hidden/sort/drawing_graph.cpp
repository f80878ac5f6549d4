#include "hidden/sort/drawing_graph.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace displayfile {

namespace {

/// True if each node has a cycle, and no node to be drawn later is in a cycle with a higher number.
[[maybe_unused]] bool are_in_order(const DrawingCycles& cycles, const DrawingGraph& graph) {
  for (DrawingGraph::Node i = 0; i < graph.size(); ++i) {
    if (cycles.of[i] >= cycles.count) return false;
    for (const DrawingGraph::Node later : graph.later_than(i)) {
      if (cycles.of[later] > cycles.of[i]) return false;
    }
  }
  return true;
}

}  // namespace

void DrawingGraph::put_in_order() {
  for (std::size_t i = 0; i + 1 < first.size(); ++i) {
    std::ranges::sort(later.begin() + static_cast<std::ptrdiff_t>(first[i]),
                      later.begin() + static_cast<std::ptrdiff_t>(first[i + 1]));
  }
}

DrawingCycles find_cycles(const DrawingGraph& graph) {
  using Node = DrawingGraph::Node;
  constexpr Node kUnvisited = std::numeric_limits<Node>::max();
  struct Visit {
    Node node;
    std::size_t next;
  };
  assert(!graph.first.empty() && graph.first.back() == graph.later.size());
  const Node n = graph.size();
  DrawingCycles cycles{std::vector<Node>(n, kUnvisited), 0};
  std::vector<Node> number(n, kUnvisited), low(n), stack;
  std::vector<Visit> visits;
  Node visited = 0;
  const auto enter = [&](Node node) {
    number[node] = low[node] = visited++;
    stack.push_back(node);
    visits.push_back({node, graph.first[node]});
  };
  const auto leave = [&](Node node) {
    if (low[node] == number[node]) {
      Node member;
      do {
        member = stack.back();
        stack.pop_back();
        cycles.of[member] = cycles.count;
      } while (member != node);
      ++cycles.count;
    }
    visits.pop_back();
    if (!visits.empty()) low[visits.back().node] = std::min(low[visits.back().node], low[node]);
  };
  for (Node root = 0; root < n; ++root) {
    if (number[root] != kUnvisited) continue;
    enter(root);
    while (!visits.empty()) {
      Visit& visit = visits.back();
      if (visit.next == graph.first[visit.node + 1]) {
        leave(visit.node);
        continue;
      }
      const Node later = graph.later[visit.next++];
      if (number[later] == kUnvisited) {
        enter(later);
      } else if (cycles.of[later] == kUnvisited) {  // still on the stack
        low[visit.node] = std::min(low[visit.node], number[later]);
      }
    }
  }
  assert(stack.empty() && are_in_order(cycles, graph));
  return cycles;
}

}  // namespace displayfile
