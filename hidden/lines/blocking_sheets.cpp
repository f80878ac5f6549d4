#include <algorithm>
#include <cmath>
#include <limits>

#include "hidden/exact/orientation.h"
#include "hidden/lines/cell_grid.h"
#include "hidden/lines/cell_walk.h"
#include "hidden/lines/contour_edges.h"
#include "hidden/parallel.h"

namespace displayfile {

namespace {

/// A contour is entered at the level where it is no longer than so many cells.
constexpr double kLongestContourInCells = 8.0;

/// True if the polygon is known to cover the point (even-odd).
bool covers(const LineScene& scene, std::uint32_t polygon, const Point2& at) {
  bool inside = false;
  const std::uint32_t sides = scene.sides(polygon);
  Point2 p(scene.corner(polygon, sides - 1));
  for (std::uint32_t k = 0; k < sides; ++k) {
    const Point2 q(scene.corner(polygon, k));
    if ((p.y > at.y) != (q.y > at.y)) {
      const int turn = filtered_orientation(p, q, at);
      if (turn == 0) return false;
      if ((turn > 0) == (q.y > p.y)) inside = !inside;
    }
    p = q;
  }
  return inside;
}

/// The polygons near one cell after the other, the one that reaches nearest first.
class Sheets {
 public:
  Sheets(const LineScene& scene, const CellGrid& grid) : scene_(scene), grid_(grid) {}

  /// The depth behind which all is hidden in a cell of the finest level that has no contour: the
  /// least of the polygons that are joined, by depth, with what covers the cell first.
  float blocked_behind(std::uint32_t i, std::uint32_t j) {
    find_those_near(i, j);
    const CellLayout& layout = grid_.layout();
    const Point2 middle = layout.origin() + layout.cell() * (Point2(i, j) + 0.5);
    float least = std::numeric_limits<float>::infinity();
    bool is_covered = false;
    for (const CellGrid::Entry& entry : near_) {
      if (is_covered && entry.z_max < least) return least;
      least = std::min(least, scene_.extent(entry.polygon).z_min);
      is_covered = is_covered || covers(scene_, entry.polygon, middle);
    }
    return -std::numeric_limits<float>::infinity();  // behind them is nothing
  }

 private:
  void find_those_near(std::uint32_t i, std::uint32_t j) {
    near_.clear();
    const auto levels = grid_.levels();
    const auto own = levels[0].in_cell(std::size_t{j} * levels[0].columns + i);
    near_.assign(own.begin(), own.end());
    const CellLayout& layout = grid_.layout();
    const Point2 low = layout.origin() + layout.cell() * (Point2(i, j) - CellLayout::kMargin);
    const Point2 high = low + layout.cell() * (1.0 + 2.0 * CellLayout::kMargin);
    bool any = false;
    for (std::size_t k = 1; k < levels.size(); ++k) {
      if (levels[k].entries.empty()) continue;
      for (const CellGrid::Entry& entry :
           levels[k].in_cell(std::size_t{j >> k} * levels[k].columns + (i >> k))) {
        if (entry.x_min > high.x || entry.x_max < low.x || entry.y_min > high.y ||
            entry.y_max < low.y) {
          continue;
        }
        near_.push_back(entry);
        any = true;
      }
    }
    if (any) {
      std::ranges::sort(near_, [](const CellGrid::Entry& a, const CellGrid::Entry& b) {
        return a.z_max > b.z_max;
      });
    }
  }

  const LineScene& scene_;
  const CellGrid& grid_;
  std::vector<CellGrid::Entry> near_;
};

}  // namespace

/// Of the finest level: 1 where a side may be that polygons do not join at.
std::vector<std::uint8_t> CellGrid::cells_with_contours(const LineScene& scene,
                                                        const ContourEdges& contours) const {
  std::vector<std::vector<std::uint8_t>> marked;
  for (const Level& level : levels_) marked.emplace_back(level.cells(), std::uint8_t{0});
  const auto mark = [&](const Point2& p, const Point2& q) {
    const Point2 from = layout_.in_cells(p), to = layout_.in_cells(q);
    const double longest = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    const std::size_t at = layout_.level_for(longest, kLongestContourInCells);
    const double scale = std::ldexp(1.0, -static_cast<int>(at));
    for_each_cell_near(levels_[at], from * scale, to * scale, CellLayout::kMargin,
                       [&](std::size_t cell) { marked[at][cell] = 1; });
  };
  for (const ContourEdges::Edge& edge : contours.edges()) mark(Point2(edge.p), Point2(edge.q));
  for (std::uint32_t i = 0; i < scene.items(); ++i) {
    if (!scene.hides(i) || (contours.way(i) != 0 && contours.is_even(i))) continue;
    Point2 p(scene.corner(i, scene.sides(i) - 1));
    for (std::uint32_t k = 0; k < scene.sides(i); ++k) {
      const Point2 q(scene.corner(i, k));
      mark(p, q);
      p = q;
    }
  }
  for (std::size_t k = levels_.size() - 1; k-- > 0;) {
    const Level &parts = levels_[k], &whole = levels_[k + 1];
    for (std::uint32_t j = 0; j < parts.rows; ++j) {
      for (std::uint32_t i = 0; i < parts.columns; ++i) {
        marked[k][std::size_t{j} * parts.columns + i] |=
            marked[k + 1][std::size_t{j / 2} * whole.columns + i / 2];
      }
    }
  }
  return std::move(marked[0]);
}

void CellGrid::find_blocking_sheets(const LineScene& scene, const ContourEdges& contours,
                                    int threads) {
  if (levels_.empty()) return;
  const std::vector<std::uint8_t> has_contour = cells_with_contours(scene, contours);
  if (levels_[0].behind.empty()) begin_blocking();
  Level& finest = levels_[0];
  constexpr std::uint32_t kRowsOfAPart = 16;
  in_parallel(threads, (finest.rows + kRowsOfAPart - 1) / kRowsOfAPart, [&](std::size_t part) {
    Sheets sheets(scene, *this);
    const auto first = static_cast<std::uint32_t>(part) * kRowsOfAPart;
    for (std::uint32_t j = first; j < std::min(first + kRowsOfAPart, finest.rows); ++j) {
      for (std::uint32_t i = 0; i < finest.columns; ++i) {
        const std::size_t cell = std::size_t{j} * finest.columns + i;
        if (has_contour[cell] != 0) continue;
        finest.behind[cell] = std::max(finest.behind[cell], sheets.blocked_behind(i, j));
      }
    }
  });
  pass_on_blocking();
}

}  // namespace displayfile
