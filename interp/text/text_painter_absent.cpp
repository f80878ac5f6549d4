// A build without Cairo: there are no texts in pixels, and no outlines of letters.

#include "clip/base/error.h"
#include "interp/text/letter_paths.h"
#include "interp/text/text_painter.h"

namespace displayfile {

void paint_texts(std::span<const DeviceText> texts, const DrawnLetters&, const PictureSize&, int,
                 int, Picture&) {
  if (texts.empty()) return;
  throw Error(
      "texts in pixels are drawn by Cairo, which this build was made without: expected a drawing "
      "without texts, or an .svg file");
}

void paint_annotation(std::span<const AnnotationMark> marks, const Background&, const DrawnLetters&,
                      const PictureSize&, int, int, Picture&) {
  if (marks.empty()) return;
  throw Error(
      "annotations in pixels are drawn by Cairo, which this build was made without: expected a "
      "drawing without annotations, or an .svg file");
}

std::vector<LetterPaths::Letter> letter_outlines(const std::string&, const DeviceText&,
                                                 const Point2&, double) {
  throw Error(
      "outlines of texts are found by Cairo, which this build was made without: expected texts as "
      "texts, or font hershey");
}

std::string font_in_place_of(const std::string&) { return {}; }

}  // namespace displayfile
