#include "interp/annotation/label_cells.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "interp/annotation/page_shapes.h"

namespace displayfile {

namespace {

constexpr double kRoomMargin = 0.5;  // in parts of the capitals' height
constexpr double kLeastGain = 1e-9;  // of an exchange, in pixels
/// The cost of a line that crosses other annotation, in pixels: more than any line is long.
constexpr double kCostOfCrossing = 1e6;
/// More labels keep the shortest lines.
constexpr std::size_t kMostToUntangle = 200;

/// Moves two borders of a strip inward so that cells of this depth fit beside them.
void cut(double low, double high, double depth, double& from, double& to) {
  from = std::max(from, low + depth);
  to = std::min(to, high - depth);
  if (from > to) from = to = 0.5 * (low + high);
}

/// Adds cells of a size on both sides of a strip, which follow each other along an axis, 0: x, or
/// 1: y, from low to high, from the strip's middle on.
void add_cells(const Rectangle& strip, int along, const Point2& size, double gap, double low,
               double high, std::vector<LabelCell>& cells) {
  using enum PageAnnotation::Side;
  const bool in_rows = along == 0;
  const double pitch = size[along] + gap;
  const double middle =
      in_rows ? 0.5 * (strip.x_min + strip.x_max) : 0.5 * (strip.y_min + strip.y_max);
  const double first = middle - pitch * std::floor((middle - 0.5 * size[along] - low) / pitch);
  for (double at = first; at + 0.5 * size[along] <= high; at += pitch) {
    for (const auto side : {in_rows ? below : left, in_rows ? above : right}) {
      const double toward = side == left || side == below ? -1.0 : 1.0;
      const Point2 port = in_rows ? Point2(at, side == below ? strip.y_min : strip.y_max)
                                  : Point2(side == left ? strip.x_min : strip.x_max, at);
      Rectangle box = Rectangle::nothing();
      for (const double end : {-0.5, 0.5}) {
        Point2 corner = port;
        corner[along] += end * size[along];
        box.include(corner);
        corner[1 - along] += toward * size[1 - along];
        box.include(corner);
      }
      cells.push_back({port, side, box});
    }
  }
}

}  // namespace

LabelCells label_cells(std::span<PageAnnotation* const> labels, const Rectangle& figure,
                       const Rectangle& room, LabelSides sides) {
  double height = 0.0, text = 0.0, radius = 0.0;
  for (const PageAnnotation* const label : labels) {
    height = std::max(height, label->height);
    if (label->kept->kind == KeptAnnotation::Kind::leader) {
      text = std::max(text, AnnotationPencil::leader_width(*label));
    } else {
      radius = std::max(radius, AnnotationPencil::balloon_radius(*label));
    }
  }
  Rectangle strip = figure;
  for (const PageAnnotation* const label : labels) strip.include(label->points[0]);
  strip = {strip.x_min - kFromFigure * height, strip.x_max + kFromFigure * height,
           strip.y_min - kFromFigure * height, strip.y_max + kFromFigure * height};
  const double margin = kRoomMargin * height;
  const Rectangle paper{room.x_min + margin, room.x_max - margin, room.y_min + margin,
                        room.y_max - margin};
  // Beside the figure a text needs its width, above and below it its height.
  const Point2 beside(std::max(text, 2.0 * radius), std::max(2.0 * height, 2.0 * radius));
  const Point2 over(beside.x, std::max(1.8 * height, 2.0 * radius));
  const double gap = kFromOthers * height;
  const auto has_room = [&](double before, double after, double needed) {
    return before >= needed || after >= needed;
  };
  LabelCells all;
  switch (sides) {
    case LabelSides::beside:
      all.have_room = has_room(strip.x_min - paper.x_min, paper.x_max - strip.x_max, beside.x);
      if (!all.have_room) cut(paper.x_min, paper.x_max, beside.x, strip.x_min, strip.x_max);
      add_cells(strip, 1, beside, gap, paper.y_min, paper.y_max, all.cells);
      break;
    case LabelSides::above_and_below:
      all.have_room = has_room(strip.y_min - paper.y_min, paper.y_max - strip.y_max, over.y);
      if (!all.have_room) cut(paper.y_min, paper.y_max, over.y, strip.y_min, strip.y_max);
      add_cells(strip, 0, over, gap, paper.x_min, paper.x_max, all.cells);
      break;
    case LabelSides::around:
      add_cells(strip, 1, beside, gap, strip.y_min, strip.y_max, all.cells);
      add_cells(strip, 0, over, gap, strip.x_min, strip.x_max, all.cells);
      break;
  }
  constexpr double kRounding = 1e-6;  // in pixels
  const Rectangle inside{paper.x_min - kRounding, paper.x_max + kRounding, paper.y_min - kRounding,
                         paper.y_max + kRounding};
  std::erase_if(all.cells, [&](const LabelCell& cell) { return !is_within(cell.box, inside); });
  all.have_room = all.have_room && !all.cells.empty();
  return all;
}

namespace {

/// The assignment of label cells to anchors.
class Assignment {
 public:
  Assignment(std::span<const Point2> anchors, std::span<const LabelCell> cells,
             const CrossesOthers& crosses)
      : anchors_(anchors),
        cells_(cells),
        cell_of_(anchors.size(), cells.size()),
        is_used_(cells.size()),
        crossings_(anchors.size() * cells.size()) {
    for (std::size_t i = 0; i < anchors.size(); ++i) {
      for (std::size_t c = 0; c < cells.size(); ++c) {
        if (crosses(i, c)) crossings_[i * cells.size() + c] = 1;
      }
    }
  }

  /// Gives each anchor, in this order, the free port of least cost; then moves and exchanges as
  /// long as one reduces the sum.
  void assign(double cost_of_crossing, std::span<const std::size_t> order) {
    cost_of_crossing_ = cost_of_crossing;
    std::ranges::fill(cell_of_, cells_.size());
    std::ranges::fill(is_used_, std::uint8_t{0});
    for (const std::size_t i : order) {
      if (const std::size_t cell = best_free(i); cell < cells_.size()) take(i, cell);
    }
    improve([](std::size_t, std::size_t, std::size_t) { return 0; });
  }
  /// Moves and exchanges further, where lines that cross each other cost as much.
  void untangle() {
    improve([&](std::size_t i, std::size_t cell, std::size_t other) {
      return other != i && cell_of_[other] < cells_.size() && cross(i, cell, other) ? 1 : 0;
    });
  }

  /// The number of lines that cross other annotation.
  std::size_t crossings() const {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < anchors_.size(); ++i) {
      if (cell_of_[i] < cells_.size()) sum += crossing(i, cell_of_[i]);
    }
    return sum;
  }
  bool has_tangles() const {
    for (std::size_t i = 0; i < anchors_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const bool both = cell_of_[i] < cells_.size() && cell_of_[j] < cells_.size();
        if (both && cross(i, cell_of_[i], j)) return true;
      }
    }
    return false;
  }
  const std::vector<std::size_t>& cell_of() const { return cell_of_; }

 private:
  std::uint8_t crossing(std::size_t i, std::size_t cell) const {
    return crossings_[i * cells_.size() + cell];
  }
  double cost(std::size_t i, std::size_t cell) const {
    return glm::distance(anchors_[i], cells_[cell].port) + cost_of_crossing_ * crossing(i, cell);
  }
  bool cross(std::size_t i, std::size_t cell, std::size_t other) const {
    return cross_each_other(anchors_[i], cells_[cell].port, anchors_[other],
                            cells_[cell_of_[other]].port);
  }
  std::size_t best_free(std::size_t i) const {
    std::size_t best = cells_.size();
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (is_used_[c] == 0 && (best == cells_.size() || cost(i, c) < cost(i, best))) best = c;
    }
    return best;
  }
  void take(std::size_t i, std::size_t cell) {
    if (cell_of_[i] < cells_.size()) is_used_[cell_of_[i]] = 0;
    cell_of_[i] = cell;
    is_used_[cell] = 1;
  }

  /// `tangles(i, cell, other)`: the lines of label i from that cell that cross the line of another.
  template <class Tangles>
  void improve(const Tangles& tangles) {
    const auto cost_with_tangles = [&](std::size_t i) {
      int sum = 0;
      for (std::size_t other = 0; other < anchors_.size(); ++other) {
        sum += tangles(i, cell_of_[i], other);
      }
      return cost(i, cell_of_[i]) + cost_of_crossing_ * sum;
    };
    for (bool is_better = true; is_better;) {
      is_better = false;
      for (std::size_t i = 0; i < anchors_.size(); ++i) {
        if (cell_of_[i] == cells_.size()) continue;
        for (std::size_t c = 0; c < cells_.size(); ++c) {
          if (is_used_[c] != 0) continue;
          const std::size_t before = cell_of_[i];
          const double now = cost_with_tangles(i);
          take(i, c);
          if (cost_with_tangles(i) + kLeastGain < now) {
            is_better = true;
          } else {
            take(i, before);
          }
        }
        for (std::size_t j = 0; j < i; ++j) {
          if (cell_of_[j] == cells_.size()) continue;
          const double now = cost_with_tangles(i) + cost_with_tangles(j);
          std::swap(cell_of_[i], cell_of_[j]);
          if (cost_with_tangles(i) + cost_with_tangles(j) + kLeastGain < now) {
            is_better = true;
          } else {
            std::swap(cell_of_[i], cell_of_[j]);
          }
        }
      }
    }
  }

  std::span<const Point2> anchors_;
  std::span<const LabelCell> cells_;
  std::vector<std::size_t> cell_of_;
  std::vector<std::uint8_t> is_used_, crossings_;  // per cell; per anchor and cell
  double cost_of_crossing_ = 0.0;
};

}  // namespace

std::vector<std::size_t> assigned_cells(std::span<const Point2> anchors,
                                        std::span<const LabelCell> cells,
                                        const CrossesOthers& crosses) {
  Assignment shortest(anchors, cells, crosses);
  std::vector<std::size_t> order(anchors.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  shortest.assign(0.0, order);
  if (shortest.crossings() == 0 || anchors.size() > kMostToUntangle) return shortest.cell_of();
  Assignment best = shortest;
  for (const Point2& along : {Point2(0.0, -1.0), Point2(0.0, 1.0), Point2(1.0, 0.0),
                              Point2(-1.0, 0.0), Point2(1.0, 1.0), Point2(1.0, -1.0)}) {
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return glm::dot(along, anchors[i]); });
    Assignment around = shortest;
    around.assign(kCostOfCrossing, order);
    around.untangle();
    if (!around.has_tangles() && around.crossings() < best.crossings()) best = around;
  }
  return best.cell_of();
}

}  // namespace displayfile
