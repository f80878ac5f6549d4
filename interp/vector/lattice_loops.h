#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace displayfile {

/// A point in integer units of a stated precision, y down, from the picture's top left corner.
struct LatticePoint {
  std::int32_t x, y;
  friend auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

/// Closed loops, filled by the even-odd rule.
struct LatticeLoops {
  std::vector<LatticePoint> points;  ///< one loop after another
  std::vector<std::size_t> ends;     ///< of each loop

  std::size_t size() const { return ends.size(); }
  bool empty() const { return ends.empty(); }
  std::span<const LatticePoint> loop(std::size_t i) const {
    const std::size_t first = i == 0 ? 0 : ends[i - 1];
    return std::span(points).subspan(first, ends[i] - first);
  }
  void close() { ends.push_back(points.size()); }
  void add(std::span<const LatticePoint> loop) {
    points.insert(points.end(), loop.begin(), loop.end());
    close();
  }
};

/// Lines from vertex to vertex, closed or open.
struct LatticeChains {
  std::vector<LatticePoint> points;  ///< one chain after another
  std::vector<std::size_t> ends;     ///< of each chain
  std::vector<bool> closed;

  std::size_t size() const { return ends.size(); }
  std::span<const LatticePoint> chain(std::size_t i) const {
    const std::size_t first = i == 0 ? 0 : ends[i - 1];
    return std::span(points).subspan(first, ends[i] - first);
  }
};

/// A side, independent of its direction.
struct LatticeSide {
  LatticePoint a, b;  ///< a < b
  LatticeSide(const LatticePoint& p, const LatticePoint& q) : a(p < q ? p : q), b(p < q ? q : p) {}
  friend auto operator<=>(const LatticeSide&, const LatticeSide&) = default;
};

/// Calls visit(from, to) for each side, in its direction.
template <class Visit>
void for_each_side(std::span<const LatticePoint> loop, Visit&& visit) {
  if (loop.empty()) return;
  LatticePoint from = loop.back();
  for (const LatticePoint& to : loop) {
    visit(from, to);
    from = to;
  }
}
template <class Visit>
void for_each_side(const LatticeLoops& loops, Visit&& visit) {
  for (std::size_t k = 0; k < loops.size(); ++k) for_each_side(loops.loop(k), visit);
}

/// The boundary of the area covered by an odd number of these loops: sides that occur an even
/// number of times, in any directions, are removed, and the others are chained. The resulting loops
/// cross neither each other nor themselves if the given ones do not; they may touch at vertices.
/// O(n log n).
LatticeLoops boundary_of(std::span<const std::span<const LatticePoint>> loops);

/// The same for a boundary by itself, whose sides are not shared: partial overlaps of sides are
/// removed too, and straight vertices. Collinear sides have at most one common point.
LatticeLoops outline_of(std::span<const std::span<const LatticePoint>> loops);

/// Removes each vertex that is straight for all sides that end there: two collinear sides, and no
/// third, in all of these loops together. Neighbours still have the same sides afterwards.
void drop_straight_vertices(std::span<LatticeLoops* const> all);

}  // namespace displayfile
