#pragma once

#include <array>
#include <string>
#include <vector>

#include "programs/sheet/drawing_scale.h"
#include "programs/sheet/drawing_sheet.h"
#include "programs/sheet/part_drawing.h"

namespace displayfile {

enum class SheetProjection { third, first };

/// What a sheet says of itself, and how it is arranged. Lengths in millimetres.
struct SheetWords {
  std::string title, date;
  SheetProjection projection = SheetProjection::third;
  double width = 420.0, height = 297.0, margin = 10.0;
  double hatch = 2.0;  ///< between hatching lines
  double unit = 1.0;   ///< of the part's
};

/// The views of a sheet, in order: front, top, side, isometric.
std::array<ViewKind, 4> views_of_sheet(SheetProjection projection);

/// The largest standard scale in which the views fit, or the requested one (null: none). Throws
/// Error if they do not fit.
DrawingScale scale_of_sheet(const std::array<PartDrawing, 4>& views, const SheetWords& words,
                            const DrawingScale* asked);

/// The sheet of four views: the same point of the part stands above, below or beside itself.
DrawingSheet arrange(const std::array<PartDrawing, 4>& views, const SheetWords& words,
                     const DrawingScale& scale);

/// Frame, title block and the symbol of the projection.
void add_title_block(const SheetWords& words, const DrawingScale& scale, DrawingSheet& sheet);
inline constexpr double kTitleHeight = 20.0, kTitleWidth = 150.0;

}  // namespace displayfile
