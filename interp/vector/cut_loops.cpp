#include "interp/vector/cut_loops.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

namespace displayfile {

namespace {

using Coordinate = std::int32_t LatticePoint::*;

/// The points whose coordinate `across` is `at`: a column or a row.
struct Cut {
  Coordinate across, along;
  std::int32_t at;

  int side_of(const LatticePoint& p) const { return p.*across < at ? -1 : p.*across > at; }
  bool crosses(const LatticePoint& p, const LatticePoint& q) const {
    return side_of(p) * side_of(q) < 0;
  }
  LatticePoint point(std::int32_t place) const {
    LatticePoint p{};
    p.*across = at;
    p.*along = place;
    return p;
  }
};

/// The lattice point nearest to where the side crosses the cut, the same for both directions of the
/// side.
LatticePoint crossing(const LatticeSide& side, const Cut& cut) {
  using Wide = std::int64_t;
  const auto [low, high] = std::minmax(
      side.a, side.b, [&](const auto& p, const auto& q) { return p.*cut.across < q.*cut.across; });
  const Wide run = Wide{high.*cut.across} - low.*cut.across;
  // Differences have 31 bits at most: the product fits.
  const Wide product = (Wide{high.*cut.along} - low.*cut.along) * (Wide{cut.at} - low.*cut.across);
  Wide rise = product / run;
  Wide rest = product % run;
  if (rest < 0) {
    rest += run;
    --rise;
  }
  if (2 * rest >= run) ++rise;
  return cut.point(static_cast<std::int32_t>(low.*cut.along + rise));
}

/// A cut through the median vertex, with vertices on both sides; none if they are within one unit.
std::optional<Cut> middle_cut(const LatticeLoops& loops, Coordinate across, Coordinate along) {
  std::vector<std::int32_t> places;
  places.reserve(loops.points.size());
  for (const LatticePoint& p : loops.points) places.push_back(p.*across);
  const auto [low, high] = std::ranges::minmax(places);
  if (high - std::int64_t{low} < 2) return std::nullopt;
  const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
  std::nth_element(places.begin(), middle, places.end());
  return Cut{across, along, std::clamp(*middle, low + 1, high - 1)};
}

std::size_t crossed_by(const LatticeLoops& loops, const Cut& cut) {
  std::size_t crossed = 0;
  for_each_side(loops, [&](const LatticePoint& p, const LatticePoint& q) {
    if (cut.crosses(p, q)) ++crossed;
  });
  return crossed;
}

/// The cut, by column or by row, that crosses fewer sides. One exists: at most four vertices are
/// within one unit in both directions, joined by six sides.
Cut best_cut(const LatticeLoops& loops) {
  const auto column = middle_cut(loops, &LatticePoint::x, &LatticePoint::y);
  const auto row = middle_cut(loops, &LatticePoint::y, &LatticePoint::x);
  if (!column) return row.value();
  if (!row) return *column;
  return crossed_by(loops, *column) <= crossed_by(loops, *row) ? *column : *row;
}

/// The vertices of the loops on the cut, in order, without duplicates: existing ones, and crossings
/// of sides.
std::vector<LatticePoint> vertices_on(const Cut& cut, const LatticeLoops& loops,
                                      VerticesOnSides& put) {
  std::vector<LatticePoint> there;
  for_each_side(loops, [&](const LatticePoint& from, const LatticePoint& to) {
    if (cut.side_of(to) == 0) there.push_back(to);
    if (!cut.crosses(from, to)) return;
    const LatticeSide side(from, to);
    there.push_back(put.emplace(side, crossing(side, cut)).first->second);
  });
  std::ranges::sort(there);
  there.erase(std::unique(there.begin(), there.end()), there.end());
  return there;
}

/// Adds the vertices of the cut that are inside sides along it.
void put_on_sides_along(const Cut& cut, const LatticeLoops& loops,
                        std::span<const LatticePoint> there, VerticesOnSides& put) {
  for_each_side(loops, [&](const LatticePoint& from, const LatticePoint& to) {
    if (cut.side_of(from) != 0 || cut.side_of(to) != 0) return;
    const LatticeSide side(from, to);
    LatticePoint last = side.a;
    for (auto v = std::ranges::upper_bound(there, side.a); v != there.end() && *v < side.b; ++v) {
      put.emplace(LatticeSide(last, side.b), *v);
      last = *v;
    }
  });
}

/// The half of a loop on one side of a cut: where the loop was beyond the cut, it runs along it
/// through its vertices.
class HalfOfLoop {
 public:
  HalfOfLoop(const Cut& cut, int half, std::span<const LatticePoint> there)
      : cut_(cut), half_(half), there_(there) {}

  std::vector<LatticePoint> of(std::span<const LatticePoint> loop) {
    kept_.clear();
    for (const LatticePoint& p : loop) {
      if (cut_.side_of(p) == -half_) continue;
      add(p);
    }
    if (!kept_.empty()) run_along(kept_.back(), kept_.front());
    return std::move(kept_);
  }

 private:
  void add(const LatticePoint& p) {
    if (!kept_.empty()) run_along(kept_.back(), p);
    kept_.push_back(p);
  }
  /// Adds the vertices between two points of the cut. Other points are already joined by a side.
  void run_along(LatticePoint from, LatticePoint to) {
    if (cut_.side_of(from) != 0 || cut_.side_of(to) != 0) return;
    const auto [low, high] = std::minmax(from, to);
    const auto first = std::ranges::upper_bound(there_, low);
    const auto end = std::ranges::lower_bound(there_, high);
    if (first >= end) return;
    if (from < to) {
      kept_.insert(kept_.end(), first, end);
    } else {
      kept_.insert(kept_.end(), std::make_reverse_iterator(end), std::make_reverse_iterator(first));
    }
  }

  const Cut& cut_;
  int half_;
  std::span<const LatticePoint> there_;
  std::vector<LatticePoint> kept_;
};

/// The part on one side of the cut, of loops that have all vertices on it. Sides that run along the
/// cut twice are removed.
LatticeLoops half_of(const LatticeLoops& loops, const Cut& cut, int half,
                     std::span<const LatticePoint> there) {
  HalfOfLoop half_of_loop(cut, half, there);
  std::vector<std::vector<LatticePoint>> halves;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    halves.push_back(half_of_loop.of(loops.loop(k)));
  }
  const std::vector<std::span<const LatticePoint>> spans(halves.begin(), halves.end());
  return boundary_of(spans);
}

}  // namespace

std::vector<LatticeLoops> parts_of(const LatticeLoops& loops, std::size_t most,
                                   VerticesOnSides& put) {
  std::vector<LatticeLoops> parts, pending{loops};
  while (!pending.empty()) {
    LatticeLoops part = std::move(pending.back());
    pending.pop_back();
    // A side of a cut that was cut again in one of its parts is one of the other's too.
    put_vertices(part, put);
    if (part.points.size() <= most) {
      if (!part.empty()) parts.push_back(std::move(part));
      continue;
    }
    const Cut cut = best_cut(part);
    const std::vector<LatticePoint> there = vertices_on(cut, part, put);
    put_on_sides_along(cut, part, there, put);
    put_vertices(part, put);
    pending.push_back(half_of(part, cut, 1, there));
    pending.push_back(half_of(part, cut, -1, there));
  }
  return parts;
}

void put_vertices(LatticeLoops& loops, const VerticesOnSides& put) {
  if (put.empty()) return;
  LatticeLoops with;
  with.points.reserve(loops.points.size());
  std::vector<LatticePoint> ahead;  // of what is still to be run along, the nearest last
  for (std::size_t k = 0; k < loops.size(); ++k) {
    LatticePoint from = loops.loop(k).back();
    for (const LatticePoint& to : loops.loop(k)) {
      ahead.push_back(to);
      while (!ahead.empty()) {
        const auto on_the_way = put.find(LatticeSide(from, ahead.back()));
        if (on_the_way != put.end()) {
          ahead.push_back(on_the_way->second);
          continue;
        }
        from = ahead.back();
        ahead.pop_back();
        with.points.push_back(from);
      }
    }
    with.close();
  }
  loops = std::move(with);
}

}  // namespace displayfile
