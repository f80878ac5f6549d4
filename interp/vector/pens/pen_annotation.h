#pragma once

#include <span>

#include "clip/point.h"
#include "interp/annotation/annotation_marks.h"
#include "interp/vector/pens/pen_device.h"

namespace displayfile {

/// Draws annotation by a pen as wide as its lines: areas by lines close together, texts in the
/// lettering that is set, or stroke letters where that fills areas. Blank areas, which hide the
/// figure, are not drawn. `picture` is its size in pixels.
void draw_annotation(std::span<const AnnotationMark> marks, const Point2& picture,
                     PenDevice& device);

}  // namespace displayfile
