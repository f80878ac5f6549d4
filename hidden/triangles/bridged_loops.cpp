#include "hidden/triangles/bridged_loops.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "clip/geometry/corners.h"
#include "hidden/triangles/ear_cutting.h"

namespace displayfile {

namespace {

constexpr std::uint32_t kNoPartner = 0xFFFFFFFFu;

bool comes_before(const Point2& p, const Point2& q) {
  return std::tie(p.x, p.y) < std::tie(q.x, q.y);
}

/// A side without its direction.
struct Ends {
  Point2 low, high;
  bool leads_up;

  Ends(std::span<const Point2> polygon, std::uint32_t side)
      : low(polygon[side]),
        high(polygon[next_corner(side, static_cast<std::uint32_t>(polygon.size()))]),
        leads_up(comes_before(low, high)) {
    if (!leads_up) std::swap(low, high);
  }
  auto key() const { return std::tie(low.x, low.y, high.x, high.y); }
};

}  // namespace

void BridgedLoops::match_sides(std::span<const Point2> polygon) {
  const auto n = static_cast<std::uint32_t>(polygon.size());
  sides_.resize(n);
  for (std::uint32_t k = 0; k < n; ++k) sides_[k] = k;
  std::ranges::sort(sides_, [&](std::uint32_t a, std::uint32_t b) {
    const Ends p(polygon, a), q(polygon, b);
    if (p.key() != q.key()) return p.key() < q.key();
    return p.leads_up != q.leads_up ? q.leads_up : a < b;
  });
  partner_.assign(n, kNoPartner);
  for (std::size_t first = 0, last = 0; first < n; first = last) {
    const Ends ends(polygon, sides_[first]);
    std::size_t up = first;  // the first that leads up
    for (; last < n; ++last) {
      const Ends other(polygon, sides_[last]);
      if (other.key() != ends.key()) break;
      if (!other.leads_up) up = last + 1;
    }
    if (ends.low == ends.high) continue;
    for (std::size_t down = first; down < up && up + (down - first) < last; ++down) {
      const std::uint32_t there = sides_[down], back = sides_[up + (down - first)];
      partner_[there] = back;
      partner_[back] = there;
    }
  }
}

bool BridgedLoops::find(std::span<const Point2> polygon) {
  any_turned_ = false;
  if (polygon.size() < kFewestCorners) return false;
  match_sides(polygon);
  const auto n = static_cast<std::uint32_t>(polygon.size());
  if (std::ranges::all_of(partner_, [](auto partner) { return partner == kNoPartner; })) {
    return false;
  }
  next_.assign(n, kInNoLoop);
  for (std::uint32_t side = 0; side < n; ++side) {
    if (partner_[side] != kNoPartner) continue;
    // Where a bridge begins, the loop goes on after the bridge back. The corner is the end of the
    // side before it, whose visibility is stored with it.
    const std::uint32_t corner = next_corner(side, n);
    std::uint32_t following = corner;
    while (partner_[following] != kNoPartner) {
      following = next_corner(partner_[following], n);
    }
    next_[corner] = next_corner(following, n);
  }
  return true;
}

/// By the middle of the side that begins at the corner.
bool BridgedLoops::has_odd_around(std::span<const Point2> polygon, std::uint32_t corner) const {
  const Point2 middle = 0.5 * polygon[corner] + 0.5 * polygon[next_[corner]];
  bool is_odd = false;
  for (std::uint32_t k = 0; k < next_.size(); ++k) {
    if (next_[k] == kInNoLoop || loop_of_[k] == loop_of_[corner]) continue;
    const Point2 &p = polygon[k], &q = polygon[next_[k]];
    if ((p.y > middle.y) == (q.y > middle.y)) continue;
    if (middle.x < p.x + (q.x - p.x) * (middle.y - p.y) / (q.y - p.y)) is_odd = !is_odd;
  }
  return is_odd;
}

void BridgedLoops::turn(std::span<const Point2> polygon) {
  const auto n = static_cast<std::uint32_t>(polygon.size());
  loop_of_.assign(n, kInNoLoop);
  std::vector<std::uint32_t> first_corners;
  std::vector<double> areas;
  for (std::uint32_t k = 0; k < n; ++k) {
    if (next_[k] == kInNoLoop || loop_of_[k] != kInNoLoop) continue;
    const Point2& origin = polygon[k];
    double area = 0.0;
    for (std::uint32_t v = k; loop_of_[v] == kInNoLoop; v = next_[v]) {
      loop_of_[v] = static_cast<std::uint32_t>(first_corners.size());
      const Point2 p = polygon[v] - origin, q = polygon[next_[v]] - origin;
      area += p.x * q.y - q.x * p.y;
    }
    first_corners.push_back(k);
    areas.push_back(area);
  }
  std::vector<char> is_hole;  // of each, before any is turned
  is_hole.reserve(first_corners.size());
  for (const std::uint32_t corner : first_corners) {
    is_hole.push_back(has_odd_around(polygon, corner) ? 1 : 0);
  }
  for (std::size_t loop = 0; loop < first_corners.size(); ++loop) {
    if ((areas[loop] < 0.0) == (is_hole[loop] != 0)) continue;
    any_turned_ = true;
    const std::uint32_t first = first_corners[loop];
    std::uint32_t from = first, to = next_[first];
    do {
      const std::uint32_t after = next_[to];
      next_[to] = from;
      from = to;
      to = after;
    } while (from != first);
  }
}

}  // namespace displayfile
