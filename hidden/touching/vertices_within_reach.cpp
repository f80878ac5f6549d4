#include "hidden/touching/vertices_within_reach.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <compare>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numeric>
#include <tuple>

#include "clip/geometry/bounds.h"
#include "clip/geometry/secret_hash.h"
#include "hidden/disjoint_sets.h"
#include "hidden/touching/key_grid.h"

namespace displayfile {

namespace {

constexpr std::uint32_t kNoPoint = std::numeric_limits<std::uint32_t>::max();

/// For each point, the first that is equal to it.
std::vector<std::uint32_t> first_equal(std::span<const Point3> points) {
  const SecretHash hash;
  const std::size_t places = std::bit_ceil(2 * points.size() + 1);
  std::vector<std::uint32_t> table(places, kNoPoint), first(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::size_t at = hash(points[i]) & (places - 1);
    while (table[at] != kNoPoint && points[table[at]] != points[i]) at = (at + 1) & (places - 1);
    if (table[at] == kNoPoint) table[at] = i;
    first[i] = table[at];
  }
  return first;
}

/// Representatives, by cells of space that are many reaches wide.
class StandingPoints {
 public:
  StandingPoints(std::span<const Point3> points, double reach)
      : points_(points),
        reach_(reach),
        per_cell_(1.0 / (kReachesOfCell * reach)),
        first_(std::bit_ceil(2 * points.size() + 1), kNoPoint),
        next_(points.size(), kNoPoint) {}

  /// The first representative within reach of the point, or the point, which then becomes one.
  std::uint32_t first_of(std::uint32_t point) {
    const Point3& p = points_[point];
    const Point3 in_cells = p * per_cell_, own = glm::floor(in_cells);
    std::uint32_t first = first_near(p, own);
    const Point3 off = in_cells - own;
    const auto is_inside = [](double x) { return x > kReach && x < 1.0 - kReach; };
    if (!is_inside(off.x) || !is_inside(off.y) || !is_inside(off.z)) {
      first = std::min(first, first_in_neighbours(p, own, off));
    }
    if (first != kNoPoint) return first;
    stand(point, place_of(own));
    return point;
  }

 private:
  static constexpr double kReachesOfCell = 32.0;
  static constexpr double kReach = 1.5 / kReachesOfCell;  // in cells, with a margin for rounding

  std::size_t place_of(const Point3& key) const { return hash_(key) & (first_.size() - 1); }
  void stand(std::uint32_t point, std::size_t place) {
    next_[point] = first_[place];
    first_[place] = point;
  }
  /// Searches the neighbouring cells into which the reach extends.
  std::uint32_t first_in_neighbours(const Point3& p, const Point3& own, const Point3& off) const {
    std::uint32_t first = kNoPoint;
    glm::ivec3 low(0), high(0);
    for (int axis = 0; axis < 3; ++axis) {
      if (off[axis] <= kReach) low[axis] = -1;
      if (off[axis] >= 1.0 - kReach) high[axis] = 1;
    }
    for (int x = low.x; x <= high.x; ++x) {
      for (int y = low.y; y <= high.y; ++y) {
        for (int z = low.z; z <= high.z; ++z)
          first = std::min(first, first_near(p, own + Point3(x, y, z)));
      }
    }
    return first;
  }
  std::uint32_t first_near(const Point3& p, const Point3& cell_of_others) const {
    std::uint32_t first = kNoPoint;
    for (std::uint32_t k = first_[place_of(cell_of_others)]; k != kNoPoint; k = next_[k]) {
      if (k < first && glm::distance(points_[k], p) <= reach_) first = k;
    }
    return first;
  }
  std::span<const Point3> points_;
  double reach_, per_cell_;
  SecretHash hash_;
  std::vector<std::uint32_t> first_, next_;  // per hash place; per point, the next in its place
};

/// Sides that may lie along each other, since their lines pass a given point at nearly the same
/// place.
class SidesOfLines {
 public:
  SidesOfLines(std::span<const Point3> points, std::span<const SideOfPoints> sides, double reach)
      : points_(points), sides_(sides), lines_(sides.size()) {
    Bounds bounds;
    for (const auto& [from, to] : sides) bounds.include(points[from]), bounds.include(points[to]);
    const Point3 size = bounds.high - bounds.low;
    // An arbitrary point, which no line is meant to contain.
    from_ = bounds.low + Point3(0.6180, 0.2716, 0.4142) * size;
    diameter_ = glm::length(size);
    if (!(diameter_ > 0.0 && diameter_ <= std::numeric_limits<double>::max())) return;
    find_keys(reach);
    join();
  }

  /// Calls visit(sides) for the sides of each line that has more than one.
  template <class Visit>
  void for_each(const Visit& visit) {
    std::vector<std::uint32_t> order(sides_.size()), name(sides_.size());
    std::iota(order.begin(), order.end(), 0u);
    for (std::uint32_t k = 0; k < order.size(); ++k) name[k] = lines_.name(k);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t k) { return name[k]; });
    for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
      while (end < order.size() && name[order[end]] == name[order[first]]) ++end;
      if (end - first > 1) visit(std::span(order).subspan(first, end - first));
    }
  }

 private:
  /// The key is the point of the side's line closest to from_, in diameters. The tolerance is twice
  /// the maximum difference of keys for a side with both ends within reach, and rounding.
  void find_keys(double reach) {
    constexpr double kRounding = 0x1p-44;
    keys_.reserve(sides_.size());
    tolerances_.reserve(sides_.size());
    for (const auto& [a, b] : sides_) {
      const Point3 way = points_[b] - points_[a], off = points_[a] - from_;
      const double length = glm::length(way);
      const Point3 closest = off - glm::dot(off, way) / (length * length) * way;
      const Point3 key = length > 0.0 ? 2.0 + closest / diameter_ : Point3(0.0);
      keys_.push_back({key.x, key.y, key.z});
      tolerances_.push_back(2.0 * (reach / diameter_ + 4.0 * reach / length +
                                   kRounding * (1.0 + diameter_ / length)));
    }
  }
  /// If very many sides have nearly the same keys, each is joined to some of the others only, and
  /// these to each other.
  void join() {
    constexpr std::size_t kMost = 32;
    KeyGrid grid(tolerances_);
    for (std::uint32_t k = 0; k < sides_.size(); ++k) grid.insert(k, keys_[k]);
    for (std::uint32_t k = 0; k < sides_.size(); ++k) {
      const double tolerance = tolerances_[k];
      if (!grid.has_size_for(tolerance)) continue;
      std::size_t joined = 0;
      grid.visit_near(keys_[k], tolerance, [&](std::uint32_t other) {
        if (other == k || !are_near(k, other, tolerance)) return true;
        lines_.join(k, other);
        return ++joined < kMost;
      });
    }
  }
  bool are_near(std::uint32_t a, std::uint32_t b, double tolerance) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (std::abs(keys_[a][i] - keys_[b][i]) > tolerance) return false;
    }
    return true;
  }

  std::span<const Point3> points_;
  std::span<const SideOfPoints> sides_;
  Point3 from_{0.0};
  double diameter_ = 0.0;
  std::vector<KeyGrid::Keys> keys_;
  std::vector<double> tolerances_;
  DisjointSets lines_;
};

struct OnSide {
  std::uint32_t side, vertex;
  double share;  ///< fraction of the side's length
};

/// Adds the ends of these sides that are between the ends of another of them, and within reach of
/// it.
void find_along(std::span<const Point3> points, std::span<const SideOfPoints> all,
                std::span<const std::uint32_t> sides, double reach, std::vector<OnSide>& found) {
  Point3 along(0.0);  // direction of the longest
  for (const std::uint32_t k : sides) {
    const Point3 way = points[all[k].to] - points[all[k].from];
    if (glm::length(way) > glm::length(along)) along = way;
  }
  struct End {
    double place;
    std::uint32_t vertex;
    auto operator<=>(const End&) const = default;
  };
  const auto end_at = [&](std::uint32_t vertex) {
    return End{glm::dot(points[vertex], along) / glm::length(along), vertex};
  };
  std::vector<End> ends;
  for (const std::uint32_t k : sides) {
    ends.insert(ends.end(), {end_at(all[k].from), end_at(all[k].to)});
  }
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (const std::uint32_t k : sides) {
    const auto& [from, to] = all[k];
    const Point3 way = points[to] - points[from];
    // A short side may differ in direction from the longest: its ends are then not decisive.
    const double a = end_at(from).place, b = end_at(to).place;
    const double low = std::min(a, b), high = std::max(a, b);
    const auto last = std::ranges::upper_bound(ends, high + reach, {}, &End::place);
    for (auto at = std::ranges::lower_bound(ends, low - reach, {}, &End::place); at != last; ++at) {
      if (at->vertex == from || at->vertex == to) continue;
      const Point3 off = points[at->vertex] - points[from];
      const double share = glm::dot(off, way) / glm::dot(way, way);
      if (share > 0.0 && share < 1.0 && glm::length(off - share * way) <= reach) {
        found.push_back({k, at->vertex, share});
      }
    }
  }
}

}  // namespace

std::vector<std::uint32_t> first_within(std::span<const Point3> points, double reach) {
  if (!(reach > 0.0)) return first_equal(points);
  StandingPoints standing(points, reach);
  std::vector<std::uint32_t> first(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    first[i] = standing.first_of(i);
    assert(first[i] <= i && first[first[i]] == first[i]);
  }
  return first;
}

PartedSides::PartedSides(std::span<const Point3> points, std::span<const SideOfPoints> sides,
                         double reach) {
  if (sides.size() < 2) return;
  std::vector<OnSide> found;
  SidesOfLines(points, sides, reach).for_each([&](std::span<const std::uint32_t> of_line) {
    find_along(points, sides, of_line, reach, found);
  });
  if (found.empty()) return;
  std::ranges::sort(found, [](const OnSide& a, const OnSide& b) {
    return std::tie(a.side, a.share) < std::tie(b.side, b.share);
  });
  first_.assign(sides.size() + 1, 0);
  for (const OnSide& on : found) {
    ++first_[on.side + 1];
    along_.push_back(on.vertex);
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  assert(first_.back() == along_.size());
}

}  // namespace displayfile
