#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "clip/rectangle.h"
#include "displayfile/entered/kept_annotation.h"
#include "programs/sheet/drawing_sheet.h"
#include "programs/sheet/part_drawing.h"
#include "programs/sheet/placed_view.h"
#include "programs/sheet/turned_shape.h"

namespace displayfile {

/// Dimensions of drawing programs, and the axes of the part's round shapes, in the coordinates of a
/// part (part.h).
struct PartDimensions {
  std::vector<KeptAnnotation> all{};  ///< linear, diameter, radius and angle
  std::vector<CentreAxis> axes{};
};

/// Draws each dimension in one of the first three views to which it is parallel, so that it shows
/// the length that it measures: of several in the one where its dimension line is farthest from
/// what it measures, or that shows the circle, otherwise in the first. Those with automatic
/// placement stand outside of that view. Adds the rectangles of their texts to `taken`. Returns a
/// sentence on each dimension that is parallel to
/// no view, and is left out, or reaches beyond the frame.
std::vector<std::string> add_dimensions(const PartDimensions& dimensions,
                                        const std::array<PartDrawing, 4>& views,
                                        std::span<const ViewPlace> places, double margin,
                                        DrawingSheet& sheet, std::vector<PaperBox>& taken);

}  // namespace displayfile
