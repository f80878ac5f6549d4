#include "interp/vector/tents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

#include "clip/point.h"

namespace displayfile {

namespace {

Point2 point_of(const LatticePoint& p) { return {p.x, p.y}; }

/// A side with the loop that has it.
struct SideOfLoop {
  LatticeSide side;
  std::uint32_t region;
  std::uint32_t loop;
  friend auto operator<=>(const SideOfLoop&, const SideOfLoop&) = default;
};

/// Sorted. A side that a region runs along in both directions is omitted.
std::vector<SideOfLoop> sides_of_loops(std::span<const FigureRegion> regions) {
  std::vector<SideOfLoop> sides;
  for (std::uint32_t r = 0; r < regions.size(); ++r) {
    const LatticeLoops& loops = regions[r].loops;
    for (std::uint32_t k = 0; k < loops.size(); ++k) {
      for_each_side(loops.loop(k), [&](const LatticePoint& from, const LatticePoint& to) {
        sides.push_back({LatticeSide(from, to), r, k});
      });
    }
  }
  std::ranges::sort(sides);
  std::vector<SideOfLoop> odd;
  for (const SideOfLoop& one : sides) {
    if (!odd.empty() && odd.back().side == one.side && odd.back().region == one.region) {
      odd.pop_back();
    } else {
      odd.push_back(one);
    }
  }
  return odd;
}

/// The largest height of a triangle over the side, to its left (`left` = 1) or right (-1), that
/// stays within the loop. It is limited by vertices, and by sides at its top, toward which it is
/// convex.
double room_over(const LatticeSide& side, double left, std::span<const LatticePoint> loop,
                 double most) {
  const Point2 p = point_of(side.a), along = point_of(side.b) - p;
  const double length = glm::length(along);
  struct Place {
    double t, height;  // along the side, 0 to 1, and over it
  };
  const auto place = [&](const LatticePoint& v) -> Place {
    const Point2 way = point_of(v) - p;
    return {(way.x * along.x + way.y * along.y) / (length * length),
            left * (along.x * way.y - along.y * way.x) / length};
  };
  double room = most;
  LatticePoint last = loop.back();
  Place from = place(last);
  for (const LatticePoint& v : loop) {
    const Place to = place(v);
    if (!(LatticeSide(last, v) == side)) {
      if (to.t > 0.0 && to.t < 1.0 && to.height >= 0.0) {
        room = std::min(room, to.height / (2.0 * std::min(to.t, 1.0 - to.t)));
      }
      if ((from.t < 0.5) != (to.t < 0.5)) {
        const double height =
            from.height + (0.5 - from.t) / (to.t - from.t) * (to.height - from.height);
        if (height >= 0.0) room = std::min(room, height);
      }
    }
    last = v;
    from = to;
  }
  return room;
}

/// The fraction of the room that is used, because the top is rounded.
constexpr double kPartOfRoom = 0.8;

void add_tent(LatticeLoops& triangles, const LatticeSide& side, double left, double room) {
  const Point2 p = point_of(side.a), along = point_of(side.b) - p;
  const Point2 up = left / glm::length(along) * Point2(-along.y, along.x);
  const Point2 top = p + 0.5 * along + kPartOfRoom * room * up;
  const LatticePoint rounded{static_cast<std::int32_t>(std::lround(top.x)),
                             static_cast<std::int32_t>(std::lround(top.y))};
  if (left > 0.0) {
    triangles.add(std::array{side.a, side.b, rounded});
  } else {
    triangles.add(std::array{side.b, side.a, rounded});
  }
}

}  // namespace

std::vector<FigureTents> tents_of(std::span<const FigureRegion> regions, double reach) {
  const std::vector<SideOfLoop> sides = sides_of_loops(regions);
  std::vector<LatticeLoops> of_regions(regions.size());
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (sides[i].side != sides[i + 1].side) continue;
    for (const double left : {1.0, -1.0}) {
      double room = reach;
      for (const SideOfLoop& one : std::span(sides).subspan(i, 2)) {
        room = room_over(one.side, left, regions[one.region].loops.loop(one.loop), room);
      }
      add_tent(of_regions[sides[i].region], sides[i].side, left, room);
    }
    ++i;
  }
  std::vector<FigureTents> tents;
  for (std::size_t r = regions.size(); r-- > 0;) {
    const LatticeLoops& all = of_regions[r];
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (k % (Figure::kMostVertices / 3) == 0)
        tents.push_back({regions[r].segment, regions[r].paint, {}});
      tents.back().triangles.add(all.loop(k));
    }
  }
  return tents;
}

}  // namespace displayfile
