#pragma once

#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "hidden/lines/contour_edges.h"
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

}  // namespace displayfile
