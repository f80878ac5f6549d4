#include "tests/bench/travel_bound.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace displayfile::bench {
namespace {

/// What the tree joins: an end of an open path, or a closed path or dot, of one point or more.
struct Ends {
  std::vector<SheetPoint> points;
  std::vector<std::uint32_t> end_of_point, path_of_point;
  std::vector<double> uses;  // of each end

  explicit Ends(const std::vector<PenPath>& paths) {
    for (std::uint32_t k = 0; k < paths.size(); ++k) {
      const auto& p = paths[k].points;
      const auto add = [&](const SheetPoint& point) {
        points.push_back(point);
        end_of_point.push_back(static_cast<std::uint32_t>(uses.size()) - 1);
        path_of_point.push_back(k);
      };
      if (paths[k].closed || p.size() == 1) {
        uses.push_back(2.0);
        for (const SheetPoint& point : p) add(point);
      } else {
        for (const SheetPoint& point : {p.front(), p.back()}) {
          uses.push_back(1.0);
          add(point);
        }
      }
    }
  }
};

/// The shortest tree over the paths with prices, by Prim's algorithm; how often it joins each end.
double shortest_tree(const Ends& ends, const std::vector<double>& prices,
                     std::vector<double>& joined) {
  const std::size_t n = ends.points.size();
  std::vector<double> cost(n, std::numeric_limits<double>::infinity());
  std::vector<std::uint32_t> from(n, 0);
  std::vector<std::uint8_t> in_tree(n, 0);
  joined.assign(ends.uses.size(), 0.0);
  double sum = 0.0;
  const auto take_path = [&](std::size_t point) {
    const std::uint32_t path = ends.path_of_point[point];
    std::size_t first = point, end = point + 1;
    while (first > 0 && ends.path_of_point[first - 1] == path) --first;
    while (end < n && ends.path_of_point[end] == path) ++end;
    for (std::size_t i = first; i < end; ++i) in_tree[i] = 1;
    for (std::size_t j = 0; j < n; ++j) {
      if (in_tree[j] != 0) continue;
      for (std::size_t i = first; i < end; ++i) {
        const double d =
            std::sqrt(static_cast<double>(squared_distance(ends.points[i], ends.points[j]))) +
            prices[ends.end_of_point[i]] + prices[ends.end_of_point[j]];
        if (d < cost[j]) {
          cost[j] = d;
          from[j] = static_cast<std::uint32_t>(i);
        }
      }
    }
  };
  take_path(0);
  for (;;) {
    std::size_t next = n;
    for (std::size_t j = 0; j < n; ++j) {
      if (in_tree[j] == 0 && (next == n || cost[j] < cost[next])) next = j;
    }
    if (next == n) return sum;
    sum += cost[next];
    joined[ends.end_of_point[next]] += 1.0;
    joined[ends.end_of_point[from[next]]] += 1.0;
    take_path(next);
  }
}

}  // namespace

double travel_bound(const std::vector<PenPath>& paths, int rounds) {
  if (paths.size() < 2) return 0.0;
  const Ends ends(paths);
  std::vector<double> prices(ends.uses.size(), 0.0), joined;
  double best = 0.0, step = 0.0;
  for (int round = 0; round < rounds; ++round) {
    const double tree = shortest_tree(ends, prices, joined);
    double bound = tree;
    for (std::size_t e = 0; e < prices.size(); ++e) bound -= prices[e] * ends.uses[e];
    double least = std::numeric_limits<double>::infinity(), second = least;
    for (const double p : prices) {
      second = std::min(second, std::max(least, p));
      least = std::min(least, p);
    }
    // The first and the last end of a way may be one and the same closed path only if it is alone.
    bound += least + second;
    best = std::max(best, bound);
    if (round == 0) step = tree / static_cast<double>(paths.size());
    for (std::size_t e = 0; e < prices.size(); ++e) {
      prices[e] += 0.5 * step * (joined[e] - ends.uses[e]);
    }
    step *= 0.97;
  }
  return best;
}

}  // namespace displayfile::bench
