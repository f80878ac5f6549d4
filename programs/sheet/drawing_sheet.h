#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "clip/point.h"
#include "displayfile/looks/style.h"

namespace displayfile {

/// The purposes of a sheet's lines, one layer each. Widths and dashes are in millimetres.
enum class SheetLayer {
  visible,
  hidden,
  hatch,
  centre,
  cutting,
  cutting_ends,
  detail,
  frame,
  text,
  dimension,
  leader
};
struct SheetPen {
  std::string_view name;
  double width;
  std::vector<double> dashes{};  ///< drawn, left out, and so on; empty: solid
  /// LibreCAD has patterns of its own and selects them by these names: the one nearest to the
  /// pen's.
  std::string_view dxf_line_type = "CONTINUOUS";
};
inline const std::array<SheetPen, 11>& sheet_pens() {
  static const std::array<SheetPen, 11> pens{{{"VISIBLE", 0.5},
                                              {"HIDDEN", 0.25, {3.0, 1.0}, "DASHEDTINY"},
                                              {"HATCH", 0.13},
                                              {"CENTRE", 0.25, {8.0, 1.0, 1.0, 1.0}, "CENTER2"},
                                              {"CUTTING", 0.25, {8.0, 1.5, 1.0, 1.5}, "DASHDOT2"},
                                              {"CUTTING_ENDS", 0.5},
                                              {"DETAIL", 0.25},
                                              {"FRAME", 0.5},
                                              {"TEXT", 0.25},
                                              {"DIMENSION", 0.25},
                                              {"LEADER", 0.25}}};
  return pens;
}
/// In the order of drawing.
inline constexpr std::array kLayersFromBelow{
    SheetLayer::hatch,  SheetLayer::hidden,       SheetLayer::centre,  SheetLayer::cutting,
    SheetLayer::detail, SheetLayer::cutting_ends, SheetLayer::visible, SheetLayer::dimension,
    SheetLayer::leader, SheetLayer::frame,        SheetLayer::text};
inline const SheetPen& pen_of(SheetLayer layer) {
  return sheet_pens()[static_cast<std::size_t>(layer)];
}

/// A drawing on paper. Millimetres from the lower left corner, y up.
struct DrawingSheet {
  struct Line {
    SheetLayer layer;
    std::vector<Point2> points;
    bool closed = false;
  };
  struct Text {
    Point2
        at;  ///< on its baseline: the beginning, the middle or the end, depending on its alignment
    double height;  ///< of capital letters
    std::string characters;
    TextStyle::Alignment alignment = TextStyle::Alignment::left;
    double turn = 0.0;  ///< counterclockwise about `at`, degrees
    SheetLayer layer = SheetLayer::text;
  };
  double width = 0.0, height = 0.0;
  std::string title;
  std::vector<Line> lines;
  std::vector<Text> texts;
  std::string font = "sans-serif";         ///< of texts, or hershey, as in Lettering
  std::vector<std::string> shortened;      ///< the title block's fields that do not fit
  std::vector<std::string> not_as_wanted;  ///< sentences on annotation that it does not show
};
/// How much of a text stands before its point, in parts of its width.
inline double before_anchor(TextStyle::Alignment alignment) {
  return alignment == TextStyle::Alignment::left     ? 0.0
         : alignment == TextStyle::Alignment::centre ? 0.5
                                                     : 1.0;
}
/// The height of capital letters, in parts of the font's size.
inline constexpr double kCapitalsOfFont = 0.72;

/// Writes a sheet in the format that the file's name ends in: .svg, .pdf or .dxf; whole or not at
/// all. Throws Error if it cannot.
void write_sheet(const DrawingSheet& sheet, const std::string& file);
/// Throws Error for another extension, for one whose library this build lacks, for an unknown font,
/// and for DXF, whose texts are in the reader's font, if the font is not hershey.
void require_sheet_file(const std::string& file, const std::string& font);

void write_sheet_svg(const DrawingSheet& sheet, const std::string& file);
void write_sheet_pdf(const DrawingSheet& sheet, const std::string& file);
void write_sheet_dxf(const DrawingSheet& sheet, const std::string& file);

}  // namespace displayfile
