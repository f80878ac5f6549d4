#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "hidden/lines/contour_edges.h"
#include "hidden/lines/line_counts.h"
#include "hidden/lines/line_table.h"
#include "hidden/lines/side_table.h"

namespace displayfile {

/// The ends of lines, with equal points merged into vertices, and the counted polygons with a
/// corner there: the vertex's star.
class LineVertices {
 public:
  LineVertices(const LineTable& scene, const Primitives& items, const SideTable& sides,
               const ContourEdges& contours);

  /// The vertex of a point, from 0 to before the number of points.
  std::uint32_t vertex(std::uint32_t point) const { return sides_.vertex(point); }
  /// The corners of the star, as LineName: item and corner. Only where at least two lines meet.
  std::span<const LineName> star(std::uint32_t vertex) const {
    assert(vertex + 1 < first_.size());
    return std::span(corners_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
  }
  /// 1 for each vertex where at least two lines meet.
  const std::vector<std::uint8_t>& joins() const { return joins_; }

 private:
  const SideTable& sides_;
  std::vector<std::uint8_t> joins_;
  std::vector<std::uint32_t> first_;  // of each vertex, among the corners
  std::vector<LineName> corners_;
};

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
