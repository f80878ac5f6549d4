// The module of DXF: dxflib is included here only.

#include <dxflib/dl_dxf.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "interp/vector/dxf/dxf_drawing.h"
#include "interp/vector/dxf/dxf_module.h"
#include "interp/vector/sheet_number.h"

namespace displayfile {

namespace {

/// `\U+` and four hexadecimal digits, as AutoCAD's files have characters: UTF-16, two of them
/// beyond U+FFFF.
void append_code(std::string& out, unsigned code) {
  constexpr unsigned kFirstOfTwo = 0x10000;
  if (code < kFirstOfTwo) {
    out += fmt::format("\\U+{:04X}", code);
  } else {
    const unsigned above = code - kFirstOfTwo;
    out += fmt::format("\\U+{:04X}\\U+{:04X}", 0xD800 + (above >> 10), 0xDC00 + (above & 0x3FF));
  }
}

/// Escapes texts that a file would interpret: `%%` begins the name of a character, of which `%%%`
/// is a percent sign, and `\U+` a character's number.
std::string in_ascii(const std::string& utf8) {
  std::string out;
  for (std::size_t i = 0; i < utf8.size();) {
    const std::string_view rest = std::string_view(utf8).substr(i);
    if (rest.starts_with("%%")) {
      for (; i < utf8.size() && utf8[i] == '%'; ++i) out += "%%%";
      continue;
    }
    const auto byte = static_cast<unsigned char>(utf8[i++]);
    if (rest.starts_with("\\U+")) {
      append_code(out, byte);
      continue;
    }
    if (byte < 0x80) {
      out += byte < 0x20 ? ' ' : static_cast<char>(byte);
      continue;
    }
    const int more = byte >= 0xF0 ? 3 : byte >= 0xE0 ? 2 : 1;
    unsigned code = byte & (0x3Fu >> more);
    for (int k = 0; k < more && i < utf8.size(); ++k) {
      code = (code << 6) | (static_cast<unsigned char>(utf8[i++]) & 0x3Fu);
    }
    append_code(out, code);
  }
  return out;
}

/// The value of group 72 of texts.
int justification_of(TextStyle::Alignment alignment) {
  if (alignment == TextStyle::Alignment::left) return 0;
  return alignment == TextStyle::Alignment::centre ? 1 : 2;
}

/// The nearest of the widths that the format has, in hundredths of a millimetre.
int line_weight(double width) {
  constexpr std::array kWeights{0,  5,  9,  13, 15, 18,  20,  25,  30,  35,  40,  50,
                                53, 60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211};
  const auto off = [&](int weight) { return std::abs(width * 100.0 - weight); };
  return *std::ranges::min_element(kWeights, {}, off);
}

/// The colours that all programs draw alike, by their numbers from 1 on; 7 is black on a white
/// ground, white on a black one.
constexpr std::array<std::uint32_t, 9> kIndexed{0xff0000, 0xffff00, 0x00ff00, 0x00ffff, 0x0000ff,
                                                0xff00ff, 0x000000, 0x808080, 0xc0c0c0};
constexpr int kBlackOrWhite = 7;

/// The number of the nearest colour, for programs that read no others.
int colour_number(std::uint32_t colour) {
  const auto off = [&](std::uint32_t other) {
    int sum = 0;
    for (const int shift : {0, 8, 16}) {
      const int difference =
          static_cast<int>(colour >> shift & 0xff) - static_cast<int>(other >> shift & 0xff);
      sum += difference * difference;
    }
    return sum;
  };
  return static_cast<int>(std::ranges::min_element(kIndexed, {}, off) - kIndexed.begin()) + 1;
}

DL_Attributes attributes_of(const DxfDrawing::Layer& layer) {
  const int weight = line_weight(layer.width);
  if (!layer.colour) return {"", kBlackOrWhite, weight, layer.line_type, 1.0};
  return {"", colour_number(*layer.colour), static_cast<int>(*layer.colour), weight,
          layer.line_type};
}

/// Numbers of as many digits as sheets have; dxflib writes 17 of each.
class SheetWriter : public DL_WriterA {
 public:
  using DL_WriterA::DL_WriterA;
  void dxfReal(int group, double value) const override { dxfString(group, sheet_number(value)); }
};

void write_tables(DL_Dxf& dxf, DL_WriterA& out, const DxfDrawing& drawing) {
  dxf.writeHeader(out);
  const auto variable = [&](const char* name) { out.dxfString(9, name); };
  variable("$INSUNITS");
  out.dxfInt(70, 4);
  variable("$MEASUREMENT");
  out.dxfInt(70, 1);
  variable("$LWDISPLAY");
  out.dxfInt(290, 1);
  variable("$EXTMIN");
  out.coord(10, 0.0, 0.0, 0.0);
  variable("$EXTMAX");
  out.coord(10, drawing.width, drawing.height, 0.0);
  out.sectionEnd();
  out.sectionTables();
  dxf.writeVPort(out);
  out.tableLinetypes(5);
  dxf.writeLinetype(out, DL_LinetypeData("BYBLOCK", "BYBLOCK", 0, 0, 0.0));
  dxf.writeLinetype(out, DL_LinetypeData("BYLAYER", "BYLAYER", 0, 0, 0.0));
  dxf.writeLinetype(out, DL_LinetypeData("CONTINUOUS", "Continuous", 0, 0, 0.0));
  for (const auto& [name, dashes] : drawing.line_types) {
    std::vector<double> pattern = dashes;
    for (std::size_t k = 1; k < pattern.size(); k += 2) pattern[k] = -pattern[k];
    const double length = std::accumulate(dashes.begin(), dashes.end(), 0.0);
    dxf.writeLinetype(out, DL_LinetypeData(name, name, 0, static_cast<int>(pattern.size()), length,
                                           pattern.data()));
  }
  out.tableEnd();
  out.tableLayers(static_cast<int>(drawing.layers.size()) + 1);
  dxf.writeLayer(out, DL_LayerData("0", 0),
                 DL_Attributes("", kBlackOrWhite, 25, "CONTINUOUS", 1.0));
  for (const DxfDrawing::Layer& layer : drawing.layers) {
    dxf.writeLayer(out, DL_LayerData(layer.name, 0), attributes_of(layer));
  }
  out.tableEnd();
  out.tableStyle(1);
  DL_StyleData style("Standard", 0, 0.0, 1.0, 0.0, 0, 2.5, "txt", "");
  style.bold = style.italic = false;
  dxf.writeStyle(out, style);
  out.tableEnd();
  dxf.writeView(out);
  dxf.writeUcs(out);
  out.tableAppid(1);
  dxf.writeAppid(out, "ACAD");
  out.tableEnd();
  dxf.writeDimStyle(out, 1.0, 1.0, 1.0, 1.0, 1.0);
  dxf.writeBlockRecord(out);
  out.tableEnd();
  out.sectionEnd();
  out.sectionBlocks();
  for (const char* block : {"*Model_Space", "*Paper_Space", "*Paper_Space0"}) {
    dxf.writeBlock(out, DL_BlockData(block, 0, 0.0, 0.0, 0.0));
    dxf.writeEndBlock(out, block);
  }
  out.sectionEnd();
}

void write_arc(DL_Dxf& dxf, DL_WriterA& out, const DxfDrawing::Arc& arc,
               const DL_Attributes& attributes) {
  const Point2& centre = arc.centre;
  if (arc.whole) {
    return dxf.writeCircle(out, DL_CircleData(centre.x, centre.y, 0.0, arc.radius), attributes);
  }
  dxf.writeArc(out, DL_ArcData(centre.x, centre.y, 0.0, arc.radius, arc.from, arc.to), attributes);
}

void write_piece(DL_Dxf& dxf, DL_WriterA& out, const DxfDrawing::Piece& piece,
                 const DL_Attributes& attributes) {
  const std::vector<Point2>& points = piece.points;
  if (piece.arc) return write_arc(dxf, out, *piece.arc, attributes);
  const Point2& a = points.front();
  if (points.size() == 1) return dxf.writePoint(out, DL_PointData(a.x, a.y, 0.0), attributes);
  if (points.size() == 2) {
    const Point2& b = points.back();
    return dxf.writeLine(out, DL_LineData(a.x, a.y, 0.0, b.x, b.y, 0.0), attributes);
  }
  const DL_PolylineData data(static_cast<int>(points.size()), 0, 0, piece.closed ? 1 : 0);
  dxf.writePolyline(out, data, attributes);
  for (const Point2& p : points) dxf.writeVertex(out, DL_VertexData(p.x, p.y, 0.0, 0.0));
  dxf.writePolylineEnd(out);
}

void write_entities(DL_Dxf& dxf, DL_WriterA& out, const DxfDrawing& drawing) {
  constexpr int kByLayer = 256, kWidthByLayer = -1;
  const auto on = [&](std::uint32_t layer, const char* line_type = "BYLAYER") {
    return DL_Attributes(drawing.layers[layer].name, kByLayer, kWidthByLayer, line_type, 1.0);
  };
  for (const DxfDrawing::Piece& piece : drawing.pieces) {
    write_piece(dxf, out, piece, on(piece.layer, piece.solid ? "CONTINUOUS" : "BYLAYER"));
  }
  for (const DxfDrawing::Text& text : drawing.texts) {
    dxf.writeText(
        out,
        DL_TextData(text.at.x, text.at.y, 0.0, text.at.x, text.at.y, 0.0, text.height, 1.0, 0,
                    justification_of(text.alignment), 0, in_ascii(text.characters), "Standard",
                    text.turn * std::numbers::pi / 180.0),
        on(text.layer));
  }
}

void write(const DxfDrawing& drawing, const std::string& path) {
  DL_Dxf dxf;
  SheetWriter out(path.c_str(), DL_Codes::AC1015);
  if (out.openFailed()) throw std::runtime_error("dxflib cannot write the DXF");
  write_tables(dxf, out, drawing);
  out.sectionEntities();
  write_entities(dxf, out, drawing);
  out.sectionEnd();
  dxf.writeObjects(out);
  dxf.writeObjectsEnd(out);
  out.dxfEOF();
  out.close();
  if (out.openFailed()) throw std::runtime_error("dxflib cannot write the DXF");
}

}  // namespace

}  // namespace displayfile

extern "C" __attribute__((visibility("default"))) const void* displayfile_module() {
  using namespace displayfile;
  static constexpr DxfModule kModule{DISPLAYFILE_MODULE_VERSION, write};
  return &kModule;
}
