#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"
#include "hidden/lines/cell_layout.h"
#include "hidden/lines/contour_edges.h"
#include "hidden/lines/line_table.h"

namespace displayfile {

/// Franklin's grid (hidden/lines/franklin.md): square cells over all polygons that hide, at several
/// levels with cell widths doubling. A polygon is in the cells of the level at which it is about as
/// large as a cell, so that it is in few. Each cell has the depth of its blocking face, behind
/// which one polygon hides all of it. Polygons behind that are omitted.
class CellGrid {
 public:
  CellGrid(const LineTable& scene, int threads);

  /// A polygon in a cell, with bounds for quick rejection.
  struct Entry {
    float x_min, x_max, y_min, y_max, z_max;
    std::uint32_t polygon;

    bool meets(const Extent& box) const {
      return (x_min <= box.x_max) & (box.x_min <= x_max) & (y_min <= box.y_max) &
             (box.y_min <= y_max);
    }
  };

  struct Level : CellLayout::Size {
    std::vector<std::uint32_t> first;  // of each cell, row by row; and the end
    std::vector<Entry> entries;        // of a cell, the one that reaches nearest first
    std::vector<float> behind;         // per cell; empty: no cell of any level has a blocking face

    std::span<const Entry> in_cell(std::size_t cell) const {
      assert(cell < cells() && first.size() == cells() + 1);
      return std::span(entries).subspan(first[cell], first[cell + 1] - first[cell]);
    }
  };
  /// From the finest to the one that is a single cell; none if nothing hides.
  std::span<const Level> levels() const { return levels_; }

  /// A polygon of the level that covers a point of a cell is in that cell.
  const CellLayout& layout() const { return layout_; }

  /// Indices of places, in order of their cells, so that nearby ones are processed together while
  /// their data are in the cache.
  std::vector<std::uint32_t> by_cell(std::span<const Point2> places) const;
  /// The first line of each name, in order of the cells of the lines' starts.
  std::vector<std::uint32_t> lines_by_cell(const LineTable& scene) const;

  /// Finds where polygons that share sides cover cells together in front of all else: behind them
  /// all is hidden, as behind a blocking face (hidden/map/visible_map.md).
  void find_blocking_sheets(const LineTable& scene, const ContourEdges& contours, int threads);

  /// True only if nothing is in front of any part of the polygon with this box, nor at the same
  /// depth, as find_blocking_sheets found.
  bool shows(const Extent& box) const;
  /// The same, also next to uneven polygons; false for boxes in cells without any.
  bool shows_in_cover(const Extent& box) const;

  /// True if the box is behind the blocking faces of cells that contain it.
  bool hides(const Extent& box) const;

 private:
  void lay_out(const LineTable& scene);
  std::size_t level_of(const Rectangle& box) const;
  void find_blocking_faces(const LineTable& scene);
  void block(const LineTable& scene, std::uint32_t polygon);
  float blocked_behind(const LineTable& scene, std::uint32_t polygon, const Point2& low,
                       const Point2& high) const;
  void pass_on_blocking();
  void begin_blocking();
  std::vector<std::uint8_t> cells_near_uneven(const LineTable& scene,
                                              const ContourEdges& contours) const;
  void find_sheets(const LineTable& scene, const ContourEdges& contours,
                   std::span<const std::uint8_t> near_uneven, std::span<float> behind_cover,
                   int threads);
  bool is_in_single(const Extent& box, std::span<const std::uint8_t> single,
                    std::span<const float> behind) const;
  void enter(const LineTable& scene, int threads);
  template <class Visit>
  void for_each_entry(const LineTable& scene, const Visit& visit) const;

  CellLayout layout_;
  std::vector<Level> levels_;
  std::vector<std::uint8_t>
      single_;  // per finest cell: nothing in front of `behind` overlaps another polygon
  std::vector<std::uint8_t> single_cover_;  // the same, by covers
  std::vector<float> behind_single_;  // `behind` of the finest cells before covers were examined
};

}  // namespace displayfile
