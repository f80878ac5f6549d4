#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "clip/base/parallel.h"
#include "clip/geometry/corners.h"
#include "hidden/exact/orientation.h"
#include "hidden/lines/cell_grid.h"
#include "hidden/lines/contour_edges.h"

namespace displayfile {

namespace {

/// A box is looked up in cells of the finest level if it is at most this many cells long.
constexpr double kLongestInCells = 16.0;

enum class Covering : std::uint8_t { no, yes, unknown };

/// Tests if the polygon covers the point (even-odd).
Covering covering(const LineTable& scene, std::uint32_t polygon, const Point2& at) {
  bool inside = false;
  const std::uint32_t sides = scene.sides(polygon);
  Point2 p(scene.corner(polygon, sides - 1));
  for (std::uint32_t k = 0; k < sides; ++k) {
    const Point2 q(scene.corner(polygon, k));
    if ((p.y > at.y) != (q.y > at.y)) {
      const int turn = filtered_orientation(p, q, at);
      if (turn == 0) return Covering::unknown;
      if ((turn > 0) == (q.y > p.y)) inside = !inside;
    }
    p = q;
  }
  return inside ? Covering::yes : Covering::no;
}

/// The polygons near the current cell, the one that reaches nearest first.
class Sheets {
 public:
  Sheets(const LineTable& scene, const ContourEdges& contours, const CellGrid& grid)
      : scene_(scene), contours_(contours), grid_(grid) {}

  /// The result for a cell.
  struct Known {
    /// The depth behind which everything is hidden.
    float behind = -std::numeric_limits<float>::infinity();
    bool is_single = false;  ///< in front of it no two polygons overlap
  };

  /// Makes a cell of the finest level the current one.
  void go_to(std::uint32_t i, std::uint32_t j) {
    near_.clear();
    const auto levels = grid_.levels();
    const auto own = levels[0].in_cell(std::size_t{j} * levels[0].columns + i);
    near_.assign(own.begin(), own.end());
    const CellLayout& layout = grid_.layout();
    low_ = layout.origin() + layout.cell() * (Point2(i, j) - CellLayout::kMargin);
    high_ = layout.origin() + layout.cell() * (Point2(i + 1, j + 1) + CellLayout::kMargin);
    middle_ = layout.origin() + layout.cell() * (Point2(i, j) + 0.5);
    bool is_in_order = true;
    for (std::size_t k = 1; k < levels.size(); ++k) {
      if (levels[k].entries.empty()) continue;
      for (const CellGrid::Entry& entry :
           levels[k].in_cell(std::size_t{j >> k} * levels[k].columns + (i >> k))) {
        if (entry.x_min > high_.x || entry.x_max < low_.x || entry.y_min > high_.y ||
            entry.y_max < low_.y) {
          continue;
        }
        near_.push_back(entry);
        is_in_order = false;
      }
    }
    if (is_in_order) return;
    std::ranges::sort(near_, [](const CellGrid::Entry& a, const CellGrid::Entry& b) {
      return a.z_max > b.z_max;
    });
  }

  /// True if a polygon near the cell is not even: otherwise covers equal sheets.
  bool is_any_uneven() const {
    return std::ranges::any_of(
        near_, [&](const CellGrid::Entry& entry) { return !contours_.is_even(entry.polygon); });
  }

  /// Examines the first sheets of the cell: polygons that follow each other by depth without a gap
  /// larger than the step. A polygon without contours in the cell covers all its points as often as
  /// its middle.
  Known look(ContourEdges::Of of) const {
    const double step = of == ContourEdges::Of::cover ? contours_.step() : 0.0;
    float least = std::numeric_limits<float>::infinity();
    bool is_first = true, is_broken = false, is_unknown = false;
    int covers = 0;
    const auto found = [&] { return covers > 0 && !is_broken; };
    const auto known = [&] { return Known{least, is_first && covers == 1 && !is_unknown}; };
    for (const CellGrid::Entry& entry : near_) {
      if (entry.z_max < least - step && least < std::numeric_limits<float>::infinity()) {
        if (found()) return known();
        is_first = is_broken = is_unknown = false;
        covers = 0;
      }
      least = std::min(least, scene_.extent(entry.polygon).z_min);
      is_broken = is_broken || has_contour_near(entry.polygon, of);
      if (is_broken) continue;
      const Covering at_middle = covering(scene_, entry.polygon, middle_);
      covers += at_middle == Covering::yes ? 1 : 0;
      is_unknown = is_unknown || at_middle == Covering::unknown;
    }
    return found() ? known() : Known{};
  }

 private:
  /// False only if none of the polygon's sides in the cell is a contour.
  bool has_contour_near(std::uint32_t polygon, ContourEdges::Of of) const {
    if (!contours_.has_contour(polygon, of)) return false;
    const std::uint32_t sides = scene_.sides(polygon);
    return contours_.any_contour(polygon, sides, of, [&](std::uint32_t k) {
      const Point2 p(scene_.corner(polygon, previous_corner(k, sides)));
      const Point2 q(scene_.corner(polygon, k));
      return std::max(p.x, q.x) >= low_.x && std::min(p.x, q.x) <= high_.x &&
             std::max(p.y, q.y) >= low_.y && std::min(p.y, q.y) <= high_.y;
    });
  }

  const LineTable& scene_;
  const ContourEdges& contours_;
  const CellGrid& grid_;
  std::vector<CellGrid::Entry> near_;
  Point2 low_{0.0}, high_{0.0}, middle_{0.0};  // of the cell
};

}  // namespace

void CellGrid::find_blocking_sheets(const LineTable& scene, const ContourEdges& contours,
                                    int threads) {
  if (levels_.empty()) return;
  if (levels_[0].behind.empty()) begin_blocking();
  std::vector<float>& behind = levels_[0].behind;
  single_.assign(behind.size(), 0);
  if (scene.all_even()) {
    find_sheets(scene, contours, {}, {}, threads);
    return pass_on_blocking();
  }
  single_cover_.assign(behind.size(), 0);
  std::vector<float> behind_cover(behind.size(), -std::numeric_limits<float>::infinity());
  find_sheets(scene, contours, cells_near_uneven(scene, contours), behind_cover, threads);
  pass_on_blocking();
  behind_single_ = behind;
  for (std::size_t cell = 0; cell < behind.size(); ++cell) {
    behind[cell] = std::max(behind[cell], behind_cover[cell]);
  }
  pass_on_blocking();
}

/// For each cell of the finest level, 0 only if no polygon near it is uneven. The few uneven
/// polygons are entered in the cells of their levels, and from there in the cells' parts.
std::vector<std::uint8_t> CellGrid::cells_near_uneven(const LineTable& scene,
                                                      const ContourEdges& contours) const {
  std::vector<std::vector<std::uint8_t>> near;
  for (const Level& level : levels_) near.emplace_back(level.cells(), std::uint8_t{0});
  for (std::uint32_t polygon = 0; polygon < scene.items(); ++polygon) {
    if (!scene.hides(polygon) || contours.is_even(polygon)) continue;
    const Rectangle box = rectangle_of(scene.extent(polygon));
    const std::size_t at = level_of(box);
    const CellLayout::Range cells = layout_.range(box, at);
    for (std::uint32_t j = cells.bottom; j <= cells.top; ++j) {
      const std::size_t row = std::size_t{j} * levels_[at].columns;
      std::fill(near[at].begin() + static_cast<std::ptrdiff_t>(row + cells.left),
                near[at].begin() + static_cast<std::ptrdiff_t>(row + cells.right + 1), 1);
    }
  }
  for (std::size_t k = levels_.size() - 1; k-- > 0;) {
    for (std::uint32_t j = 0; j < levels_[k].rows; ++j) {
      for (std::uint32_t i = 0; i < levels_[k].columns; ++i) {
        near[k][std::size_t{j} * levels_[k].columns + i] |=
            near[k + 1][std::size_t{j / 2} * levels_[k + 1].columns + i / 2];
      }
    }
  }
  return std::move(near.front());
}

/// Raises `behind`, and finds the cells of a single sheet. If some polygon is not even, also by
/// covers, but only in cells near such polygons that have no single first sheet otherwise.
void CellGrid::find_sheets(const LineTable& scene, const ContourEdges& contours,
                           std::span<const std::uint8_t> near_uneven, std::span<float> behind_cover,
                           int threads) {
  Level& finest = levels_[0];
  constexpr std::uint32_t kRowsOfAPart = 16;
  in_parallel(threads, (finest.rows + kRowsOfAPart - 1) / kRowsOfAPart, [&](std::size_t part) {
    Sheets sheets(scene, contours, *this);
    const auto first = static_cast<std::uint32_t>(part) * kRowsOfAPart;
    for (std::uint32_t j = first; j < std::min(first + kRowsOfAPart, finest.rows); ++j) {
      for (std::uint32_t i = 0; i < finest.columns; ++i) {
        const std::size_t cell = std::size_t{j} * finest.columns + i;
        sheets.go_to(i, j);
        const Sheets::Known known = sheets.look(ContourEdges::Of::depth);
        finest.behind[cell] = std::max(finest.behind[cell], known.behind);
        single_[cell] = known.is_single ? 1 : 0;
        if (near_uneven.empty()) continue;
        single_cover_[cell] = single_[cell];
        if (known.is_single || near_uneven[cell] == 0 || !sheets.is_any_uneven()) continue;
        const Sheets::Known of_cover = sheets.look(ContourEdges::Of::cover);
        behind_cover[cell] = of_cover.behind;
        single_cover_[cell] = of_cover.is_single ? 1 : 0;
      }
    }
  });
}

bool CellGrid::shows(const Extent& box) const {
  return is_in_single(box, single_, behind_single_.empty() ? levels_[0].behind : behind_single_);
}

bool CellGrid::shows_in_cover(const Extent& box) const {
  return is_in_single(box, single_cover_, levels_[0].behind);
}

bool CellGrid::is_in_single(const Extent& box, std::span<const std::uint8_t> single,
                            std::span<const float> behind) const {
  if (single.empty() || layout_.length_in_cells(rectangle_of(box)) > kLongestInCells) return false;
  const CellLayout::Range cells = layout_.range(rectangle_of(box), 0);
  const Level& finest = levels_[0];
  for (std::uint32_t j = cells.bottom; j <= cells.top; ++j) {
    for (std::uint32_t i = cells.left; i <= cells.right; ++i) {
      const std::size_t cell = std::size_t{j} * finest.columns + i;
      if (single[cell] == 0 || !(box.z_min >= behind[cell])) return false;
    }
  }
  return true;
}

}  // namespace displayfile
