#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "clip/geometry/rectangle.h"
#include "programs/sheet/arrangement.h"
#include "programs/sheet/placed_view.h"

namespace displayfile {

/// Free rectangles for details, each with a circle and its caption, nearest to the place that it
/// shows. They keep clear of the views, of the title block and of each other. Nothing if one does
/// not fit.
std::optional<std::vector<PaperBox>> places_of_details(const std::array<PartDrawing, 4>& views,
                                                       std::span<const ViewPlace> places,
                                                       const SheetWords& words);

/// For each detail: a circle with a letter in its view, and the detail in its rectangle, with
/// letter and scale (ISO 128-3). `hatching` is that of each body. Returns the letters' rectangles.
std::vector<PaperBox> add_details(const std::array<PartDrawing, 4>& views,
                                  std::span<const ViewPlace> places,
                                  std::span<const PaperBox> boxes, const SheetWords& words,
                                  const std::vector<BodyHatching>& hatching, DrawingSheet& sheet);

}  // namespace displayfile
