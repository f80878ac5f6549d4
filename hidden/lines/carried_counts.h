#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "hidden/lines/line_counts.h"

namespace displayfile {

/// A line between two vertices with its relative counts: the contributions of the polygons around
/// each vertex immediately after its start and before its end, and the change from start to end.
struct CountedLine {
  std::uint32_t from, to;
  SideCounts star_from, star_to, change;
};

/// The counts immediately after each line's start. Around a vertex that carries, all lines that
/// begin or end there have the same number on both sides, except for the contributions of the
/// polygons around it. It is carried along the lines from vertex to vertex; ray(line) finds the
/// counts after a line's start by comparison, once for each connected set and for each line with no
/// carrying end. Where carried counts are inconsistent, as can happen with ROUNDOFF, each line gets
/// a ray. Rays are found by several threads.
struct CarriedCounts {
  using Ray = std::function<SideCounts(std::uint32_t line)>;

  CarriedCounts(std::span<const CountedLine> lines, std::span<const std::uint8_t> carries,
                const Ray& ray, int threads);

  std::vector<SideCounts> start;      ///< of each line
  std::size_t rays = 0, carried = 0;  ///< numbers of lines by how their counts were found
};

}  // namespace displayfile
