#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "clip/geometry/rectangle.h"
#include "displayfile/entered/kept_annotation.h"
#include "programs/sheet/drawing_sheet.h"
#include "programs/sheet/part_drawing.h"
#include "programs/sheet/placed_view.h"
#include "programs/sheet/turned_shape.h"

namespace displayfile {

/// Annotation of drawing programs, and the axes of the part's round shapes, in the coordinates of a
/// part (part.h).
struct PartAnnotation {
  std::vector<KeptAnnotation> all{};  ///< dimensions, leaders and balloons
  /// For each: the index of the view that shows the point of a leader or a balloon.
  std::vector<std::size_t> shown_in{};
  std::vector<CentreAxis> axes{};
};

/// True for leaders and balloons.
bool is_label(const KeptAnnotation& annotation);

/// The room beside a view, in mm, that automatically placed leaders and balloons need; 0: there are
/// none.
double gap_for_labels(const PartAnnotation& annotation);

/// Draws leaders and balloons in their views, and each dimension in one of the first three views to
/// which it is parallel, so that it shows its true length: of several such views, in the one where
/// its dimension line is farthest from the measured points, or that shows the circle, otherwise in
/// the first. Those with automatic placement stand outside of that view; leaders and balloons also
/// clear of the rectangles `taken` and `reserved`. Balloons cover earlier contents. Adds the
/// rectangles of texts and balloons to `taken`. Returns a sentence on each dimension that is
/// parallel to no view, and is left out, and on each annotation that does not fit, or reaches
/// beyond the frame or over another view.
std::vector<std::string> add_annotation(const PartAnnotation& annotation,
                                        const std::array<PartDrawing, 4>& views,
                                        std::span<const ViewPlace> places,
                                        std::span<const PaperBox> reserved, double margin,
                                        DrawingSheet& sheet, std::vector<PaperBox>& taken);

}  // namespace displayfile
