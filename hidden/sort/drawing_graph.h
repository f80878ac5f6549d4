#pragma once

#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

namespace displayfile {

/// The drawing order of nodes numbered from 0: the nodes to be drawn after node i are
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
  /// Sorts each node's successors by number: the cycles found then depend only on the graph, not on
  /// the order of its pairs.
  void put_in_order();
};

/// The cycle (strongly connected component) of each node; most have one node. They are numbered
/// from 0 so that a cycle to be drawn later has a lower number.
struct DrawingCycles {
  std::vector<DrawingGraph::Node> of;
  DrawingGraph::Node count = 0;
};

/// Tarjan, "Depth-first search and linear graph algorithms", SIAM J. Comput. 1 (1972), with an
/// explicit stack: linear time and memory.
DrawingCycles find_cycles(const DrawingGraph& graph);

}  // namespace displayfile
