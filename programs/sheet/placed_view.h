#pragma once

#include <vector>

#include "programs/sheet/drawing_sheet.h"
#include "programs/sheet/hatched_bodies.h"
#include "programs/sheet/part_drawing.h"

namespace displayfile {

/// A view's place on the paper.
struct ViewPlace {
  Point2 at;  ///< of the view's lower left corner
  double mm;  ///< of the view's unit

  Point2 on_paper(const PartDrawing& view, const Point2& p) const {
    return at + mm * (p - view.low);
  }
  std::vector<Point2> on_paper(const PartDrawing& view, const std::vector<Point2>& points) const;
};

/// Adds a view's lines, hatching and centre lines to a sheet. `hatching` is that of each body.
void add_view(const PartDrawing& view, const ViewPlace& place,
              const std::vector<BodyHatching>& hatching, DrawingSheet& sheet);

/// Removes centre lines that lie along a cutting line, which takes precedence (ISO 128-2).
void remove_covered_centre_lines(DrawingSheet& sheet);

}  // namespace displayfile
