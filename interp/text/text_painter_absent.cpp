// A build without Cairo: there are no texts in pixels.

#include "clip/base/error.h"
#include "interp/text/text_painter.h"

namespace displayfile {

void paint_texts(std::span<const DeviceText> texts, const PictureSize&, int, int, Picture&) {
  if (texts.empty()) return;
  throw Error(
      "texts in pixels are drawn by Cairo, which this build was made without: expected a drawing "
      "without texts, or an .svg file");
}

void paint_annotation(std::span<const AnnotationMark> marks, const Background&, const PictureSize&,
                      int, int, Picture&) {
  if (marks.empty()) return;
  throw Error(
      "annotation in pixels is drawn by Cairo, which this build was made without: expected a "
      "drawing without annotation, or an .svg file");
}

}  // namespace displayfile
