#pragma once

#include <cassert>
#include <cstdint>
#include <vector>

#include "hidden/lines/cell_grid.h"
#include "hidden/lines/contour_edges.h"
#include "hidden/lines/line_table.h"

namespace displayfile {

/// The visibility of each polygon as far as known before any edge is processed: in a mesh, of most.
class SeenFaces {
 public:
  enum class Seen : std::uint8_t {
    nothing,  ///< hidden, or hides nothing
    whole,    ///< convex, with nothing in front of any part of it
    entire,   ///< the same, found where polygons near it are not even: its edges come after those
              ///< between whole ones
    some,     ///< unknown
  };

  /// All hiding polygons are unknown.
  explicit SeenFaces(const LineTable& scene);
  /// Results are exact.
  SeenFaces(const LineTable& scene, const ContourEdges& ways, const CellGrid& grid, int threads);

  /// True if nothing is in front of any part of it.
  bool is_all_seen(std::uint32_t item) const {
    return (*this)[item] == Seen::whole || (*this)[item] == Seen::entire;
  }
  Seen operator[](std::uint32_t item) const {
    assert(item < seen_.size());
    return seen_[item];
  }

 private:
  std::vector<Seen> seen_;
};

}  // namespace displayfile
