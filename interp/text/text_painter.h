#pragma once

#include <span>

#include "displayfile/segments/viewed_scene.h"
#include "hidden/exact/pixel_centre.h"
#include "interp/annotation/annotation_marks.h"
#include "interp/device/picture.h"
#include "interp/device/raster_request.h"

namespace displayfile {

/// How letters are drawn: widths of strokes are multiplied by line_scale.
struct DrawnLetters {
  const Lettering& lettering;
  double line_scale = 1.0;
};

/// Paints texts, in order, over rows first_row <= j < end_row of a picture of that size, the only
/// rows in memory. Letters are antialiased, by Cairo; no other pixel changes, nor do identifiers
/// and depths. The pixels do not depend on which rows are in memory. Throws Error if there is a
/// text and this system has no Cairo, which is loaded only if there is one.
void paint_texts(std::span<const DeviceText> texts, const DrawnLetters& letters,
                 const PictureSize& size, int first_row, int end_row, Picture& rows);

/// The picture in which annotation is laid out, in its samples.
inline AnnotationPage annotation_page(const RasterRequest& request) {
  const double millimetre = request.dpi ? *request.dpi / kMillimetresOfInch : kPixelsOfMillimetre;
  return {request.width, request.height, millimetre * request.line_scale, request.line_scale};
}

/// The same for annotation; `background` is the picture's.
void paint_annotation(std::span<const AnnotationMark> marks, const Background& background,
                      const DrawnLetters& letters, const PictureSize& size, int first_row,
                      int end_row, Picture& rows);

}  // namespace displayfile
