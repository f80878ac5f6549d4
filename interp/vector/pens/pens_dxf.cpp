#include <cstdint>
#include <utility>

#include "interp/vector/dxf/dxf_drawing.h"
#include "interp/vector/pens/pen_files.h"

namespace displayfile {

namespace {

/// Strokes are in thousandths of a millimetre, y down.
Point2 in_dxf(const SheetPoint& point, double height) {
  constexpr double kUnits = 1000.0;
  return {static_cast<double>(point.x) / kUnits, height - static_cast<double>(point.y) / kUnits};
}

DxfDrawing dxf_of(const PenDrawing& pens) {
  DxfDrawing drawing;
  drawing.width = pens.fit.width;
  drawing.height = pens.fit.height;
  for (const PenLayer& layer : pens.layers) {
    const auto number = static_cast<std::uint32_t>(drawing.layers.size());
    const std::uint32_t c = layer.pen.colour,
                        rgb = (c & 0xff) << 16 | (c & 0xff00) | (c >> 16 & 0xff);
    drawing.layers.push_back({name_of_layer(number + 1, layer),
                              static_cast<double>(layer.pen.width) / 1000.0, "CONTINUOUS",
                              rgb == 0 ? std::nullopt : std::optional(rgb)});
    for (const PenPath& path : layer.paths) {
      DxfDrawing::Piece piece{number, {}, path.closed};
      piece.points.reserve(path.points.size());
      for (const SheetPoint& p : path.points) {
        piece.points.push_back(in_dxf(p, drawing.height));
      }
      drawing.pieces.push_back(std::move(piece));
    }
  }
  return drawing;
}

}  // namespace

void write_pens_dxf(const PenDrawing& drawing, const Destination& to, const VectorOptions&) {
  write_dxf(dxf_of(drawing), to);
}

}  // namespace displayfile
