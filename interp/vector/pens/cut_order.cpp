#include "interp/vector/pens/cut_order.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

#include "clip/base/budgeted_work.h"
#include "hidden/boxes/extents.h"
#include "interp/vector/pens/pen_order.h"

namespace displayfile {

std::vector<PenPath> simple_paths(const std::vector<PenPath>& paths) {
  std::vector<PenPath> all;
  std::map<SheetPoint, std::size_t> place;  // of the points of the rest
  for (const PenPath& path : paths) {
    std::vector<SheetPoint> rest;
    place.clear();
    const std::size_t n = path.points.size() + (path.closed ? 1 : 0);
    for (std::size_t i = 0; i < n; ++i) {
      const SheetPoint& p = path.points[i % path.points.size()];
      const auto [at, is_new] = place.try_emplace(p, rest.size());
      if (is_new) {
        rest.push_back(p);
        continue;
      }
      const auto begin = rest.begin() + static_cast<std::ptrdiff_t>(at->second);
      PenPath loop{{begin, rest.end()}, rest.end() - begin > 2};
      if (!loop.closed) loop.points.push_back(p);  // there and back
      for (auto left = begin + 1; left != rest.end(); ++left) place.erase(*left);
      rest.erase(begin + 1, rest.end());
      all.push_back(std::move(loop));
    }
    const bool is_dot = path.points.size() == 1;
    if (rest.size() > 1 || is_dot) all.push_back({std::move(rest), false});
  }
  return all;
}

namespace {

enum class Side { outside, on, inside };

/// Twice a point, so that middles of sides are integers too.
SheetPoint doubled(const SheetPoint& p) { return {2 * p.x, 2 * p.y}; }
SheetPoint middle(const SheetPoint& p, const SheetPoint& q) { return {p.x + q.x, p.y + q.y}; }

/// The position of a doubled point relative to the contour, by the crossings to its right.
Side side_of(const SheetPoint& p, const PenPath& contour) {
  bool inside = false;
  const auto& points = contour.points;
  SheetPoint a = doubled(points.back());
  for (const SheetPoint& point : points) {
    const SheetPoint b = doubled(point);
    const std::int64_t turn = cross(a, b, a, p);
    const bool between = std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
                         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
    if (turn == 0 && between) return Side::on;
    if ((a.y <= p.y) != (b.y <= p.y) && (turn > 0) == (b.y > a.y)) inside = !inside;
    a = b;
  }
  return inside ? Side::inside : Side::outside;
}

bool contains(const PenPath& contour, const PenPath& path) {
  bool any_inside = false;
  const auto& points = path.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool has_side = i > 0 || path.closed;
    const SheetPoint& before = points[i > 0 ? i - 1 : points.size() - 1];
    for (const bool corner : {true, false}) {
      if (!corner && !has_side) continue;
      const Side side = side_of(corner ? doubled(points[i]) : middle(before, points[i]), contour);
      if (side == Side::outside) return false;
      any_inside = any_inside || side == Side::inside;
    }
  }
  return any_inside;
}

/// The bounding box, rounded outward to floats.
FlatBox box_of(const PenPath& path) {
  Extent box = Extent::nothing();
  for (const SheetPoint& p : path.points) box.include(Point3(p.x, p.y, 0.0));
  return FlatBox::of(box);
}

bool is_within(const FlatBox& box, const FlatBox& other) {
  return other.x_min <= box.x_min && box.x_max <= other.x_max && other.y_min <= box.y_min &&
         box.y_max <= other.y_max;
}

}  // namespace

std::vector<std::uint32_t> nesting_depths(const std::vector<PenPath>& paths) {
  std::vector<std::uint32_t> depths(paths.size(), 0), contours;
  std::vector<FlatBox> boxes, of_contours;
  for (std::uint32_t k = 0; k < paths.size(); ++k) {
    boxes.push_back(box_of(paths[k]));
    if (!paths[k].closed) continue;
    contours.push_back(k);
    of_contours.push_back(boxes.back());
  }
  if (contours.empty()) return depths;
  ExtentTree tree;
  tree.build(of_contours, 1);
  WorkSteps steps;
  for (std::uint32_t k = 0; k < paths.size(); ++k) {
    const FlatBox point{boxes[k].x_min, boxes[k].x_min, boxes[k].y_min, boxes[k].y_min};
    tree.any([&](const FlatBoxes& eight) { return eight.meets(point); },
             [&](ExtentTree::Position position) {
               const std::uint32_t contour = contours[tree.order()[position]];
               if (contour == k || !is_within(boxes[k], boxes[contour])) return false;
               steps.step(paths[contour].points.size());
               if (contains(paths[contour], paths[k])) ++depths[k];
               return false;
             });
  }
  return depths;
}

void order_for_cutting(std::vector<PenPath>& paths) {
  std::vector<PenPath> simple = simple_paths(paths);
  const std::vector<std::uint32_t> depths = nesting_depths(simple);
  std::map<std::uint32_t, std::vector<PenPath>, std::greater<>> by_depth;
  for (std::size_t k = 0; k < simple.size(); ++k)
    by_depth[depths[k]].push_back(std::move(simple[k]));
  paths.clear();
  SheetPoint pen{0, 0};
  for (auto& [depth, of_depth] : by_depth) {
    order_for_pen(of_depth, pen);
    const PenPath& last = of_depth.back();
    pen = last.closed ? last.points.front() : last.points.back();
    std::ranges::move(of_depth, std::back_inserter(paths));
  }
}

}  // namespace displayfile
