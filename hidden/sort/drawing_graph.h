#pragma once

#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

namespace displayfile {

/// What is to be drawn after what, of nodes numbered from 0: those after node i are
/// later[first[i]] to later[first[i + 1]].
struct DrawingGraph {
  using Node = std::uint32_t;
  std::vector<std::size_t> first;
  std::vector<Node> later;

  Node size() const { return static_cast<Node>(first.size() - 1); }
  std::span<const Node> later_than(Node i) const {
    assert(i < size());
    return std::span(later).subspan(first[i], first[i + 1] - first[i]);
  }
  /// Puts what comes after each node in the order of their numbers: the cycles that are found then
  /// depend on the graph alone, and not on the order in which its pairs were.
  void put_in_order();
};

/// The cycle (strongly connected component) that each node belongs to; most have one node. They
/// are numbered from 0 so that what must be drawn after a cycle has a lower number.
struct DrawingCycles {
  std::vector<DrawingGraph::Node> of;
  DrawingGraph::Node count = 0;
};

/// Tarjan, "Depth-first search and linear graph algorithms", SIAM J. Comput. 1 (1972), with its
/// recursion on a stack of our own: time and memory in proportion to nodes and edges.
DrawingCycles find_cycles(const DrawingGraph& graph);

}  // namespace displayfile
