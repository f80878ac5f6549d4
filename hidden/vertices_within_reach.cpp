#include "hidden/vertices_within_reach.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "clip/bounds.h"
#include "clip/secret_hash.h"
#include "hidden/extents.h"

namespace displayfile {

namespace {

constexpr std::uint32_t kNoPoint = std::numeric_limits<std::uint32_t>::max();

/// Points that stand for themselves, by cells of space that are many reaches wide.
class StandingPoints {
 public:
  StandingPoints(std::span<const Point3> points, double reach)
      : points_(points),
        reach_(reach),
        cell_(kReachesOfCell * reach),
        first_(std::bit_ceil(2 * points.size() + 1), kNoPoint),
        next_(points.size(), kNoPoint) {}

  /// Fills the cache for a point that is looked up soon.
  void prefetch(std::uint32_t point) const {
    const Point3& p = points_[point];
    __builtin_prefetch(&first_[place_of(reach_ > 0.0 ? cell(p) : p)]);
  }
  /// The first within reach of that one, or itself, which then stands for itself.
  std::uint32_t first_of(std::uint32_t point) {
    const Point3& p = points_[point];
    if (!(reach_ > 0.0)) return first_in(point, p, [&](const Point3& q) { return p == q; });
    const Point3 low = cell(p - reach_), high = cell(p + reach_);
    std::uint32_t first = kNoPoint;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      Point3 at = low;
      bool is_another = true;
      for (int axis = 0; axis < 3; ++axis) {
        if ((corner >> axis & 1) == 0) continue;
        is_another = is_another && high[axis] != low[axis];
        at[axis] = high[axis];
      }
      if (is_another) first = std::min(first, first_near(p, at));
    }
    if (first != kNoPoint) return first;
    stand(point, place_of(cell(p)));
    return point;
  }

 private:
  static constexpr double kReachesOfCell = 32.0;

  Point3 cell(const Point3& p) const { return glm::floor(p / cell_); }
  std::size_t place_of(const Point3& key) const { return hash_(key) & (first_.size() - 1); }
  void stand(std::uint32_t point, std::size_t place) {
    next_[point] = first_[place];
    first_[place] = point;
  }
  std::uint32_t first_near(const Point3& p, const Point3& cell_of_others) const {
    std::uint32_t first = kNoPoint;
    for (std::uint32_t k = first_[place_of(cell_of_others)]; k != kNoPoint; k = next_[k]) {
      if (k < first && glm::distance(points_[k], p) <= reach_) first = k;
    }
    return first;
  }
  template <class IsSame>
  std::uint32_t first_in(std::uint32_t point, const Point3& key, const IsSame& is_same) {
    const std::size_t place = place_of(key);
    for (std::uint32_t k = first_[place]; k != kNoPoint; k = next_[k]) {
      if (is_same(points_[k])) return k;
    }
    stand(point, place);
    return point;
  }

  std::span<const Point3> points_;
  double reach_, cell_;
  SecretHash hash_;
  std::vector<std::uint32_t> first_, next_;  // of each place; of the points in one
};

/// The axes along which the points spread, the widest first.
std::array<int, 3> axes_by_spread(std::span<const Point3> points) {
  Bounds bounds;
  for (const Point3& p : points) bounds.include(p);
  const Point3 size = bounds.high - bounds.low;
  std::array<int, 3> axes{0, 1, 2};
  std::ranges::sort(axes, [&](int a, int b) { return size[a] > size[b]; });
  return axes;
}

}  // namespace

std::vector<std::uint32_t> first_within(std::span<const Point3> points, double reach) {
  constexpr std::uint32_t kAhead = 16;  // while this many others are looked up, the cache fills
  StandingPoints standing(points, reach);
  std::vector<std::uint32_t> first(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (i + kAhead < points.size()) standing.prefetch(i + kAhead);
    first[i] = standing.first_of(i);
  }
  return first;
}

PartedSides::PartedSides(std::span<const Point3> points, std::span<const SideOfPoints> sides,
                         double reach) {
  if (sides.size() < 2) return;
  const std::array<int, 3> axes = axes_by_spread(points);
  const auto turned = [&](std::uint32_t point) {
    const Point3& p = points[point];
    return Point3(p[axes[0]], p[axes[1]], p[axes[2]]);
  };
  std::vector<std::uint32_t> ends;
  std::vector<Extent> boxes;
  for (const auto& [from, to] : sides) {
    ends.insert(ends.end(), {from, to});
    Extent box = Extent::nothing();
    box.include(turned(from), reach);
    box.include(turned(to), reach);
    boxes.push_back(box);
  }
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  struct OnSide {
    std::uint32_t side, vertex;
    double share;  ///< of the way along it
  };
  std::vector<OnSide> found;
  const ExtentTree tree = extent_tree(boxes, 1);
  for (const std::uint32_t vertex : ends) {
    Extent at = Extent::nothing();
    at.include(turned(vertex));
    const FlatBox box = FlatBox::of(at);
    tree.any([&](const FlatBoxes& of_sides) { return of_sides.meets(box); },
             [&](ExtentTree::Position position) {
               const std::uint32_t side = tree.order()[position];
               const auto& [from, to] = sides[side];
               if (vertex == from || vertex == to) return false;
               const Point3 way = points[to] - points[from], off = points[vertex] - points[from];
               const double share = glm::dot(off, way) / glm::dot(way, way);
               if (share > 0.0 && share < 1.0 && glm::length(off - share * way) <= reach) {
                 found.push_back({side, vertex, share});
               }
               return false;
             });
  }
  if (found.empty()) return;
  std::ranges::sort(found, [](const OnSide& a, const OnSide& b) {
    return a.side != b.side ? a.side < b.side : a.share < b.share;
  });
  first_.assign(sides.size() + 1, 0);
  for (const OnSide& on : found) {
    ++first_[on.side + 1];
    along_.push_back(on.vertex);
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

}  // namespace displayfile
