#include "programs/sheet/sheet_dimensions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>
#include <string_view>

#include "interp/annotation/annotation_marks.h"
#include "interp/annotation/page_annotation.h"
#include "interp/annotation/page_shapes.h"
#include "interp/annotation/placement.h"

namespace displayfile {

namespace {

using Kind = KeptAnnotation::Kind;

constexpr std::size_t kViewsWithDimensions = 3;  // the isometric one shows no length as it is
constexpr double kParallel = 1e-9;               // in parts of a dimension's length

/// The points of a dimension in a view; nothing if it is not parallel to the view. Of a linear one
/// that is its line alone: the points that it measures may be at different depths.
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

/// The dimensions of one view, on the paper.
struct DimensionsOfView {
  std::vector<PageAnnotation> all;
  PageFigure figure;  ///< the view's lines
};

double height_of(const AnnotationStyle& style) {
  constexpr double kMillimetre = 1.0 / kPixelsOfMillimetre;  // of a pixel
  return style.size * (style.unit == AnnotationStyle::Unit::pixels ? kMillimetre : 1.0);
}

/// Lines from the first corner to the opposite side, a line's width apart.
void add_filled(const AnnotationMark& mark, DrawingSheet& sheet) {
  const std::vector<Point2>& p = mark.points;
  sheet.lines.push_back({SheetLayer::dimension, p, true});
  for (std::size_t i = 2; i < p.size(); ++i) {
    const double lines = std::ceil(glm::distance(p[i - 1], p[i]) / mark.width);
    for (double k = 1.0; k < lines; ++k) {
      sheet.lines.push_back(
          {SheetLayer::dimension, {p[0], p[i - 1] + k / lines * (p[i] - p[i - 1])}});
    }
  }
}

void add_mark(const AnnotationMark& mark, const AnnotationPage& page, DrawingSheet& sheet) {
  switch (mark.kind) {
    case AnnotationMark::Kind::line:
      sheet.lines.push_back({SheetLayer::dimension, mark.points, mark.closed});
      return;
    case AnnotationMark::Kind::area: return add_filled(mark, sheet);
    case AnnotationMark::Kind::blank: return;
    case AnnotationMark::Kind::text: break;
  }
  const DeviceText& text = mark.text;
  sheet.texts.push_back({{text.anchor.x * page.width, text.anchor.y * page.height},
                         text.style.size * page.height * kCapitalsOfEm,
                         text.characters,
                         true,
                         text.turn,
                         SheetLayer::dimension});
}

/// What a reader of the sheet should know of a dimension in view k, as a part of a sentence.
std::string_view fault_of(std::span<const AnnotationMark> marks, const AnnotationPage& page,
                          const Rectangle& frame, std::size_t k,
                          const std::array<PartDrawing, 4>& views,
                          std::span<const ViewPlace> places) {
  if (marks.empty()) return "is shorter than a line is wide: left out";
  const Rectangle around = rectangle_of(points_of(marks, page));
  if (!is_within(around, frame)) return "reaches beyond the sheet's frame";
  for (std::size_t other = 0; other < views.size(); ++other) {
    const Point2 low = places[other].at;
    const Point2 high = places[other].on_paper(views[other], views[other].high);
    const Rectangle view{low.x, high.x, low.y, high.y};
    if (other != k && !are_apart(around, view, 0.0)) return "reaches over another view";
  }
  return {};
}

}  // namespace

std::vector<std::string> add_dimensions(const PartDimensions& dimensions,
                                        const std::array<PartDrawing, 4>& views,
                                        std::span<const ViewPlace> places, double margin,
                                        DrawingSheet& sheet, std::vector<PaperBox>& taken) {
  std::vector<std::string> left_out;
  std::array<DimensionsOfView, kViewsWithDimensions> of_views;
  for (const KeptAnnotation& dimension : dimensions.all) {
    std::optional<std::size_t> best;
    std::vector<Point3> points;
    double most = 0.0;
    for (std::size_t k = 0; k < kViewsWithDimensions; ++k) {
      auto in_this = points_in(views[k].kind, dimension);
      if (!in_this) continue;
      const double merit = merit_in(views[k].kind, dimension, *in_this, dimensions.axes);
      if (best && merit <= most + kParallel * std::abs(most)) continue;
      best = k;
      most = merit;
      points = std::move(*in_this);
    }
    if (!best) {
      left_out.push_back(
          fmt::format("dimension {} is parallel to no view: left out", dimension.characters));
      continue;
    }
    PageAnnotation on_paper{&dimension, height_of(dimension.style), {}};
    for (const Point3& p : points) {
      on_paper.points.push_back(places[*best].on_paper(views[*best], Point2(p)));
    }
    of_views[*best].all.push_back(std::move(on_paper));
  }
  const AnnotationPage page{static_cast<int>(std::ceil(sheet.width)),
                            static_cast<int>(std::ceil(sheet.height)), 1.0};
  const Rectangle frame{margin, sheet.width - margin, margin, sheet.height - margin};
  for (std::size_t k = 0; k < kViewsWithDimensions; ++k) {
    DimensionsOfView& of_view = of_views[k];
    for (const PartDrawing::Line& line : views[k].lines) {
      of_view.figure.add(std::array{places[k].on_paper(views[k], line.from),
                                    places[k].on_paper(views[k], line.to)});
    }
    place_annotation(of_view.all, of_view.figure, {}, page);
    for (std::size_t i = 0; i < of_view.all.size(); ++i) {
      std::vector<AnnotationMark> marks;
      AnnotationPencil(page, marks).draw(of_view.all[i], i, {});
      for (const AnnotationMark& mark : marks) {
        add_mark(mark, page, sheet);
        if (mark.kind != AnnotationMark::Kind::text) continue;
        const Rectangle box = rectangle_of(points_of({&mark, 1}, page));
        taken.push_back({{box.x_min, box.y_min}, {box.x_max, box.y_max}});
      }
      if (const std::string_view why = fault_of(marks, page, frame, k, views, places);
          !why.empty()) {
        left_out.push_back(fmt::format("dimension {} {}", of_view.all[i].kept->characters, why));
      }
    }
  }
  return left_out;
}

}  // namespace displayfile
