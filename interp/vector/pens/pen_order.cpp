#include "interp/vector/pens/pen_order.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "interp/vector/pens/point_tree.h"
#include "interp/vector/pens/tour.h"

namespace displayfile {

namespace {

const SheetPoint& end_of(const PenPath& path) {
  return path.closed ? path.points.front() : path.points.back();
}

double way(const SheetPoint& a, const SheetPoint& b) {
  return std::sqrt(static_cast<double>(squared_distance(a, b)));
}

void begin_at(PenPath& path, std::size_t point) {
  if (path.closed) {
    std::rotate(path.points.begin(), path.points.begin() + static_cast<std::ptrdiff_t>(point),
                path.points.end());
  } else if (point != 0) {
    std::ranges::reverse(path.points);
  }
}

/// Nearest neighbour: always continues with the nearest remaining end of an open path, or point of
/// a closed one.
void go_to_the_nearest(std::vector<PenPath>& paths, SheetPoint pen) {
  struct Entry {
    std::uint32_t path, point;
  };
  std::vector<SheetPoint> points;
  std::vector<Entry> entries;
  std::vector<std::uint32_t> first;
  for (std::uint32_t k = 0; k < paths.size(); ++k) {
    first.push_back(static_cast<std::uint32_t>(points.size()));
    const auto& p = paths[k].points;
    const std::size_t step = paths[k].closed || p.size() == 1 ? 1 : p.size() - 1;
    for (std::size_t i = 0; i < p.size(); i += step) {
      points.push_back(p[i]);
      entries.push_back({k, static_cast<std::uint32_t>(i)});
    }
  }
  first.push_back(static_cast<std::uint32_t>(points.size()));
  PointTree tree(points);
  std::vector<PenPath> ordered;
  ordered.reserve(paths.size());
  for (std::uint32_t next = tree.nearest(pen); next != PointTree::kNone; next = tree.nearest(pen)) {
    const auto [k, point] = entries[next];
    for (std::uint32_t i = first[k]; i < first[k + 1]; ++i) tree.remove(i);
    ordered.push_back(std::move(paths[k]));
    begin_at(ordered.back(), point);
    pen = end_of(ordered.back());
  }
  paths = std::move(ordered);
}

void exchange(std::vector<PenPath>& paths) {
  std::vector<SheetPoint> ends;
  for (const PenPath& path : paths) {
    ends.push_back(path.points.front());
    ends.push_back(end_of(path));
  }
  Tour tour(std::move(ends));
  tour.improve();
  std::vector<PenPath> ordered;
  ordered.reserve(paths.size());
  for (const Tour::End end : tour.entered()) {
    ordered.push_back(std::move(paths[end / 2]));
    if (end % 2 == 1 && !ordered.back().closed) std::ranges::reverse(ordered.back().points);
  }
  paths = std::move(ordered);
}

/// Starts each closed path at the best point between its neighbours.
void enter_loops_where_best(std::vector<PenPath>& paths) {
  for (std::size_t k = 0; k < paths.size(); ++k) {
    PenPath& path = paths[k];
    if (!path.closed) continue;
    const SheetPoint* const before = k > 0 ? &end_of(paths[k - 1]) : nullptr;
    const SheetPoint* const after = k + 1 < paths.size() ? &paths[k + 1].points.front() : nullptr;
    const auto around = [&](const SheetPoint& p) {
      return (before != nullptr ? way(*before, p) : 0.0) +
             (after != nullptr ? way(p, *after) : 0.0);
    };
    std::size_t best = 0;
    double least = around(path.points.front());
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      if (const double here = around(path.points[i]); here < least) {
        least = here;
        best = i;
      }
    }
    begin_at(path, best);
  }
}

}  // namespace

double travel(const std::vector<PenPath>& paths) {
  double sum = 0.0;
  for (std::size_t k = 1; k < paths.size(); ++k) {
    sum += way(end_of(paths[k - 1]), paths[k].points.front());
  }
  return sum;
}

void order_for_pen(std::vector<PenPath>& paths, const SheetPoint& from) {
  go_to_the_nearest(paths, from);
  const bool has_loops = std::ranges::any_of(paths, &PenPath::closed);
  for (int round = 0; round < (has_loops ? 3 : 1); ++round) {
    exchange(paths);
    if (has_loops) enter_loops_where_best(paths);
  }
}

}  // namespace displayfile
