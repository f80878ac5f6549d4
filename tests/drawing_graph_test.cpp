// The cycles of a graph.

#include "hidden/sort/drawing_graph.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "tests/every_way.h"

namespace displayfile {
namespace {

using namespace test;

TEST(DrawingGraphTest, CyclesAreThoseThatReachEachOther) {
  Source s(1);
  for (int trial = 0; trial < 300; ++trial) {
    const int n = s.between(1, 12), edges = s.between(0, 24);
    std::vector<std::vector<DrawingGraph::Node>> later(static_cast<std::size_t>(n));
    for (int k = 0; k < edges; ++k) {
      later[static_cast<std::size_t>(s.below(n))].push_back(
          static_cast<DrawingGraph::Node>(s.below(n)));
    }
    DrawingGraph graph;
    for (const auto& of : later) {
      graph.first.push_back(graph.later.size());
      graph.later.insert(graph.later.end(), of.begin(), of.end());
    }
    graph.first.push_back(graph.later.size());
    const auto size = static_cast<std::size_t>(n);
    std::vector<std::vector<bool>> reaches(size, std::vector<bool>(size));
    for (std::size_t i = 0; i < size; ++i) {
      reaches[i][i] = true;
      for (const auto j : later[i]) reaches[i][j] = true;
    }
    for (std::size_t via = 0; via < size; ++via) {
      for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) {
          if (reaches[i][via] && reaches[via][j]) reaches[i][j] = true;
        }
      }
    }
    const DrawingCycles cycles = find_cycles(graph);
    std::set<DrawingGraph::Node> numbers(cycles.of.begin(), cycles.of.end());
    EXPECT_EQ(numbers.size(), cycles.count);
    EXPECT_LT(*numbers.rbegin(), cycles.count);
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) {
        EXPECT_EQ(cycles.of[i] == cycles.of[j], reaches[i][j] && reaches[j][i]);
        if (reaches[i][j]) {
          EXPECT_GE(cycles.of[i], cycles.of[j]);
        }
      }
    }
  }
}

/// A cycle's number is a function of the pairs of successors, and not of the order in which they
/// were found.
TEST(DrawingGraphTest, PutInOrderItIsAFunctionOfItsPairs) {
  Source s(2);
  for (int trial = 0; trial < 100; ++trial) {
    const int n = s.between(1, 12);
    std::vector<std::vector<DrawingGraph::Node>> later(static_cast<std::size_t>(n));
    for (int k = s.between(0, 24); k > 0; --k) {
      later[static_cast<std::size_t>(s.below(n))].push_back(
          static_cast<DrawingGraph::Node>(s.below(n)));
    }
    std::vector<DrawingGraph::Node> cycle_of;
    for (int order = 0; order < 5; ++order) {
      DrawingGraph graph;
      for (auto& of : later) {
        for (std::size_t k = of.size(); k > 1; --k) {
          std::swap(of[k - 1], of[static_cast<std::size_t>(s.below(static_cast<int>(k)))]);
        }
        graph.first.push_back(graph.later.size());
        graph.later.insert(graph.later.end(), of.begin(), of.end());
      }
      graph.first.push_back(graph.later.size());
      graph.put_in_order();
      const DrawingCycles cycles = find_cycles(graph);
      if (order == 0) cycle_of = cycles.of;
      EXPECT_EQ(cycles.of, cycle_of);
    }
  }
}

TEST(DrawingGraphTest, AChainOfAMillion) {
  constexpr DrawingGraph::Node kNodes = 1000000 / kSlower;
  DrawingGraph graph;
  for (DrawingGraph::Node i = 0; i < kNodes; ++i) {
    graph.first.push_back(i);
    graph.later.push_back(i + 1 == kNodes ? kNodes / 2 : i + 1);
  }
  graph.first.push_back(kNodes);
  const DrawingCycles cycles = find_cycles(graph);
  EXPECT_EQ(cycles.count, kNodes / 2 + 1);
  EXPECT_EQ(cycles.of[kNodes - 1], 0u);
  EXPECT_EQ(cycles.of[0], cycles.count - 1);
}

}  // namespace
}  // namespace displayfile
