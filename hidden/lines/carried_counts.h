#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "hidden/lines/line_counts.h"

namespace displayfile {

/// A line between two vertices, with all that is known of its counts before they are: what the
/// polygons around each vertex add immediately after its start and immediately before its end, and
/// how much the count there is more than after its start.
struct CountedLine {
  std::uint32_t from, to;
  SideCounts star_from, star_to, change;
};

/// The counts immediately after each line's start. Around a vertex that carries, they are the same
/// number for every line that begins or ends there, left and right, but for what the polygons
/// around it add. It is carried along the lines from vertex to vertex, over all lines that connect;
/// ray(line) finds the counts immediately after a line's start by comparison, once for all that
/// connect, and for each line none of whose ends carries. Where carried counts do not add up, as
/// can happen with ROUNDOFF, each line gets a ray. Rays are found on several threads.
struct CarriedCounts {
  using Ray = std::function<SideCounts(std::uint32_t line)>;

  CarriedCounts(std::span<const CountedLine> lines, std::span<const std::uint8_t> carries,
                const Ray& ray, int threads);

  std::vector<SideCounts> start;      ///< of each line
  std::size_t rays = 0, carried = 0;  ///< lines whose counts were found in the one way or the other
};

}  // namespace displayfile
