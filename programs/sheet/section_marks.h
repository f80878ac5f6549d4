#pragma once

#include <array>
#include <span>
#include <vector>

#include "programs/sheet/arrangement.h"

namespace displayfile {

/// A view on the paper, and the rectangle that the whole part takes there.
struct PlacedDrawing {
  const PartDrawing* view;
  Point2 low, high;
};

/// The rectangles of cutting lines beyond the views, with arrows and letters, where nothing else is
/// in their way.
std::vector<PaperBox> usual_places_of_section_marks(const std::array<PlacedDrawing, 4>& views,
                                                    double mm_of_unit);

/// For each view that is cut: in another view a line where, with arrows and letters, and the
/// letters at the view itself. They keep clear of the views, of the rectangles that are taken
/// (details, numbers of dimensions), of the title block and of each other.
void add_section_marks(const std::array<PlacedDrawing, 4>& views,
                       std::span<const PaperBox> occupied, const SheetWords& words,
                       double mm_of_unit, DrawingSheet& sheet);

}  // namespace displayfile
