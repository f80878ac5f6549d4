#include "hidden/triangles/ear_cutting.h"

#include <cassert>

#include "clip/geometry/corners.h"

namespace displayfile {

namespace {

double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

bool within(const Point2& p, const Point2& a, const Point2& b, const Point2& c) {
  return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
}

}  // namespace

bool EarCutting::is_ear(std::uint32_t corner) {
  const auto [a, c] = ring_[corner];
  const Point2 &p = polygon_[a], &q = polygon_[corner], &r = polygon_[c];
  ++looks_;
  if (turn(p, q, r) <= 0.0) return false;
  for (std::uint32_t v = ring_[c].next; v != a; v = ring_[v].next) {
    ++looks_;
    const Point2& other = polygon_[v];  // the polygon may pass through a corner again
    if (other != p && other != q && other != r && within(other, p, q, r)) return false;
  }
  return true;
}

void EarCutting::cut(std::span<const Point2> polygon, std::size_t most_looks,
                     std::vector<CornerTriple>& triangles) {
  const auto sides = static_cast<std::uint32_t>(polygon.size());
  [[maybe_unused]] const std::size_t before = triangles.size();
  polygon_ = polygon;
  looks_ = 0;
  ring_.resize(sides);
  for (std::uint32_t i = 0; i < sides; ++i) {
    ring_[i] = {previous_corner(i, sides), next_corner(i, sides)};
  }
  std::uint32_t corner = 1, tried = 0;
  for (std::uint32_t left = sides; left >= 3;) {
    if (looks_ > most_looks) tried = left;
    // A full round without an ear: the polygon crosses itself. Fans the remaining corners.
    if (tried < left && !is_ear(corner)) {
      ++tried;
      corner = ring_[corner].next;
      continue;
    }
    const auto [a, c] = ring_[corner];
    triangles.push_back({a, corner, c});
    ring_[a].next = c;
    ring_[c].previous = a;
    if (tried < left--) {
      tried = 0;
      corner = ring_[c].next;  // not the neighbour: that would cut slivers around one corner
    } else {
      tried = left;
      corner = c;
    }
  }
  assert(sides < 3 || triangles.size() == before + sides - 2);
}

}  // namespace displayfile
