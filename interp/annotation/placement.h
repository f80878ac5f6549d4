#pragma once

#include <optional>
#include <span>
#include <vector>

#include "clip/geometry/rectangle.h"
#include "clip/point.h"
#include "interp/annotation/annotation_marks.h"
#include "interp/annotation/page_annotation.h"

namespace displayfile {

/// The figure beside which annotation is placed, in pixels: the points of its polygons and lines,
/// and the rectangle around each of them.
struct PageFigure {
  std::vector<Point2> points;
  std::vector<Rectangle> boxes;
  void add(std::span<const Point2> item);
};

/// Where leaders' texts and balloons may stand, beside one figure of several on a page. In pixels.
struct LabelRoom {
  std::optional<Rectangle> around = std::nullopt;  ///< none: in the whole page
  std::vector<Rectangle> occupied = {};            ///< by what is neither figure nor annotation
};

/// Moves the annotation that is placed automatically (placement.md): outside of the figure; inside
/// of the picture as far as it has room; clear of other annotation; with leaders that do not cross.
/// Annotation for which there is no room stays where it was entered.
void place_annotation(std::span<PageAnnotation> all, const PageFigure& figure,
                      std::span<const PartsListRow> rows, const AnnotationPage& page,
                      const LabelRoom& room = {});

}  // namespace displayfile
