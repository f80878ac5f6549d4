#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// Three corners of a polygon, in its order.
using CornerTriple = std::array<std::uint32_t, 3>;

/// Cuts ears off a polygon until a triangle is left: simple, quadratic for usual polygons.
class EarCutting {
 public:
  /// Appends the triangles of a polygon that runs counterclockwise, two fewer than its corners (at
  /// least three); each of its sides is a side of one of them. Signs are in doubles. If a round
  /// finds no ear, or after most_looks corners, the next corner is cut off anyway: a self-crossing
  /// polygon is cut where ears are found, and fanned from there.
  void cut(std::span<const Point2> polygon, std::size_t most_looks,
           std::vector<CornerTriple>& triangles);

 private:
  struct Neighbours {
    std::uint32_t previous, next;
  };
  bool is_ear(std::uint32_t corner);

  std::span<const Point2> polygon_;
  std::vector<Neighbours> ring_;  // of the corners that are left
  std::size_t looks_ = 0;
};

/// The successor of a corner that no loop has.
constexpr std::uint32_t kInNoLoop = 0xFFFFFFFFu;

/// Appends triangles that tile a polygon of at least three corners, in n log n
/// (hidden/triangles/triangulation.md): two fewer than its corners, none with the opposite
/// orientation, each of its sides a side of one of them. Signs are exact. Triangles without area
/// are made only where the polygon repeats a point or touches itself. `next`, if not empty, makes
/// it a region of several loops, outlines counterclockwise and holes clockwise: of each corner the
/// one that follows in its loop, or kInNoLoop. False, appending nothing, if the polygon crosses
/// itself, or touches itself in a way that the sweep does not resolve. (Hertel and Mehlhorn, Fast
/// triangulation of simple polygons, 1983.)
bool sweep_triangles(std::span<const Point2> polygon, std::vector<CornerTriple>& triangles,
                     std::span<const std::uint32_t> next = {});

}  // namespace displayfile
