#include "hidden/map/ways_from_vertex.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "hidden/exact/orientation.h"
#include "hidden/exact/rounding.h"

namespace displayfile {

bool WaysFromVertex::comes_before(std::uint32_t vertex, std::uint32_t back, std::uint32_t p,
                                  std::uint32_t q) const {
  assert(vertex != back && vertex != p && vertex != q);
  // Right of the way back, straight on from it, left of it, and along it.
  const auto quarter = [&](std::uint32_t to) {
    const int side = turn(vertex, back, to);
    if (side != 0) return side < 0 ? 0 : 2;
    return is_same_way(vertex, back, to) ? 3 : 1;
  };
  const int of_p = quarter(p), of_q = quarter(q);
  if (of_p != of_q) return of_p < of_q;
  return of_p % 2 == 0 && turn(vertex, p, q) < 0;
}

int WaysFromVertex::turn(std::uint32_t vertex, std::uint32_t p, std::uint32_t q) const {
  const Point2 &v = map_.points[vertex], &to_p = map_.points[p], &to_q = map_.points[q];
  const Point2 a = to_p - v, b = to_q - v;
  const double turn = a.x * b.y - a.y * b.x;
  // Each coordinate is off by half an ulp, so that a difference is off by two of the largest at
  // most.
  const double ulp = kUnit * std::max({std::abs(v.x), std::abs(v.y), std::abs(to_p.x),
                                       std::abs(to_p.y), std::abs(to_q.x), std::abs(to_q.y)});
  const double lengths = std::abs(a.x) + std::abs(a.y) + std::abs(b.x) + std::abs(b.y);
  if (std::abs(turn) > 16.0 * ulp * (lengths + 4.0 * ulp) + kTiny) return turn > 0.0 ? 1 : -1;
  return orientation(scene(), map_.places[vertex], map_.places[p], map_.places[q]);
}

bool WaysFromVertex::is_same_way(std::uint32_t vertex, std::uint32_t p, std::uint32_t q) const {
  const auto order = [&](std::uint32_t to) {
    return compare_xy(scene(), map_.places[vertex], map_.places[to]);
  };
  return order(p) == order(q);
}

const LineTable& WaysFromVertex::scene() const {
  if (!scene_) scene_.emplace(items_, std::span<const LineName>(), 1);
  return *scene_;
}

}  // namespace displayfile
