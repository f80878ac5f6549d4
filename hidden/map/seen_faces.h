#pragma once

#include <cassert>
#include <cstdint>
#include <vector>

#include "hidden/lines/cell_grid.h"
#include "hidden/lines/contour_edges.h"
#include "hidden/lines/line_table.h"

namespace displayfile {

/// What is known of each polygon's visibility before any edge is looked at: in a mesh, of most.
class SeenFaces {
 public:
  enum class Seen : std::uint8_t {
    nothing,  ///< it is hidden, or hides nothing
    whole,    ///< convex, and nothing is before any part of it
    some,     ///< more must be asked
  };

  /// Nothing is known of what hides.
  explicit SeenFaces(const LineTable& scene);
  /// Exactly, what is told.
  SeenFaces(const LineTable& scene, const ContourEdges& ways, const CellGrid& grid, int threads);

  Seen operator[](std::uint32_t item) const {
    assert(item < seen_.size());
    return seen_[item];
  }

 private:
  std::vector<Seen> seen_;
};

}  // namespace displayfile
