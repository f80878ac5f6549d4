#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "clip/point.h"

namespace displayfile::test {

// Polygons of many corners that do not cross themselves, counterclockwise, with integer coordinates
// of magnitude below 2^30, so that twice an area is exact in 64 bits.

using Outline = std::vector<Point2>;

/// Corners around a point, near and far at random. Rounding leaves 10^5 of them in order.
inline Outline star_outline(std::size_t corners, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Outline outline;
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
    const double radius = 0x1p26 * (1.0 + 2.0 * static_cast<double>(random() % 1000) / 1000.0);
    outline.emplace_back(std::round(radius * std::cos(angle)),
                         std::round(radius * std::sin(angle)));
  }
  return outline;
}

/// A band that winds around its beginning, eight corners a round on each side.
inline Outline spiral_outline(std::size_t corners) {
  Outline outline;
  const std::size_t steps = corners / 2;
  const auto at = [&](std::size_t k, double lift) {
    const double angle = static_cast<double>(k) * std::numbers::pi / 4;
    const double radius = 1000.0 * (static_cast<double>(k) + 10.0) + lift;
    return Point2(std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle)));
  };
  for (std::size_t k = 0; k < steps; ++k) outline.push_back(at(k, 3000.0));
  for (std::size_t k = steps; k-- > 0;) outline.push_back(at(k, 0.0));
  return outline;
}

/// Teeth of random length, up from a bar; tips and bottoms all as high if they are even.
inline Outline comb_outline(std::size_t corners, std::uint64_t seed, bool even) {
  std::mt19937_64 random(seed);
  const std::size_t teeth = std::max<std::size_t>(1, (corners - 2) / 2);
  Outline outline{{0, 0}, {4.0 * static_cast<double>(teeth), 0}};
  for (std::size_t k = teeth; k-- > 0;) {
    const auto length = static_cast<double>(even ? 1000 : 1000 + random() % 100000);
    const auto depth = static_cast<double>(even ? 10 : 1 + random() % 100);
    outline.emplace_back(4.0 * static_cast<double>(k) + 2.0, length);
    if (k > 0) outline.emplace_back(4.0 * static_cast<double>(k), depth);
  }
  return outline;
}

/// An outline around a random tree on a grid of `cells` cells a side, four corners a cell, many of
/// which are collinear: at right angles, many corners as high, and holes all but closed.
inline Outline tree_outline(std::size_t cells, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const std::size_t n = cells;
  std::vector<std::uint8_t> open(n * n, 0);  // towards east, north, west, south
  std::vector<bool> seen(n * n, false);
  std::vector<std::size_t> way{0};
  seen[0] = true;
  const auto neighbour = [&](std::size_t cell, int side) -> std::size_t {
    const std::size_t x = cell % n, y = cell / n;
    if (side == 0) return x + 1 < n ? cell + 1 : n * n;
    if (side == 1) return y + 1 < n ? cell + n : n * n;
    if (side == 2) return x > 0 ? cell - 1 : n * n;
    return y > 0 ? cell - n : n * n;
  };
  while (!way.empty()) {
    const std::size_t cell = way.back();
    int sides[4], count = 0;
    for (int side = 0; side < 4; ++side) {
      const std::size_t other = neighbour(cell, side);
      if (other < n * n && !seen[other]) sides[count++] = side;
    }
    if (count == 0) {
      way.pop_back();
      continue;
    }
    const int side = sides[random() % static_cast<unsigned>(count)];
    const std::size_t other = neighbour(cell, side);
    open[cell] = static_cast<std::uint8_t>(open[cell] | 1 << side);
    open[other] = static_cast<std::uint8_t>(open[other] | 1 << (side + 2) % 4);
    seen[other] = true;
    way.push_back(other);
  }
  // Around the tree, the wall at the right hand: at each side of a cell on, or through it.
  Outline outline;
  std::size_t cell = 0;
  int side = 3;
  do {
    const double x = 4.0 * static_cast<double>(cell % n), y = 4.0 * static_cast<double>(cell / n);
    if ((open[cell] >> side & 1) != 0) {
      cell = neighbour(cell, side);
      side = (side + 3) % 4;
    } else {
      const Point2 ends[4] = {{x + 3, y + 3}, {x, y + 3}, {x, y}, {x + 3, y}};
      outline.push_back(ends[side]);
      side = (side + 1) % 4;
    }
  } while (cell != 0 || side != 3);
  return outline;
}

}  // namespace displayfile::test
