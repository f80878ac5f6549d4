#include "programs/sheet/sheet_annotation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "interp/annotation/annotation_marks.h"
#include "interp/annotation/page_annotation.h"
#include "interp/annotation/page_shapes.h"
#include "interp/annotation/placement.h"
#include "programs/sheet/blanked_lines.h"

namespace displayfile {

namespace {

using Kind = KeptAnnotation::Kind;

constexpr std::size_t kViewsWithDimensions = 3;  // the isometric view shows no length true
constexpr double kParallel = 1e-9;               // in parts of a dimension's length
// For labels beside a view, in heights of capitals.
constexpr double kLinesOfLeader = 2.0, kClearances = 3.0;

/// The points of a dimension in a view; nothing if it is not parallel to the view. Of a linear
/// dimension, only its line must be parallel: the points that it measures may be at different
/// depths.
std::optional<std::vector<Point3>> points_in(ViewKind view, const KeptAnnotation& dimension) {
  std::vector<Point3> points;
  for (const Point3& p : dimension.points) points.push_back(in_view(view, p));
  const auto measured =
      std::span<const Point3>(points).subspan(dimension.kind == Kind::linear ? 2 : 0);
  double length = 0.0, depth = 0.0;
  for (const Point3& p : measured) {
    length = std::max(length, glm::distance(p, measured[0]));
    depth = std::max(depth, std::abs(p.z - measured[0].z));
  }
  if (depth > kParallel * length) return std::nullopt;
  return points;
}

/// How well a view shows a dimension that is parallel to it.
double merit_in(ViewKind view, const KeptAnnotation& dimension, std::span<const Point3> points,
                std::span<const CentreAxis> axes) {
  if (dimension.kind == Kind::linear) {
    return glm::distance(Point2(points[0]), Point2(points[2])) +
           glm::distance(Point2(points[1]), Point2(points[3]));
  }
  if (dimension.kind == Kind::angle) return 0.0;
  const bool is_radius = dimension.kind == Kind::radius;
  const Point2 centre = is_radius ? Point2(points[0]) : Point2(0.5 * (points[0] + points[1]));
  const double reach = kParallel * glm::distance(points[0], points[1]);
  const bool shows_circle = std::ranges::any_of(axes, [&](const CentreAxis& axis) {
    const Point2 from(in_view(view, axis.from)), to(in_view(view, axis.to));
    return glm::distance(from, centre) <= reach && glm::distance(to, centre) <= reach;
  });
  return shows_circle ? 1.0 : 0.0;
}

/// The view that shows a dimension, and its points there; nothing if it is parallel to none.
struct ShownDimension {
  std::size_t view;
  std::vector<Point3> points;
};
std::optional<ShownDimension> shown(const KeptAnnotation& dimension,
                                    const std::array<PartDrawing, 4>& views,
                                    std::span<const CentreAxis> axes) {
  std::optional<ShownDimension> best;
  double most = 0.0;
  for (std::size_t k = 0; k < kViewsWithDimensions; ++k) {
    auto points = points_in(views[k].kind, dimension);
    if (!points) continue;
    const double merit = merit_in(views[k].kind, dimension, *points, axes);
    if (best && merit <= most + kParallel * std::abs(most)) continue;
    best = {k, std::move(*points)};
    most = merit;
  }
  return best;
}

double millimetres_of(const AnnotationStyle& style) {
  return style.unit == AnnotationStyle::Unit::pixels ? 1.0 / kPixelsOfMillimetre : 1.0;
}

/// At the place where it was entered.
PageAnnotation on_paper(const KeptAnnotation& kept, std::span<const Point3> points,
                        const PartDrawing& view, const ViewPlace& place) {
  const double mm = millimetres_of(kept.style);
  PageAnnotation result{&kept, kept.style.size * mm, {}};
  for (const Point3& p : points) result.points.push_back(place.on_paper(view, Point2(p)));
  if (!is_label(kept)) return result;
  result.at = result.points[0] + mm * kept.offset;
  result.side = kept.offset.x < 0.0 ? PageAnnotation::Side::left : PageAnnotation::Side::right;
  return result;
}

/// Lines from the first corner to the opposite side, a line's width apart.
void add_filled(const AnnotationMark& mark, SheetLayer layer, DrawingSheet& sheet) {
  const std::vector<Point2>& p = mark.points;
  sheet.lines.push_back({layer, p, true});
  double along = 0.0;  // since the last line
  for (std::size_t i = 2; i < p.size(); ++i) {
    const double side = glm::distance(p[i - 1], p[i]);
    for (double at = mark.width - along; at < side; at += mark.width) {
      sheet.lines.push_back({layer, {p[0], p[i - 1] + at / side * (p[i] - p[i - 1])}});
      along = -at;
    }
    along += side;
  }
}

void add_mark(const AnnotationMark& mark, SheetLayer layer, const AnnotationPage& page,
              DrawingSheet& sheet) {
  switch (mark.kind) {
    case AnnotationMark::Kind::line:
      sheet.lines.push_back({layer, mark.points, mark.closed});
      return;
    case AnnotationMark::Kind::area: return add_filled(mark, layer, sheet);
    case AnnotationMark::Kind::blank: return remove_lines_within(mark.points, sheet);
    case AnnotationMark::Kind::text: break;
  }
  const DeviceText& text = mark.text;
  sheet.texts.push_back({{text.anchor.x * page.width, text.anchor.y * page.height},
                         text.style.size * page.height * kCapitalsOfEm,
                         text.characters,
                         text.style.alignment,
                         text.turn,
                         layer});
}

Rectangle as_rectangle(const PaperBox& box) {
  return {box.low.x, box.high.x, box.low.y, box.high.y};
}

/// The annotation of each view, and the other contents of the paper.
class AnnotatedSheet {
 public:
  AnnotatedSheet(const std::array<PartDrawing, 4>& views, std::span<const ViewPlace> places,
                 std::span<const PaperBox> reserved, double margin, DrawingSheet& sheet,
                 std::vector<PaperBox>& taken)
      : views_(views), places_(places), reserved_(reserved), sheet_(sheet), taken_(taken) {
    page_ = {static_cast<int>(std::ceil(sheet.width)), static_cast<int>(std::ceil(sheet.height)),
             1.0};
    frame_ = {margin, sheet.width - margin, margin, sheet.height - margin};
    for (std::size_t k = 0; k < views.size(); ++k) {
      boxes_.push_back(
          rectangle_of(std::array{places[k].at, places[k].on_paper(views[k], views[k].high)}));
    }
  }

  void add(std::size_t view, const KeptAnnotation& kept, std::span<const Point3> points) {
    of_views_[view].push_back(on_paper(kept, points, views_[view], places_[view]));
  }
  void left_out(std::string sentence) { sentences_.push_back(std::move(sentence)); }

  std::vector<std::string> draw() {
    for (std::size_t k = 0; k < of_views_.size(); ++k) {
      if (of_views_[k].empty()) continue;
      place_annotation(of_views_[k], figure_of(k), {}, page_, label_room(k));
      for (std::size_t i = 0; i < of_views_[k].size(); ++i) draw(k, i);
    }
    return std::move(sentences_);
  }

 private:
  PageFigure figure_of(std::size_t k) const {
    PageFigure figure;
    for (const PartDrawing::Line& line : views_[k].lines) {
      figure.add(std::array{places_[k].on_paper(views_[k], line.from),
                            places_[k].on_paper(views_[k], line.to)});
    }
    return figure;
  }
  LabelRoom label_room(std::size_t k) const;
  void draw(std::size_t k, std::size_t i);
  void take_line(const AnnotationMark& mark);
  std::string_view fault_of(std::size_t k, const PageAnnotation& annotation,
                            std::span<const AnnotationMark> marks) const;

  const std::array<PartDrawing, 4>& views_;
  std::span<const ViewPlace> places_;
  std::span<const PaperBox> reserved_;  // for marks to come
  DrawingSheet& sheet_;
  std::vector<PaperBox>& taken_;
  AnnotationPage page_{};
  Rectangle frame_{};
  std::vector<Rectangle> boxes_;  // of views
  std::array<std::vector<PageAnnotation>, 4> of_views_;
  std::vector<std::string> sentences_;
};

/// The room up to the contents beside, above and below the view.
LabelRoom AnnotatedSheet::label_room(std::size_t k) const {
  const Rectangle& view = boxes_[k];
  LabelRoom room{frame_, {}};
  for (std::size_t other = 0; other < boxes_.size(); ++other) {
    if (other != k) room.occupied.push_back(boxes_[other]);
  }
  const std::size_t fixed = room.occupied.size();
  for (const PaperBox& box : taken_) room.occupied.push_back(as_rectangle(box));
  for (const PaperBox& box : reserved_) room.occupied.push_back(as_rectangle(box));
  Rectangle& around = *room.around;
  for (std::size_t i = 0; i < fixed; ++i) {
    const Rectangle& box = room.occupied[i];
    if (box.y_min < view.y_max && view.y_min < box.y_max) {
      if (box.x_max <= view.x_min) around.x_min = std::max(around.x_min, box.x_max);
      if (box.x_min >= view.x_max) around.x_max = std::min(around.x_max, box.x_min);
    }
    if (box.x_min < view.x_max && view.x_min < box.x_max) {
      if (box.y_max <= view.y_min) around.y_min = std::max(around.y_min, box.y_max);
      if (box.y_min >= view.y_max) around.y_max = std::min(around.y_max, box.y_min);
    }
  }
  return room;
}

/// As boxes along it, so that little beside it is taken.
void AnnotatedSheet::take_line(const AnnotationMark& mark) {
  constexpr double kStep = 3.0;  // mm
  for (std::size_t i = 1; i < mark.points.size(); ++i) {
    const Point2 &from = mark.points[i - 1], along = mark.points[i] - from;
    const int steps = static_cast<int>(std::ceil(glm::length(along) / kStep));
    for (int k = 0; k < steps; ++k) {
      const Point2 a = from + (1.0 * k / steps) * along, b = from + (k + 1.0) / steps * along;
      taken_.push_back({glm::min(a, b), glm::max(a, b)});
    }
  }
}

void AnnotatedSheet::draw(std::size_t k, std::size_t i) {
  const PageAnnotation& annotation = of_views_[k][i];
  const SheetLayer layer = is_label(*annotation.kept) ? SheetLayer::leader : SheetLayer::dimension;
  std::vector<AnnotationMark> marks;
  AnnotationPencil(page_, marks).draw(annotation, i, {});
  for (const AnnotationMark& mark : marks) {
    add_mark(mark, layer, page_, sheet_);
    if (layer == SheetLayer::leader && mark.kind == AnnotationMark::Kind::line) take_line(mark);
    if (mark.kind != AnnotationMark::Kind::text && mark.kind != AnnotationMark::Kind::blank)
      continue;
    const Rectangle box = rectangle_of(points_of({&mark, 1}, page_));
    taken_.push_back({{box.x_min, box.y_min}, {box.x_max, box.y_max}});
  }
  if (const std::string_view fault = fault_of(k, annotation, marks); !fault.empty()) {
    left_out(fmt::format("{} {}", name_in_message(*annotation.kept), fault));
  }
}

/// The fault of an annotation in view k, as a part of a sentence; empty if there is none.
std::string_view AnnotatedSheet::fault_of(std::size_t k, const PageAnnotation& annotation,
                                          std::span<const AnnotationMark> marks) const {
  if (marks.empty()) return "is shorter than a line is wide: left out";
  const Rectangle around = rectangle_of(points_of(marks, page_));
  if (!is_within(around, frame_)) return "reaches beyond the sheet's frame";
  for (std::size_t other = 0; other < boxes_.size(); ++other) {
    if (other != k && !are_apart(around, boxes_[other], 0.0)) return "reaches over another view";
  }
  if (annotation.has_place) return {};
  return "has no room beside the view: expected a smaller scale or larger paper";
}

}  // namespace

bool is_label(const KeptAnnotation& annotation) {
  return annotation.kind == Kind::leader || annotation.kind == Kind::balloon;
}

double gap_for_labels(const PartAnnotation& annotation) {
  double gap = 0.0;
  for (const KeptAnnotation& one : annotation.all) {
    if (!is_label(one) || one.style.placement != AnnotationStyle::Placement::automatic) continue;
    const PageAnnotation label{&one, one.style.size * millimetres_of(one.style), {}};
    const double size = one.kind == Kind::balloon ? 2.0 * AnnotationPencil::balloon_radius(label)
                                                  : kLinesOfLeader * label.height;
    gap = std::max(gap, size + kClearances * label.height);
  }
  return gap;
}

std::vector<std::string> add_annotation(const PartAnnotation& annotation,
                                        const std::array<PartDrawing, 4>& views,
                                        std::span<const ViewPlace> places,
                                        std::span<const PaperBox> reserved, double margin,
                                        DrawingSheet& sheet, std::vector<PaperBox>& taken) {
  AnnotatedSheet annotated(views, places, reserved, margin, sheet, taken);
  for (std::size_t i = 0; i < annotation.all.size(); ++i) {
    const KeptAnnotation& one = annotation.all[i];
    if (is_label(one)) {
      const std::size_t view = annotation.shown_in[i];
      annotated.add(view, one, std::array{in_view(views[view].kind, one.points[0])});
    } else if (const auto dimension = shown(one, views, annotation.axes)) {
      annotated.add(dimension->view, one, dimension->points);
    } else {
      annotated.left_out(name_in_message(one) + " is parallel to no view: left out");
    }
  }
  return annotated.draw();
}

}  // namespace displayfile
