#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"
#include "hidden/lines/line_scene.h"

namespace displayfile {

/// The cell of a place along an axis, of so many; those at the ends take what is beyond.
inline std::uint32_t cell_at(double place, std::uint32_t cells) {
  if (!(place > 0.0)) return 0;
  return static_cast<std::uint32_t>(std::min(place, static_cast<double>(cells - 1)));
}

/// Franklin's grid (hidden/lines/franklin.md): square cells over all that hides something, at
/// several levels, each of cells twice as wide as those of the one before. A polygon is in the
/// cells of one level, where it is about as large as a cell, so that it is in few. Each cell knows
/// the depth behind which one polygon hides all of it: that of its blocking face. What lies
/// behind that is left out, and what is in cells where no line goes.
class CellGrid {
 public:
  CellGrid(const LineScene& scene, int threads);

  /// A polygon in a cell, and what tells that it does not hide a line.
  struct Entry {
    float x_min, x_max, y_min, y_max, z_max;
    std::uint32_t polygon;

    bool meets(const Extent& box) const {
      return (x_min <= box.x_max) & (box.x_min <= x_max) & (y_min <= box.y_max) &
             (box.y_min <= y_max);
    }
  };

  struct Level {
    std::uint32_t columns = 1, rows = 1;
    std::vector<std::uint32_t> first;  // of each cell, row by row; and the end
    std::vector<Entry> entries;        // of a cell, the one that reaches nearest first
    std::vector<float> behind;  // of each cell; empty: no cell of any level has a blocking face
    std::vector<std::uint8_t> with_lines;  // of each cell, 1 if some line may go there; empty: all

    std::span<const Entry> in_cell(std::uint32_t cell) const {
      return std::span(entries).subspan(first[cell], first[cell + 1] - first[cell]);
    }
  };
  /// From the finest to the one that is a single cell; none if nothing hides.
  std::span<const Level> levels() const { return levels_; }

  /// A point's place in cells of the finest level. A cell (i, j) of level k has all points from i
  /// 2^k to (i + 1) 2^k, j likewise, and some 2^-20 of a cell around, which pays for rounding here:
  /// what covers one of these points is in the cell, if it is of the level.
  Point2 in_cells(const Point2& p) const {
    return {(p.x - origin_.x) * cells_a_unit_, (p.y - origin_.y) * cells_a_unit_};
  }

  /// The first line of each name, in order of the cells where the lines begin: what lies near each
  /// other is looked at together, while its data are at hand.
  std::vector<std::uint32_t> lines_by_cell(const LineScene& scene) const;

  /// True if the box is behind the blocking faces of cells that have it all.
  bool hides(const Extent& box) const;

 private:
  /// The cells of a level that a box has a part in.
  struct Range {
    std::uint32_t left, right, bottom, top;  // the first and the last
  };
  void lay_out(const LineScene& scene);
  Range range(const Extent& box, std::size_t level) const;
  double length_in_cells(const Extent& box) const;
  std::size_t level_of(const Extent& box) const;
  void find_blocking_faces(const LineScene& scene);
  void block(const LineScene& scene, std::uint32_t polygon);
  float blocked_behind(const LineScene& scene, std::uint32_t polygon, const Point2& low,
                       const Point2& high) const;
  void pass_on_blocking();
  void find_cells_with_lines(const LineScene& scene);
  void enter(const LineScene& scene, int threads);
  template <class Visit>
  void for_each_entry(const LineScene& scene, const Visit& visit) const;

  Point2 origin_{0.0};
  double cell_ = 1.0, cells_a_unit_ = 0.0;  // the finest level's
  std::vector<Level> levels_;
};

}  // namespace displayfile
