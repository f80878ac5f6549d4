#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "clip/point.h"
#include "displayfile/looks/style.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/viewed_scene.h"

namespace displayfile {

/// The picture on which annotation is laid out.
struct AnnotationPage {
  int width, height;   ///< in pixels
  double millimetre;   ///< in pixels
  double pixel = 1.0;  ///< the unit `px`, in pixels: more with several samples across
};

/// Pixels in a millimetre of a picture without a size on paper, which is shown at 96 pixels an
/// inch.
inline constexpr double kPixelsOfMillimetre = 96.0 / 25.4;

/// One line, area or text of annotation. Points are in pixels from the picture's lower left corner,
/// y up.
struct AnnotationMark {
  enum class Kind {
    line,   ///< solid, through the points
    area,   ///< filled
    blank,  ///< filled in the background's colour; nothing if there is none
    text,   ///< in device coordinates, as other texts; its line style is that of stroke letters
  };
  Kind kind;
  std::size_t annotation;  ///< the number of the annotation to which it belongs, in order of entry
  int segment;             ///< name; 0: none
  Colour colour;
  std::vector<Point2> points = {};
  bool closed = false;  ///< of a line
  double width = 0.0;   ///< of lines, in pixels; of other marks, that of the annotation's lines
  DeviceText text = {};
};

/// The annotation of the visible segments as it is drawn, over all else and in this order, in
/// device coordinates after the image transformations. Annotation with a point more than 10,000
/// pixels outside of the picture is omitted, and a dimension that is seen end on. Nothing is
/// computed if there is no annotation; the figure's outline only if some is placed automatically.
std::vector<AnnotationMark> annotation_marks(const DisplayFile& display_file,
                                             const AnnotationPage& page);
std::vector<AnnotationMark> annotation_marks(const ViewedScene& scene, const AnnotationPage& page);

/// A sentence for each fault of the annotation on that page, which names its annotation: some that
/// is placed automatically has no room (placement.md); some reaches beyond the picture, where it is
/// cut off; a parts list has several names for a number, or several numbers for a name.
std::vector<std::string> annotation_faults(const DisplayFile& display_file,
                                           const AnnotationPage& page);
std::vector<std::string> annotation_faults(const ViewedScene& scene, const AnnotationPage& page);

}  // namespace displayfile
