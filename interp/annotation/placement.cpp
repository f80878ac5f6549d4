#include "interp/annotation/placement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <utility>

#include "clip/rectangle.h"

namespace displayfile {

namespace {

using AnnotationKind = KeptAnnotation::Kind;

// In parts of the capitals' height: clearances, and the picture's margin.
constexpr double kFromFigure = 1.5, kFromOthers = 0.7, kPageMargin = 0.5;
constexpr double kStep = 0.5;        // of a dimension line that moves outward
constexpr double kLeastGain = 1e-9;  // of an exchange, in pixels

Rectangle rectangle_of(std::span<const Point2> points) {
  Rectangle all = Rectangle::nothing();
  for (const Point2& p : points) all.include(p);
  return all;
}

bool is_within(const Rectangle& inner, const Rectangle& outer) {
  return inner.x_min >= outer.x_min && inner.x_max <= outer.x_max && inner.y_min >= outer.y_min &&
         inner.y_max <= outer.y_max;
}

bool are_apart(const Rectangle& a, const Rectangle& b, double by) {
  return a.x_min >= b.x_max + by || b.x_min >= a.x_max + by || a.y_min >= b.y_max + by ||
         b.y_min >= a.y_max + by;
}

/// True if the points' extents along some axis are apart: then so are their convex hulls.
bool are_apart(std::span<const Point2> a, std::span<const Point2> b, std::span<const Point2> axes,
               double by) {
  return std::ranges::any_of(axes, [&](const Point2& axis) {
    const auto extent = [&](std::span<const Point2> points) {
      std::pair<double, double> range{std::numeric_limits<double>::infinity(),
                                      -std::numeric_limits<double>::infinity()};
      for (const Point2& p : points) {
        const double at = glm::dot(p, axis);
        range = {std::min(range.first, at), std::max(range.second, at)};
      }
      return range;
    };
    const auto of_a = extent(a), of_b = extent(b);
    return of_a.first >= of_b.second + by || of_b.first >= of_a.second + by;
  });
}

double cross(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }

/// The corners of the convex hull, in doubles: Andrew, "Another efficient algorithm for convex
/// hulls in two dimensions", Information Processing Letters 9 (1979).
std::vector<Point2> convex_hull(std::vector<Point2> points) {
  std::ranges::sort(points, {}, [](const Point2& p) { return std::pair(p.x, p.y); });
  std::vector<Point2> hull;
  const auto add_chain = [&](const auto& range) {
    const std::size_t first = hull.size();
    for (const Point2& p : range) {
      while (hull.size() >= first + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
  };
  add_chain(points);
  std::ranges::reverse(points);
  add_chain(points);
  return hull;
}

/// A place beside the figure for a leader's text or a balloon.
struct Cell {
  Point2 port;  ///< the end of the line, on the strip's border
  PageAnnotation::Side side;
  Rectangle box;  ///< of the largest text or balloon there
};

class Placement {
 public:
  Placement(std::span<PageAnnotation> all, std::span<const Point2> figure,
            std::span<const PartsListRow> rows, const AnnotationPage& page)
      : all_(all), rows_(rows), page_(page), figure_(convex_hull({figure.begin(), figure.end()})) {}

  void place() {
    for (const PageAnnotation& one : all_) {
      if (!is_moved(one)) taken_.push_back(points_of_annotation(one));
    }
    move_dimension_lines_outward();
    choose_corners_of_lists();
    place_around();
  }

 private:
  static bool is_around(const PageAnnotation& a) {
    return a.is_automatic() &&
           (a.kept->kind == AnnotationKind::leader || a.kept->kind == AnnotationKind::balloon);
  }
  static bool is_moved(const PageAnnotation& a) {
    return is_around(a) || (a.is_automatic() && (a.kept->kind == AnnotationKind::linear ||
                                                 a.kept->kind == AnnotationKind::list));
  }
  Rectangle paper(double margin) const {
    return {margin, page_.width - margin, margin, page_.height - margin};
  }
  std::vector<Point2> points_of_annotation(const PageAnnotation& a) const {
    std::vector<AnnotationMark> marks;
    AnnotationPencil(page_, marks).draw(a, 0, rows_);
    return points_of(marks, page_);
  }

  void move_dimension_lines_outward();
  void move_outward(PageAnnotation& dimension);
  void choose_corners_of_lists();
  void place_around();
  std::vector<Cell> cells_for(std::span<PageAnnotation* const> labels) const;
  void stand_in(const Cell& cell, PageAnnotation& label) const;

  std::span<PageAnnotation> all_;
  std::span<const PartsListRow> rows_;
  const AnnotationPage& page_;
  std::vector<Point2> figure_;              // and dimensions, as soon as they are placed
  std::vector<std::vector<Point2>> taken_;  // by annotation that has its place
};

/// Step 1. The shortest first: it is nearest to the figure, and extension lines do not cross
/// dimension lines.
void Placement::move_dimension_lines_outward() {
  std::vector<PageAnnotation*> dimensions;
  for (PageAnnotation& a : all_) {
    if (a.is_automatic() && a.kept->kind == AnnotationKind::linear) dimensions.push_back(&a);
  }
  std::ranges::stable_sort(dimensions, {}, [](const PageAnnotation* a) {
    return glm::distance(a->points[2], a->points[3]);
  });
  const std::size_t of_model = figure_.size();
  for (PageAnnotation* const dimension : dimensions) move_outward(*dimension);
  figure_.resize(of_model);
  for (const PageAnnotation* const dimension : dimensions) {
    const auto points = points_of_annotation(*dimension);
    figure_.insert(figure_.end(), points.begin(), points.end());
  }
}

/// Moves a dimension line in the direction of its extension lines to the first place that is clear
/// of the figure and of other annotation, in the picture.
void Placement::move_outward(PageAnnotation& dimension) {
  const std::vector<Point2> entered = dimension.points;
  const Point2 way = entered[2] - entered[0], along = entered[3] - entered[2];
  const double length = glm::length(along);
  if (figure_.empty() || length < AnnotationPencil::line_width(dimension.height)) return;
  const Point2 level = along / length, aside(-level.y, level.x);
  const Rectangle around = rectangle_of(figure_);
  const Point2 middle(0.5 * (around.x_min + around.x_max), 0.5 * (around.y_min + around.y_max));
  const Point2 away = glm::dot(entered[2] - middle, aside) < 0.0 ? -aside : aside;
  const bool is_level = std::abs(glm::dot(way, aside)) < 0.1 * dimension.height;
  const Point2 outward = is_level ? away : way / glm::length(way);
  const Point2 axes[] = {level, aside, {1.0, 0.0}, {0.0, 1.0}};
  const double step = kStep * dimension.height;
  const auto steps = static_cast<int>((page_.width + page_.height) / step);
  for (int k = 1; k < steps; ++k) {
    for (std::size_t end = 0; end < 2; ++end) {
      dimension.points[2 + end] = entered[2 + end] - way + k * step * outward;
    }
    PageAnnotation line_alone = dimension;
    line_alone.points[0] = dimension.points[2];
    line_alone.points[1] = dimension.points[3];
    std::vector<Point2> points = points_of_annotation(line_alone);
    if (!are_apart(points, figure_, axes, kFromFigure * dimension.height)) continue;
    if (!is_within(rectangle_of(points), paper(0.0))) break;
    const bool is_clear = std::ranges::all_of(taken_, [&](const std::vector<Point2>& other) {
      return are_apart(points, other, axes, kFromOthers * dimension.height);
    });
    if (!is_clear) continue;
    return taken_.push_back(std::move(points));
  }
  dimension.points = entered;
  taken_.push_back(points_of_annotation(dimension));
}

/// Step 2. The corner in which it was entered, or else the first in which it is clear.
void Placement::choose_corners_of_lists() {
  for (PageAnnotation& list : all_) {
    if (!list.is_automatic() || list.kept->kind != AnnotationKind::list) continue;
    const Point2 entered = list.corner;
    const Point2 corners[] = {entered, {-entered.x, entered.y}, {entered.x, -entered.y}, -entered};
    const Point2 axes[] = {{1.0, 0.0}, {0.0, 1.0}};
    const auto chosen = std::ranges::find_if(corners, [&](const Point2& corner) {
      list.corner = corner;
      const auto points = points_of_annotation(list);
      return is_within(rectangle_of(points), paper(0.0)) &&
             are_apart(points, figure_, axes, kFromOthers * list.height) &&
             std::ranges::all_of(taken_, [&](const auto& other) {
               return are_apart(points, other, axes, kFromOthers * list.height);
             });
    });
    if (chosen == std::end(corners)) list.corner = entered;
    taken_.push_back(points_of_annotation(list));
  }
}

/// Step 3. Cells on both sides of a strip that holds the figure: all boxes are outside of the
/// strip, and all leaders inside.
std::vector<Cell> Placement::cells_for(std::span<PageAnnotation* const> labels) const {
  double height = 0.0, text = 0.0, radius = 0.0;
  for (const PageAnnotation* const label : labels) {
    height = std::max(height, label->height);
    if (label->kept->kind == AnnotationKind::leader) {
      text = std::max(text, AnnotationPencil::leader_width(*label));
    } else {
      radius = std::max(radius, AnnotationPencil::balloon_radius(*label));
    }
  }
  Rectangle strip = rectangle_of(figure_);
  for (const PageAnnotation* const label : labels) strip.include(label->points[0]);
  strip = {strip.x_min - kFromFigure * height, strip.x_max + kFromFigure * height,
           strip.y_min - kFromFigure * height, strip.y_max + kFromFigure * height};
  const Rectangle paper = this->paper(kPageMargin * height);
  // Beside the figure a text needs its width, above and below it its height.
  const Point2 beside(std::max(text, 2.0 * radius), std::max(2.0 * height, 2.0 * radius));
  const Point2 over(beside.x, std::max(1.8 * height, 2.0 * radius));
  const double gap = kFromOthers * height;
  const double room_beside = std::min(strip.x_min - paper.x_min, paper.x_max - strip.x_max);
  const double room_over = std::min(strip.y_min - paper.y_min, paper.y_max - strip.y_max);
  const bool in_rows = room_beside < beside.x && room_over >= over.y;
  const int across = in_rows ? 0 : 1;  // the axis along which cells follow each other
  const Point2 size = in_rows ? over : beside;
  const auto cut = [](double low, double high, double depth, double& from, double& to) {
    from = std::max(from, low + depth);
    to = std::min(to, high - depth);
    if (from > to) from = to = 0.5 * (low + high);
  };
  if (in_rows) {
    cut(paper.y_min, paper.y_max, size.y, strip.y_min, strip.y_max);
  } else {
    cut(paper.x_min, paper.x_max, size.x, strip.x_min, strip.x_max);
  }
  const double pitch = size[across] + gap;
  const double low = in_rows ? paper.x_min : paper.y_min,
               high = in_rows ? paper.x_max : paper.y_max;
  const double middle =
      in_rows ? 0.5 * (strip.x_min + strip.x_max) : 0.5 * (strip.y_min + strip.y_max);
  const double first = middle - pitch * std::floor((middle - 0.5 * size[across] - low) / pitch);
  std::vector<Cell> cells;
  for (double at = first; at + 0.5 * size[across] <= high; at += pitch) {
    using enum PageAnnotation::Side;
    for (const auto side : {in_rows ? below : left, in_rows ? above : right}) {
      const double toward = side == left || side == below ? -1.0 : 1.0;
      const Point2 port = in_rows ? Point2(at, side == below ? strip.y_min : strip.y_max)
                                  : Point2(side == left ? strip.x_min : strip.x_max, at);
      Rectangle box = Rectangle::nothing();
      for (const double end : {-0.5, 0.5}) {
        Point2 corner = port;
        corner[across] += end * size[across];
        box.include(corner);
        corner[1 - across] += toward * size[1 - across];
        box.include(corner);
      }
      const bool is_clear = std::ranges::all_of(
          taken_, [&](const auto& other) { return are_apart(box, rectangle_of(other), gap); });
      if (is_clear) cells.push_back({port, side, box});
    }
  }
  return cells;
}

void Placement::stand_in(const Cell& cell, PageAnnotation& label) const {
  using enum PageAnnotation::Side;
  label.side = cell.side;
  label.at = cell.port;
  if (label.kept->kind == AnnotationKind::leader) return;
  const double radius = AnnotationPencil::balloon_radius(label);
  label.line_end = cell.port;
  label.at += radius * (cell.side == left    ? Point2(-1.0, 0.0)
                        : cell.side == right ? Point2(1.0, 0.0)
                        : cell.side == above ? Point2(0.0, 1.0)
                                             : Point2(0.0, -1.0));
}

/// Gives each anchor a port of its own: the nearest that is free, in their order; then moves to
/// free ports and exchanges of two, as long as one makes the lines shorter. Returns the number of
/// each anchor's port, or the number of ports where none was left.
std::vector<std::size_t> assigned(std::span<const Point2> anchors, std::span<const Cell> cells) {
  const auto length = [&](std::size_t anchor, std::size_t cell) {
    return glm::distance(anchors[anchor], cells[cell].port);
  };
  std::vector<std::size_t> cell_of(anchors.size(), cells.size());
  std::vector<std::uint8_t> is_used(cells.size());
  const auto nearest_free = [&](std::size_t i) {
    std::size_t best = cells.size();
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (is_used[c] == 0 && (best == cells.size() || length(i, c) < length(i, best))) best = c;
    }
    return best;
  };
  const auto take = [&](std::size_t i, std::size_t cell) {
    if (cell_of[i] < cells.size()) is_used[cell_of[i]] = 0;
    cell_of[i] = cell;
    is_used[cell] = 1;
  };
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    if (const std::size_t cell = nearest_free(i); cell < cells.size()) take(i, cell);
  }
  for (bool is_shorter = true; is_shorter;) {
    is_shorter = false;
    for (std::size_t i = 0; i < anchors.size(); ++i) {
      if (cell_of[i] == cells.size()) continue;
      const std::size_t free = nearest_free(i);
      if (free < cells.size() && length(i, free) + kLeastGain < length(i, cell_of[i])) {
        take(i, free);
        is_shorter = true;
      }
      for (std::size_t j = 0; j < i; ++j) {
        if (cell_of[j] == cells.size()) continue;
        const double now = length(i, cell_of[i]) + length(j, cell_of[j]);
        if (length(i, cell_of[j]) + length(j, cell_of[i]) + kLeastGain >= now) continue;
        std::swap(cell_of[i], cell_of[j]);
        is_shorter = true;
      }
    }
  }
  return cell_of;
}

/// Steps 3 and 4.
void Placement::place_around() {
  std::vector<PageAnnotation*> labels;
  for (PageAnnotation& a : all_) {
    if (is_around(a)) labels.push_back(&a);
  }
  if (labels.empty()) return;
  std::ranges::stable_sort(labels, {}, [](const PageAnnotation* a) { return -a->points[0].y; });
  std::vector<Point2> anchors;
  anchors.reserve(labels.size());
  for (const PageAnnotation* const label : labels) anchors.push_back(label->points[0]);
  const std::vector<Cell> cells = cells_for(labels);
  const std::vector<std::size_t> cell_of = assigned(anchors, cells);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (cell_of[i] < cells.size()) stand_in(cells[cell_of[i]], *labels[i]);
  }
}

}  // namespace

void place_annotation(std::span<PageAnnotation> all, std::span<const Point2> figure,
                      std::span<const PartsListRow> rows, const AnnotationPage& page) {
  Placement(all, figure, rows, page).place();
}

}  // namespace displayfile
