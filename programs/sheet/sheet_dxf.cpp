#include <algorithm>
#include <string>
#include <vector>

#include "interp/vector/dxf/dxf_drawing.h"
#include "programs/sheet/dash_pieces.h"
#include "programs/sheet/drawing_sheet.h"
#include "programs/sheet/round_outlines.h"

namespace displayfile {

namespace {

std::uint32_t index_of(SheetLayer layer) { return static_cast<std::uint32_t>(layer); }

/// Programs begin the dashes of a line type anew at each vertex, and of a curve's short sides
/// nothing would be left out: dashed polylines are divided here.
void add_line(const DrawingSheet::Line& line, std::vector<DxfDrawing::Piece>& pieces) {
  const std::vector<double>& dashes = pen_of(line.layer).dashes;
  const std::uint32_t layer = index_of(line.layer);
  for (const OutlinePiece& piece : round_pieces(line.points, line.closed)) {
    if (piece.arc) {
      pieces.push_back({layer, {}, false, false, piece.arc});
    } else if (piece.points.size() == 2 || dashes.empty()) {
      pieces.push_back({layer, piece.points, piece.closed});
    } else {
      for (auto& dash : dash_pieces(piece.points, piece.closed, dashes)) {
        pieces.push_back({layer, dash, false, true});
      }
    }
  }
}

DxfDrawing dxf_of(const DrawingSheet& sheet) {
  DxfDrawing drawing;
  drawing.width = sheet.width;
  drawing.height = sheet.height;
  for (const SheetPen& pen : sheet_pens()) {
    const std::string line_type(pen.dxf_line_type);
    if (!pen.dashes.empty()) drawing.line_types.push_back({line_type, pen.dashes});
    drawing.layers.push_back({std::string(pen.name), pen.width, line_type, {}});
  }
  for (const DrawingSheet::Line& line : sheet.lines) add_line(line, drawing.pieces);
  drawing.texts.reserve(sheet.texts.size());
  for (const DrawingSheet::Text& text : sheet.texts) {
    drawing.texts.push_back(
        {index_of(text.layer), text.at, text.height, text.characters, text.alignment, text.turn});
  }
  return drawing;
}

}  // namespace

void write_sheet_dxf(const DrawingSheet& sheet, const std::string& file) {
  write_dxf(dxf_of(sheet), Destination(file));
}

}  // namespace displayfile
