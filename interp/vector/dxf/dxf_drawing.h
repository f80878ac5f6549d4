#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clip/point.h"
#include "displayfile/files.h"
#include "displayfile/looks/style.h"

namespace displayfile {

/// A drawing as DXF files have it. Millimetres from the lower left corner, y up.
struct DxfDrawing {
  /// Millimetres drawn and left out alternately.
  struct LineType {
    std::string name;
    std::vector<double> dashes;
  };
  struct Layer {
    std::string name;
    double width = 0.0;                    ///< of its lines, millimetres
    std::string line_type = "CONTINUOUS";  ///< that, or one of `line_types`
    /// 0xrrggbb. Nothing: black on a white ground, white on a black one.
    std::optional<std::uint32_t> colour;
  };
  /// A circle, or the part of one from an angle counterclockwise to another, in degrees.
  struct Arc {
    Point2 centre;
    double radius;
    double from = 0.0, to = 360.0;
    bool whole = true;
  };
  /// A polyline, a line if it has two points, a point if it has one; or an arc.
  struct Piece {
    std::uint32_t layer;  ///< index in `layers`
    std::vector<Point2> points;
    bool closed = false;
    bool solid = false;  ///< whatever the layer's line type
    std::optional<Arc> arc{};
  };
  struct Text {
    std::uint32_t layer;
    Point2 at;      ///< on its baseline: the beginning, the middle or the end, as it is aligned
    double height;  ///< of capital letters
    std::string characters;
    TextStyle::Alignment alignment = TextStyle::Alignment::left;
    double turn = 0.0;  ///< counterclockwise about `at`, degrees
  };
  double width = 0.0, height = 0.0;
  std::vector<LineType> line_types;
  std::vector<Layer> layers;
  std::vector<Piece> pieces;
  std::vector<Text> texts;
};

/// Writes a drawing as DXF of AutoCAD 2000, whole or not at all. Throws Error, naming the
/// destination, if it cannot, as without dxflib or the module that uses it.
void write_dxf(const DxfDrawing& drawing, const Destination& to);
extern const bool kWritesDxf;  ///< dxflib was found when this was built

}  // namespace displayfile
