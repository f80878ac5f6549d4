#pragma once

#include <span>

#include "clip/point.h"
#include "displayfile/looks/style.h"
#include "interp/annotation/annotation_marks.h"
#include "interp/vector/pens/pen_device.h"

namespace displayfile {

/// Draws annotation by a pen as wide as its lines: areas by lines close together, texts in the
/// lettering that is set, or in the usual Hershey font where that fills areas. Blank areas hide
/// earlier drawing, unless there is no background. `picture` is its size in pixels. Throws Error if
/// the font is not installed.
void draw_annotation(std::span<const AnnotationMark> marks, const Point2& picture,
                     const Background& background, PenDevice& device);

}  // namespace displayfile
