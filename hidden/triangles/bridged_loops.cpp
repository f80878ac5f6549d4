#include "hidden/triangles/bridged_loops.h"

#include <algorithm>
#include <cmath>
#include <optional>
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

/// The tolerance for coordinates that were computed as differently as those of flush faces are.
double rounding_of(std::span<const Point2> polygon) {
  constexpr double kRelative = 0x1p-44;
  double largest = 0.0;
  for (const Point2& p : polygon) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return kRelative * largest;
}

/// True if p is within reach of the segment from a to b.
bool is_within(double reach, const Point2& p, const Point2& a, const Point2& b) {
  if (std::max(a.x, b.x) + reach < p.x || p.x < std::min(a.x, b.x) - reach ||
      std::max(a.y, b.y) + reach < p.y || p.y < std::min(a.y, b.y) - reach) {
    return false;
  }
  const Point2 along = b - a, to_p = p - a;
  return std::abs(along.x * to_p.y - along.y * to_p.x) <= reach * std::hypot(along.x, along.y);
}

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

/// By the middle of the side that begins at the corner; nothing if that is within rounding of
/// another loop.
std::optional<bool> BridgedLoops::has_odd_around(std::span<const Point2> polygon,
                                                 std::uint32_t corner, double reach) const {
  const Point2 middle = 0.5 * polygon[corner] + 0.5 * polygon[next_[corner]];
  bool is_odd = false;
  for (std::uint32_t k = 0; k < next_.size(); ++k) {
    if (next_[k] == kInNoLoop || loop_of_[k] == loop_of_[corner]) continue;
    const Point2 &p = polygon[k], &q = polygon[next_[k]];
    if (is_within(reach, middle, p, q)) return std::nullopt;
    if ((p.y > middle.y) == (q.y > middle.y)) continue;
    if (middle.x < p.x + (q.x - p.x) * (middle.y - p.y) / (q.y - p.y)) is_odd = !is_odd;
  }
  return is_odd;
}

/// By the first side that no other loop follows: where a hole ends flush with an outline, rounding
/// may put its side on either side of the outline's. Nothing if each side has another beside it.
std::optional<bool> BridgedLoops::is_hole(std::span<const Point2> polygon, std::uint32_t first,
                                          double reach) const {
  std::uint32_t corner = first;
  do {
    if (const auto is_odd = has_odd_around(polygon, corner, reach)) return is_odd;
    corner = next_[corner];
  } while (corner != first);
  return std::nullopt;
}

/// Notes the loop that begins at the corner. Twice its area, or 0 if rounding leaves no direction.
double BridgedLoops::area_of_loop(std::span<const Point2> polygon, std::uint32_t first,
                                  double reach) {
  double area = 0.0, length = 0.0;
  for (std::uint32_t v = first; loop_of_[v] == kInNoLoop; v = next_[v]) {
    loop_of_[v] = first;
    const Point2 p = polygon[v] - polygon[first], q = polygon[next_[v]] - polygon[first];
    area += p.x * q.y - q.x * p.y;
    length += std::hypot(q.x - p.x, q.y - p.y);
  }
  return std::abs(area) <= 2.0 * reach * length ? 0.0 : area;
}

void BridgedLoops::reverse(std::uint32_t first) {
  std::uint32_t from = first, to = next_[first];
  do {
    const std::uint32_t after = next_[to];
    next_[to] = from;
    from = to;
    to = after;
  } while (from != first);
}

void BridgedLoops::turn(std::span<const Point2> polygon) {
  const auto n = static_cast<std::uint32_t>(polygon.size());
  const double reach = rounding_of(polygon);
  struct Loop {
    std::uint32_t first;
    bool runs_as_hole;
  };
  std::vector<Loop> loops;
  loop_of_.assign(n, kInNoLoop);
  for (std::uint32_t k = 0; k < n; ++k) {
    if (next_[k] == kInNoLoop || loop_of_[k] != kInNoLoop) continue;
    const double area = area_of_loop(polygon, k, reach);
    if (area != 0.0) loops.push_back({k, area < 0.0});
  }
  std::erase_if(loops, [&](const Loop& loop) {
    return is_hole(polygon, loop.first, reach).value_or(loop.runs_as_hole) == loop.runs_as_hole;
  });
  any_turned_ = !loops.empty();
  for (const Loop& loop : loops) reverse(loop.first);
}

}  // namespace displayfile
