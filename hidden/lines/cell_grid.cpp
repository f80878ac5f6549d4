#include "hidden/lines/cell_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "clip/base/parallel.h"
#include "hidden/exact/ball.h"
#include "hidden/exact/depth_order.h"
#include "hidden/exact/orientation.h"
#include "hidden/lines/end_on_plane.h"

namespace displayfile {

namespace {

constexpr float kNothingHidden = -std::numeric_limits<float>::infinity();

/// Bounds on the finest level's cells: their width is half of the median length of the boxes, but
/// there are at least one and at most kMostCellsAPolygon cells per hiding polygon (measurements in
/// hidden/lines/franklin.md).
constexpr double kUsualLengthInCells = 2.0;
constexpr double kMostCellsAPolygon = 8.0;
/// A polygon is at the level where its box is no larger than this many cells.
constexpr double kLargestInCells = 4.0;
/// A polygon is tried as a blocking face if its box is larger than kLeastToBlock cells of the
/// finest level, since an equilateral triangle contains no square larger than 0.46 of its side. It
/// is tried in cells of which its box covers at most kMostToBlock per side.
constexpr double kLeastToBlock = 4.0;
constexpr double kMostToBlock = 64.0;
/// To test if all of a box is behind blocking faces, the box is looked up in cells of which it is
/// at most this many long.
constexpr double kMostToLookUp = 4.0;
/// Lines are ordered by this level's cells.
constexpr std::size_t kLevelOfOrder = 2;

}  // namespace

CellGrid::CellGrid(const LineTable& scene, int threads) {
  lay_out(scene);
  if (levels_.empty()) return;
  find_blocking_faces(scene);
  enter(scene, threads);
}

void CellGrid::lay_out(const LineTable& scene) {
  Extent all = Extent::nothing();
  std::vector<float> lengths;
  for (const Extent& box : scene.extents()) {
    if (!(box.x_min <= box.x_max)) continue;
    all.include(box);
    lengths.push_back(std::max(box.x_max - box.x_min, box.y_max - box.y_min));
  }
  if (lengths.empty()) return;
  const auto half = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), half, lengths.end());
  const double width = double{all.x_max} - double{all.x_min};
  const double height = double{all.y_max} - double{all.y_min};
  const double longer = std::max(width, height);
  const auto count = static_cast<double>(lengths.size());
  const double widest = std::sqrt(width * height / count);
  const double cell =
      std::clamp(*half / kUsualLengthInCells, widest / std::sqrt(kMostCellsAPolygon), widest);
  layout_ = CellLayout(rectangle_of(all),
                       std::max(cell, longer / std::min(CellLayout::kMostColumns, count)));
  for (const CellLayout::Size& size : layout_.levels()) levels_.push_back({size, {}, {}, {}});
}

std::size_t CellGrid::level_of(const Rectangle& box) const {
  return layout_.level_for(layout_.length_in_cells(box), kLargestInCells);
}

// ---- Blocking faces -----------------------------------------------------------------------

void CellGrid::find_blocking_faces(const LineTable& scene) {
  for (std::uint32_t i = 0; i < scene.items(); ++i) {
    if (!scene.hides(i)) continue;
    if (layout_.length_in_cells(rectangle_of(scene.extent(i))) > kLeastToBlock) block(scene, i);
  }
  if (!levels_[0].behind.empty()) pass_on_blocking();
}

/// Enters the polygon in the cells that it covers completely.
void CellGrid::block(const LineTable& scene, std::uint32_t polygon) {
  const Rectangle box = rectangle_of(scene.extent(polygon));
  const std::size_t at = layout_.level_for(layout_.length_in_cells(box), kMostToBlock);
  const double size = std::ldexp(layout_.cell(), static_cast<int>(at));
  const CellLayout::Range cells = layout_.range(box, at);
  const Point2& origin = layout_.origin();
  // The rounding error of positions far from 0.
  const double margin =
      CellLayout::kMargin * size + 0x1p-48 * (std::abs(origin.x) + std::abs(origin.y) +
                                              size * (levels_[at].columns + levels_[at].rows));
  for (std::uint32_t j = cells.bottom; j <= cells.top; ++j) {
    for (std::uint32_t i = cells.left; i <= cells.right; ++i) {
      const Point2 low = origin + size * Point2(i, j) - margin;
      const Point2 high = origin + size * Point2(i + 1, j + 1) + margin;
      const float depth = blocked_behind(scene, polygon, low, high);
      if (depth == kNothingHidden) continue;
      if (levels_[0].behind.empty()) begin_blocking();
      float& behind = levels_[at].behind[std::size_t{j} * levels_[at].columns + i];
      behind = std::max(behind, depth);
    }
  }
}

void CellGrid::begin_blocking() {
  for (Level& level : levels_) level.behind.resize(level.cells(), kNothingHidden);
}

/// The minimum depth of the polygon over a rectangle that it covers completely: all its sides have
/// the rectangle on the same side, and the boundary surrounds it once (even-odd).
float CellGrid::blocked_behind(const LineTable& scene, std::uint32_t polygon, const Point2& low,
                               const Point2& high) const {
  constexpr double kBound = 8.0 * kUnit * kInflate;
  int turning = 0, crossings = 0;
  const std::uint32_t sides = scene.sides(polygon);
  Point2 p(scene.corner(polygon, sides - 1));
  for (std::uint32_t k = 0; k < sides; ++k) {
    const Point2 q(scene.corner(polygon, k));
    crossings += (p.y <= low.y) != (q.y <= low.y) ? 1 : 0;
    const Point2 along = q - p;
    const auto turn_at = [&](double x, double y) {
      const double left = along.x * (y - p.y), right = along.y * (x - p.x);
      const double bound = kBound * (std::abs(left) + std::abs(right)) + kTiny;
      const double turn = left - right;
      return std::abs(turn) > bound ? decided_sign(turn) : 0;
    };
    const int turn = turn_at(low.x, low.y);
    if (turn == 0 || turn == -turning || turn_at(high.x, low.y) != turn ||
        turn_at(low.x, high.y) != turn || turn_at(high.x, high.y) != turn) {
      return kNothingHidden;
    }
    turning = turn;
    p = q;
  }
  if (crossings != 2) return kNothingHidden;
  const Plane plane = scene.plane(polygon);
  double least = std::numeric_limits<double>::infinity();
  for (const double x : {low.x, high.x}) {
    for (const double y : {low.y, high.y}) {
      const PlaneValue slope = slope_value(plane, {x, y, 0.0});
      const Ball depth =
          Ball{plane.p.z} - Ball{slope.value, slope.bound} / Ball{plane.normal.z, plane.bound.z};
      least = std::min(least, depth.middle - 2.0 * depth.radius);
    }
  }
  // Twice the reach, since a line's ends may be far outside of the polygon.
  if (scene.touching() > 0.0) least -= 2.0 * reach_in_depth(scene.touching(), plane);
  return std::isfinite(least) ? rounded_down(least) : kNothingHidden;
}

/// A depth that blocks all four parts of a cell blocks the cell, and one that blocks a cell blocks
/// its parts.
void CellGrid::pass_on_blocking() {
  for (std::size_t k = 0; k + 1 < levels_.size(); ++k) {
    const Level& parts = levels_[k];
    Level& whole = levels_[k + 1];
    for (std::uint32_t j = 0; j < whole.rows; ++j) {
      for (std::uint32_t i = 0; i < whole.columns; ++i) {
        float least = std::numeric_limits<float>::infinity();
        // A cell at the border may have fewer parts, but has full width.
        const bool all = 2 * i + 1 < parts.columns && 2 * j + 1 < parts.rows;
        for (std::uint32_t part = 0; all && part < 4; ++part) {
          const std::size_t row = 2 * j + part / 2, column = 2 * i + part % 2;
          least = std::min(least, parts.behind[row * parts.columns + column]);
        }
        float& behind = whole.behind[std::size_t{j} * whole.columns + i];
        if (all) behind = std::max(behind, least);
      }
    }
  }
  for (std::size_t k = levels_.size() - 1; k-- > 0;) {
    const Level& whole = levels_[k + 1];
    Level& parts = levels_[k];
    for (std::uint32_t j = 0; j < parts.rows; ++j) {
      for (std::uint32_t i = 0; i < parts.columns; ++i) {
        float& behind = parts.behind[std::size_t{j} * parts.columns + i];
        behind = std::max(behind, whole.behind[std::size_t{j / 2} * whole.columns + i / 2]);
      }
    }
  }
}

bool CellGrid::hides(const Extent& box) const {
  if (levels_.empty() || levels_[0].behind.empty()) return false;
  const Point2 low = layout_.in_cells({box.x_min, box.y_min});
  const Point2 high = layout_.in_cells({box.x_max, box.y_max});
  const bool inside =
      low.x >= 0.0 && low.y >= 0.0 && high.x <= levels_[0].columns && high.y <= levels_[0].rows;
  if (!inside) return false;
  const Rectangle flat = rectangle_of(box);
  const std::size_t at = layout_.level_for(layout_.length_in_cells(flat), kMostToLookUp);
  const CellLayout::Range cells = layout_.range(flat, at);
  const Level& level = levels_[at];
  for (std::uint32_t j = cells.bottom; j <= cells.top; ++j) {
    for (std::uint32_t i = cells.left; i <= cells.right; ++i) {
      if (!(level.behind[std::size_t{j} * level.columns + i] > box.z_max)) return false;
    }
  }
  return true;
}

// ---- Polygons in cells --------------------------------------------------------------------

/// Calls visit(level, cell, polygon) for each cell that contains part of a polygon and does not
/// block all of it.
template <class Visit>
void CellGrid::for_each_entry(const LineTable& scene, const Visit& visit) const {
  for (std::uint32_t polygon = 0; polygon < scene.items(); ++polygon) {
    if (!scene.hides(polygon)) continue;
    const Rectangle box = rectangle_of(scene.extent(polygon));
    const std::size_t at = level_of(box);
    const Level& level = levels_[at];
    const CellLayout::Range cells = layout_.range(box, at);
    for (std::uint32_t j = cells.bottom; j <= cells.top; ++j) {
      for (std::uint32_t i = cells.left; i <= cells.right; ++i) {
        const std::size_t cell = std::size_t{j} * level.columns + i;
        if (!level.behind.empty() && level.behind[cell] > scene.extent(polygon).z_max) continue;
        visit(at, cell, polygon);
      }
    }
  }
}

/// Counts the entries, stores them, and sorts each cell's.
void CellGrid::enter(const LineTable& scene, int threads) {
  for (Level& level : levels_) level.first.resize(level.cells() + 1, 0);
  for_each_entry(scene, [&](std::size_t at, std::size_t cell, std::uint32_t) {
    ++levels_[at].first[cell + 1];
  });
  std::vector<std::vector<std::uint32_t>> next;
  for (Level& level : levels_) {
    for (std::size_t i = 1; i < level.first.size(); ++i) level.first[i] += level.first[i - 1];
    level.entries.resize(level.first.back());
    next.emplace_back(level.first.begin(), level.first.end() - 1);
  }
  for_each_entry(scene, [&](std::size_t at, std::size_t cell, std::uint32_t polygon) {
    const Extent& box = scene.extent(polygon);
    levels_[at].entries[next[at][cell]++] = {box.x_min, box.x_max, box.y_min,
                                             box.y_max, box.z_max, polygon};
  });
  constexpr std::size_t kPart = 4096;
  for (Level& level : levels_) {
    const std::size_t cells = level.first.size() - 1;
    in_parallel(threads, (cells + kPart - 1) / kPart, [&](std::size_t part) {
      for (std::size_t c = part * kPart; c < std::min(cells, (part + 1) * kPart); ++c) {
        std::ranges::sort(level.entries.begin() + level.first[c],
                          level.entries.begin() + level.first[c + 1],
                          [](const Entry& a, const Entry& b) {
                            return a.z_max != b.z_max ? a.z_max > b.z_max : a.polygon < b.polygon;
                          });
      }
    });
  }
}

std::vector<std::uint32_t> CellGrid::by_cell(std::span<const Point2> places) const {
  std::vector<std::uint32_t> order(places.size());
  std::iota(order.begin(), order.end(), 0u);
  if (levels_.empty()) return order;
  const std::size_t at = std::min(kLevelOfOrder, levels_.size() - 1);
  const Level& level = levels_[at];
  const double scale = std::ldexp(1.0, -static_cast<int>(at));
  std::vector<std::uint32_t> cell_of, next(level.cells() + 1, 0);
  cell_of.reserve(places.size());
  for (const Point2& place : places) {
    const Point2 p = layout_.in_cells(place) * scale;
    cell_of.push_back(cell_at(p.y, level.rows) * level.columns + cell_at(p.x, level.columns));
    ++next[cell_of.back() + 1];
  }
  for (std::size_t c = 1; c < next.size(); ++c) next[c] += next[c - 1];
  for (std::uint32_t k = 0; k < places.size(); ++k) order[next[cell_of[k]]++] = k;
  return order;
}

std::vector<std::uint32_t> CellGrid::lines_by_cell(const LineTable& scene) const {
  const auto first_lines = scene.first_lines();
  std::vector<Point2> starts;
  starts.reserve(first_lines.size());
  for (const std::uint32_t line : first_lines) {
    starts.emplace_back(scene.point(scene.lines()[line].a));
  }
  std::vector<std::uint32_t> order = by_cell(starts);
  for (std::uint32_t& k : order) k = first_lines[k];
  return order;
}

}  // namespace displayfile
