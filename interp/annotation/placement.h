#pragma once

#include <span>
#include <vector>

#include "clip/point.h"
#include "interp/annotation/annotation_marks.h"
#include "interp/annotation/page_annotation.h"

namespace displayfile {

/// Moves the annotation that is placed automatically (placement.md): outside of the figure, whose
/// points these are, in pixels; inside of the picture as far as it has room; clear of other
/// annotation; with leaders that do not cross. Annotation for which there is no room stays where it
/// was entered.
void place_annotation(std::span<PageAnnotation> all, std::span<const Point2> figure,
                      std::span<const PartsListRow> rows, const AnnotationPage& page);

}  // namespace displayfile
