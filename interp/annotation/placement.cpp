#include "interp/annotation/placement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

#include "interp/annotation/label_cells.h"
#include "interp/annotation/page_shapes.h"

namespace displayfile {

namespace {

using AnnotationKind = KeptAnnotation::Kind;

// In parts of the capitals' height.
constexpr double kStep = 0.5;          // of a dimension that moves outward
constexpr double kStepOfList = 1.0;    // between places of a parts list
constexpr double kFarthestArc = 10.0;  // beyond the points that an angle is measured by
constexpr Point2 kLevelAxes[] = {{1.0, 0.0}, {0.0, 1.0}};

class Placement {
 public:
  Placement(std::span<PageAnnotation> all, const PageFigure& figure,
            std::span<const PartsListRow> rows, const AnnotationPage& page, const LabelRoom& room)
      : all_(all),
        rows_(rows),
        page_(page),
        figure_(figure.points),
        boxes_(figure.boxes),
        room_(room),
        around_(figure_.around()) {}

  void place() {
    reduce_titles();
    for (const PageAnnotation& one : all_) {
      if (is_moved(one)) continue;
      for (const AnnotationMark& mark : marks_of(one))
        taken_.push_back(points_of({&mark, 1}, page_));
    }
    move_dimension_lines_outward();
    move_numbers_outward();
    place_lists();
    for (const Rectangle& box : room_.occupied) taken_.push_back(corners_of(box));
    place_around();
  }

 private:
  static bool is_around(const PageAnnotation& a) {
    return a.is_automatic() &&
           (a.kept->kind == AnnotationKind::leader || a.kept->kind == AnnotationKind::balloon);
  }
  static bool is_moved(const PageAnnotation& a) {
    return a.is_automatic() && a.kept->kind != AnnotationKind::title;
  }
  Rectangle paper() const {
    return {0.0, static_cast<double>(page_.width), 0.0, static_cast<double>(page_.height)};
  }
  std::vector<AnnotationMark> marks_of(const PageAnnotation& a) const {
    std::vector<AnnotationMark> marks;
    AnnotationPencil(page_, marks).draw(a, 0, rows_);
    return marks;
  }
  std::vector<Point2> points_of_annotation(const PageAnnotation& a) const {
    return points_of(marks_of(a), page_);
  }
  bool is_clear_of_others(std::span<const Point2> points, std::span<const Point2> axes,
                          double height) const {
    return std::ranges::all_of(taken_, [&](const std::vector<Point2>& other) {
      return are_apart(points, other, axes, kFromOthers * height);
    });
  }
  int steps_outward(double step) const {
    return static_cast<int>((page_.width + page_.height) / step);
  }
  /// Ends the search for a place of a dimension.
  void take(PageAnnotation& dimension, std::vector<Point2> points) {
    for (const Point2& p : points) around_.include(p);
    taken_.push_back(std::move(points));
    for (const Point2& p : points_of_annotation(dimension)) around_.include(p);
  }
  void leave_as_entered(PageAnnotation& dimension) {
    dimension.has_place = false;
    take(dimension, points_of_annotation(dimension));
  }

  bool is_clear_of_figure(std::span<const Point2> points, double by) const;
  void reduce_titles();
  void move_dimension_lines_outward();
  void move_outward(PageAnnotation& dimension);
  void move_numbers_outward();
  void move_number_outward(PageAnnotation& dimension);
  void move_arc_outward(PageAnnotation& dimension);
  bool try_place(PageAnnotation& dimension, std::vector<Point2> alone,
                 std::span<const Point2> axes);
  void place_lists();
  enum class ClearOf { outline, boxes };
  bool is_clear_place_of_list(const PageAnnotation& list, ClearOf figure) const;
  bool find_place_of_list(PageAnnotation& list) const;
  void place_around();
  using PageLine = std::pair<Point2, Point2>;
  /// The assignment of labels to cells, and its costs, the most important first.
  struct Labelling {
    std::vector<LabelCell> cells;
    std::vector<std::size_t> cell_of;
    /// No room; labels without a cell; lines that cross other annotation; the lines' length.
    std::tuple<bool, std::size_t, std::size_t, double> cost;
  };
  Labelling labelling_on(LabelSides sides, std::span<PageAnnotation* const> labels,
                         std::span<const PageLine> others) const;
  std::vector<PageLine> lines_of_others() const;
  static void stand_in(const LabelCell& cell, PageAnnotation& label);

  std::span<PageAnnotation> all_;
  std::span<const PartsListRow> rows_;
  const AnnotationPage& page_;
  FigureOutline figure_;
  std::span<const Rectangle> boxes_;
  const LabelRoom& room_;
  Rectangle around_;                        // the figure, and dimensions that have their place
  std::vector<std::vector<Point2>> taken_;  // by annotation that has its place, or its parts
};

/// Clear of the outline, or of the rectangles around all polygons and lines.
bool Placement::is_clear_of_figure(std::span<const Point2> points, double by) const {
  const Rectangle box = rectangle_of(points);
  return figure_.is_clear_of(points, by) || std::ranges::all_of(boxes_, [&](const Rectangle& part) {
           return are_apart(box, part, by);
         });
}

/// Titles stay at the picture's upper margin: one that covers the figure becomes smaller if that
/// helps.
void Placement::reduce_titles() {
  for (PageAnnotation& title : all_) {
    if (!title.is_automatic() || title.kept->kind != AnnotationKind::title) continue;
    const auto is_clear = [&] {
      const std::vector<Point2> points = points_of_annotation(title);
      return points.empty() || is_clear_of_figure(points, 0.0);
    };
    while (!is_clear() && title.has_place) {
      title.has_place = ++title.title_reduced < kTitleHeights.size();
    }
    if (!title.has_place) title.title_reduced = 0;
  }
}

// ---- Step 1: dimension lines ----------------------------------------------------------------

/// The shortest first: it is nearest to the figure, and extension lines do not cross dimension
/// lines.
void Placement::move_dimension_lines_outward() {
  std::vector<PageAnnotation*> dimensions;
  for (PageAnnotation& a : all_) {
    if (a.is_automatic() && a.kept->kind == AnnotationKind::linear) dimensions.push_back(&a);
  }
  std::ranges::stable_sort(dimensions, {}, [](const PageAnnotation* a) {
    return glm::distance(a->points[2], a->points[3]);
  });
  for (PageAnnotation* const dimension : dimensions) move_outward(*dimension);
}

/// Moves a dimension line in the direction of its extension lines to the first place that is clear
/// of the figure and of other annotation, in the picture.
void Placement::move_outward(PageAnnotation& dimension) {
  const std::vector<Point2> entered = dimension.points;
  const Point2 way = entered[2] - entered[0], along = entered[3] - entered[2];
  const double length = glm::length(along);
  if (figure_.is_empty() || length < AnnotationPencil::line_width(dimension.height)) return;
  const Point2 level = along / length, aside(-level.y, level.x);
  const Rectangle& around = figure_.around();
  const Point2 middle(0.5 * (around.x_min + around.x_max), 0.5 * (around.y_min + around.y_max));
  const Point2 away = glm::dot(entered[2] - middle, aside) < 0.0 ? -aside : aside;
  const bool is_level = std::abs(glm::dot(way, aside)) < 0.1 * dimension.height;
  const Point2 outward = is_level ? away : way / glm::length(way);
  const Point2 axes[] = {level, aside, {1.0, 0.0}, {0.0, 1.0}};
  const double step = kStep * dimension.height;
  for (int k = 1; k < steps_outward(step); ++k) {
    for (std::size_t end = 0; end < 2; ++end) {
      dimension.points[2 + end] = entered[2 + end] - way + k * step * outward;
    }
    PageAnnotation line_alone = dimension;
    line_alone.points[0] = dimension.points[2];
    line_alone.points[1] = dimension.points[3];
    std::vector<Point2> points = points_of_annotation(line_alone);
    if (!are_apart(points, figure_.corners(), axes, kFromFigure * dimension.height)) continue;
    if (!is_within(rectangle_of(points), paper())) break;
    if (!is_clear_of_others(points, axes, dimension.height)) continue;
    return take(dimension, std::move(points));
  }
  dimension.points = entered;
  leave_as_entered(dimension);
}

// ---- Step 2: radii, diameters and angles ----------------------------------------------------

void Placement::move_numbers_outward() {
  for (PageAnnotation& a : all_) {
    if (!a.is_automatic() || figure_.is_empty()) continue;
    if (a.kept->kind == AnnotationKind::radius || a.kept->kind == AnnotationKind::diameter) {
      move_number_outward(a);
    } else if (a.kept->kind == AnnotationKind::angle) {
      move_arc_outward(a);
    }
  }
}

/// Takes the place if the marks drawn there, `alone`, are clear of the figure and of other
/// annotation, in the picture.
bool Placement::try_place(PageAnnotation& dimension, std::vector<Point2> alone,
                          std::span<const Point2> axes) {
  const double height = dimension.height;
  if (!figure_.is_clear_of(alone, kFromFigure * height) &&
      !are_apart(alone, figure_.corners(), axes, kFromFigure * height)) {
    return false;
  }
  if (!is_within(rectangle_of(alone), paper())) return false;
  if (!is_clear_of_others(alone, axes, height)) return false;
  take(dimension, std::move(alone));
  return true;
}

/// Makes the line longer, beyond the end that is nearer to the outside, until the number has a
/// place.
void Placement::move_number_outward(PageAnnotation& dimension) {
  const Point2 along = dimension.points[1] - dimension.points[0];
  const double length = glm::length(along), step = kStep * dimension.height;
  if (length < AnnotationPencil::line_width(dimension.height)) return;
  const Point2 level = along / length;
  const Point2 axes[] = {level, {-level.y, level.x}, {1.0, 0.0}, {0.0, 1.0}};
  const bool has_two_ends = dimension.kept->kind == AnnotationKind::diameter;
  for (int k = 1; k < steps_outward(step); ++k) {
    for (const double way : {1.0, -1.0}) {
      if (way < 0.0 && !has_two_ends) continue;
      dimension.number_beyond = way * k * step;
      std::vector<AnnotationMark> marks = marks_of(dimension);
      std::erase_if(marks, [](const AnnotationMark& mark) {
        return mark.kind != AnnotationMark::Kind::text;
      });
      if (try_place(dimension, points_of(marks, page_), axes)) return;
    }
  }
  dimension.number_beyond.reset();
  leave_as_entered(dimension);
}

/// Makes the arc larger, or draws it between the opposite directions, which is the same angle.
void Placement::move_arc_outward(PageAnnotation& dimension) {
  const std::vector<Point2> entered = dimension.points;
  const Point2 vertex = entered[0], middle = entered[3 + (entered.size() - 3) / 2];
  const double radius = glm::distance(vertex, middle), step = kStep * dimension.height;
  if (radius < AnnotationPencil::line_width(dimension.height)) return;
  const Point2 out = (middle - vertex) / radius;
  const Point2 axes[] = {out, {-out.y, out.x}, {1.0, 0.0}, {0.0, 1.0}};
  const double farthest =
      kFarthestArc * dimension.height +
      std::max({radius, glm::distance(vertex, entered[1]), glm::distance(vertex, entered[2])});
  for (int k = 0; radius + k * step <= farthest; ++k) {
    for (const double way : {1.0, -1.0}) {
      for (std::size_t i = 3; i < entered.size(); ++i) {
        dimension.points[i] = vertex + way * (1.0 + k * step / radius) * (entered[i] - vertex);
      }
      PageAnnotation arc_alone = dimension;
      arc_alone.points[1] = dimension.points[3];
      arc_alone.points[2] = dimension.points.back();
      if (try_place(dimension, points_of_annotation(arc_alone), axes)) return;
    }
  }
  dimension.points = entered;
  leave_as_entered(dimension);
}

// ---- Step 3: parts lists --------------------------------------------------------------------

/// True if clear of the figure's convex outline, or, which takes longer, of each of its parts.
bool Placement::is_clear_place_of_list(const PageAnnotation& list, ClearOf figure) const {
  const std::vector<Point2> points = points_of_annotation(list);
  const Rectangle box = rectangle_of(points);
  if (!is_within(box, paper()) || !is_clear_of_others(points, kLevelAxes, list.height)) {
    return false;
  }
  const double by = kFromOthers * list.height;
  if (figure == ClearOf::outline) return figure_.is_clear_of(points, by);
  return std::ranges::all_of(boxes_,
                             [&](const Rectangle& part) { return are_apart(box, part, by); });
}

/// Tries the corner in which the list was entered, the other corners, and then all places; the
/// nearest clear one to the entered place is taken.
bool Placement::find_place_of_list(PageAnnotation& list) const {
  const Point2 entered = list.corner;
  const Point2 corners[] = {entered, {-entered.x, entered.y}, {entered.x, -entered.y}, -entered};
  for (const ClearOf figure : {ClearOf::outline, ClearOf::boxes}) {
    for (const Point2& corner : corners) {
      list.corner = corner;
      if (is_clear_place_of_list(list, figure)) return true;
    }
  }
  list.corner = entered;
  const Rectangle there = rectangle_of(points_of_annotation(list));
  const double margin = AnnotationPencil::margin_of_list(list.height);
  const double step = kStepOfList * list.height;
  const double right = page_.width - margin - (there.x_max - there.x_min);
  const double low = margin + (there.y_max - there.y_min);
  std::vector<Point2> places;
  for (double x = margin; x <= right; x += step) {
    for (double y = page_.height - margin; y >= low; y -= step) places.emplace_back(x, y);
  }
  std::ranges::stable_sort(places, {}, [&](const Point2& place) {
    return glm::distance(place, Point2(there.x_min, there.y_max));
  });
  for (const Point2& place : places) {
    list.top_left = place;
    if (is_clear_place_of_list(list, ClearOf::outline)) return true;
  }
  list.top_left.reset();
  return false;
}

void Placement::place_lists() {
  for (PageAnnotation& list : all_) {
    if (!list.is_automatic() || list.kept->kind != AnnotationKind::list || rows_.empty()) continue;
    list.has_place = find_place_of_list(list);
    taken_.push_back(points_of_annotation(list));
  }
}

// ---- Steps 4 and 5: leaders and balloons ----------------------------------------------------

/// The lines, and the sides of areas and texts, of all annotation that is not placed in cells.
std::vector<Placement::PageLine> Placement::lines_of_others() const {
  std::vector<PageLine> lines;
  for (const Rectangle& box : room_.occupied) {
    const std::vector<Point2> corners = corners_of(box);
    for (std::size_t i = 0; i < 4; ++i) lines.emplace_back(corners[i], corners[(i + 1) % 4]);
  }
  for (const PageAnnotation& other : all_) {
    if (is_around(other)) continue;
    for (const AnnotationMark& mark : marks_of(other)) {
      std::vector<Point2> points = points_of({&mark, 1}, page_);
      if (mark.kind == AnnotationMark::Kind::text) std::swap(points[2], points[3]);
      for (std::size_t i = 1; i < points.size(); ++i) lines.emplace_back(points[i - 1], points[i]);
      const bool is_open = mark.kind == AnnotationMark::Kind::line && !mark.closed;
      if (!is_open && !points.empty()) lines.emplace_back(points.back(), points.front());
    }
  }
  return lines;
}

/// The cells on these sides that other annotation does not cover, and the labels in them.
Placement::Labelling Placement::labelling_on(LabelSides sides,
                                             std::span<PageAnnotation* const> labels,
                                             std::span<const PageLine> others) const {
  double height = 0.0;
  std::vector<Point2> anchors;
  for (const PageAnnotation* const label : labels) {
    height = std::max(height, label->height);
    anchors.push_back(label->points[0]);
  }
  LabelCells found = label_cells(labels, around_, room_.around.value_or(paper()), sides);
  std::erase_if(found.cells, [&](const LabelCell& cell) {
    return std::ranges::any_of(taken_, [&](const std::vector<Point2>& other) {
      return !are_apart(cell.box, rectangle_of(other), kFromOthers * height);
    });
  });
  Labelling labelling{std::move(found.cells), {}, {!found.have_room, 0, 0, 0.0}};
  const std::vector<LabelCell>& cells = labelling.cells;
  const auto crosses = [&](std::size_t i, std::size_t c) {
    return std::ranges::any_of(others, [&](const PageLine& line) {
      return cross_each_other(anchors[i], cells[c].port, line.first, line.second);
    });
  };
  labelling.cell_of = assigned_cells(anchors, cells, crosses);
  auto& [has_no_room, without_cell, crossings, length] = labelling.cost;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const std::size_t cell = labelling.cell_of[i];
    if (cell == cells.size()) {
      ++without_cell;
      continue;
    }
    if (crosses(i, cell)) ++crossings;
    length += glm::distance(anchors[i], cells[cell].port);
  }
  return labelling;
}

void Placement::stand_in(const LabelCell& cell, PageAnnotation& label) {
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

void Placement::place_around() {
  std::vector<PageAnnotation*> labels;
  for (PageAnnotation& a : all_) {
    if (is_around(a)) labels.push_back(&a);
  }
  if (labels.empty()) return;
  std::ranges::stable_sort(labels, {}, [](const PageAnnotation* a) { return -a->points[0].y; });
  const std::vector<PageLine> others = lines_of_others();
  Labelling best = labelling_on(LabelSides::beside, labels, others);
  for (const LabelSides sides : {LabelSides::above_and_below, LabelSides::around}) {
    Labelling other = labelling_on(sides, labels, others);
    if (other.cost < best.cost) best = std::move(other);
  }
  const std::vector<LabelCell>& cells = best.cells;
  const std::vector<std::size_t>& cell_of = best.cell_of;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    labels[i]->has_place = cell_of[i] < cells.size();
    if (!labels[i]->has_place) continue;
    const LabelCell& cell = cells[cell_of[i]];
    stand_in(cell, *labels[i]);
    labels[i]->has_place = figure_.is_clear_of(corners_of(cell.box), 0.0);
  }
}

}  // namespace

void PageFigure::add(std::span<const Point2> item) {
  points.insert(points.end(), item.begin(), item.end());
  boxes.push_back(rectangle_of(item));
}

void place_annotation(std::span<PageAnnotation> all, const PageFigure& figure,
                      std::span<const PartsListRow> rows, const AnnotationPage& page,
                      const LabelRoom& room) {
  Placement(all, figure, rows, page, room).place();
}

}  // namespace displayfile
