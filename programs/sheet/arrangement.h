#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "clip/geometry/rectangle.h"
#include "interp/annotation/page_annotation.h"
#include "programs/sheet/drawing_scale.h"
#include "programs/sheet/drawing_sheet.h"
#include "programs/sheet/part_drawing.h"
#include "programs/sheet/sheet_annotation.h"

namespace displayfile {

enum class SheetProjection { third, first };

/// Part of a view at another scale: the inside of a circle.
struct DetailWanted {
  std::size_t view = 0;  ///< index of a view of the sheet
  Point2 middle{0.0};    ///< in the view's coordinates and unit
  double radius = 1.0;   ///< in the view's unit
  DrawingScale scale{};
};
/// The letters of details, in order: others than those of sections.
inline constexpr std::string_view kDetailLetters = "XYZWVUTSRQPNMLKHGFED";

/// The texts and the arrangement of a sheet. Lengths in millimetres.
struct SheetWords {
  std::string title, date;
  SheetProjection projection = SheetProjection::third;
  double width = 420.0, height = 297.0, margin = 10.0;
  double hatch = 2.0;  ///< between hatching lines
  double unit = 1.0;   ///< of the part's
  std::vector<DetailWanted> details{};
  std::vector<PartsListRow> parts{};  ///< of the parts list; empty: none
  double least_gap = 12.0;            ///< between views, and to the frame
};

/// The views of a sheet, in order: front, top, side, isometric.
std::array<ViewKind, 4> views_of_sheet(SheetProjection projection);

/// The largest standard scale in which the views fit and leave room for details, or the requested
/// one (null: none). Throws Error if they do not fit.
DrawingScale scale_of_sheet(const std::array<PartDrawing, 4>& views, const SheetWords& words,
                            const DrawingScale* asked);

/// The sheet of four views, with the part's annotation: the same point of the part stands above,
/// below or beside itself.
DrawingSheet arrange(const std::array<PartDrawing, 4>& views, const PartAnnotation& annotation,
                     const SheetWords& words, const DrawingScale& scale);

/// Frame, title block and the symbol of the projection; above the title block the parts list.
void add_title_block(const SheetWords& words, const DrawingScale& scale, DrawingSheet& sheet);
inline constexpr double kTitleHeight = 20.0, kTitleWidth = 150.0;
/// The rectangle of title block and parts list, in the frame's lower right corner.
PaperBox block_of_titles(const SheetWords& words);

}  // namespace displayfile
