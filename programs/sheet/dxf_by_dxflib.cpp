// The module of DXF: dxflib is included here only.

#include <dxflib/dl_dxf.h>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>

#include "programs/sheet/dash_pieces.h"
#include "programs/sheet/drawing_sheet.h"
#include "programs/sheet/dxf_module.h"
#include "programs/sheet/round_outlines.h"
#include "programs/sheet/sheet_number.h"

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

/// The value of group 72 of texts: 0 left, 1 centre, 2 right.
int justification_of(TextStyle::Alignment alignment) {
  return static_cast<int>(2.0 * before_anchor(alignment));
}

std::string line_type_of(const SheetPen& pen) { return std::string(pen.dxf_line_type); }

/// Hundredths of a millimetre.
int line_weight(const SheetPen& pen) { return static_cast<int>(std::lround(pen.width * 100.0)); }

/// Numbers of as many digits as sheets have; dxflib writes 17 of each.
class SheetWriter : public DL_WriterA {
 public:
  using DL_WriterA::DL_WriterA;
  void dxfReal(int group, double value) const override { dxfString(group, sheet_number(value)); }
};

void write_tables(DL_Dxf& dxf, DL_WriterA& out, const DrawingSheet& sheet) {
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
  out.coord(10, sheet.width, sheet.height, 0.0);
  out.sectionEnd();
  out.sectionTables();
  dxf.writeVPort(out);
  out.tableLinetypes(5);
  dxf.writeLinetype(out, DL_LinetypeData("BYBLOCK", "BYBLOCK", 0, 0, 0.0));
  dxf.writeLinetype(out, DL_LinetypeData("BYLAYER", "BYLAYER", 0, 0, 0.0));
  dxf.writeLinetype(out, DL_LinetypeData("CONTINUOUS", "Continuous", 0, 0, 0.0));
  for (const SheetPen& pen : sheet_pens()) {
    if (pen.dashes.empty()) continue;
    std::vector<double> pattern;
    double length = 0.0;
    for (std::size_t k = 0; k < pen.dashes.size(); ++k) {
      pattern.push_back(k % 2 == 0 ? pen.dashes[k] : -pen.dashes[k]);
      length += pen.dashes[k];
    }
    const std::string name = line_type_of(pen);
    dxf.writeLinetype(out, DL_LinetypeData(name, name, 0, static_cast<int>(pattern.size()), length,
                                           pattern.data()));
  }
  out.tableEnd();
  out.tableLayers(static_cast<int>(sheet_pens().size()) + 1);
  constexpr int kBlackOrWhite = 7;
  dxf.writeLayer(out, DL_LayerData("0", 0),
                 DL_Attributes("", kBlackOrWhite, 25, "CONTINUOUS", 1.0));
  for (const SheetPen& pen : sheet_pens()) {
    dxf.writeLayer(out, DL_LayerData(std::string(pen.name), 0),
                   DL_Attributes("", kBlackOrWhite, line_weight(pen), line_type_of(pen), 1.0));
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

void write_arc(DL_Dxf& dxf, DL_WriterA& out, const OutlineArc& arc,
               const DL_Attributes& attributes) {
  const Point2& centre = arc.centre;
  if (arc.whole) {
    return dxf.writeCircle(out, DL_CircleData(centre.x, centre.y, 0.0, arc.radius), attributes);
  }
  dxf.writeArc(out, DL_ArcData(centre.x, centre.y, 0.0, arc.radius, arc.from, arc.to), attributes);
}

void write_entities(DL_Dxf& dxf, DL_WriterA& out, const DrawingSheet& sheet) {
  constexpr int kByLayer = 256, kWidthByLayer = -1;
  const auto on = [](SheetLayer layer, const char* line_type = "BYLAYER") {
    return DL_Attributes(std::string(pen_of(layer).name), kByLayer, kWidthByLayer, line_type, 1.0);
  };
  const auto write = [&](const OutlinePiece& piece, const DL_Attributes& attributes) {
    const std::vector<Point2>& points = piece.points;
    if (piece.arc) return write_arc(dxf, out, *piece.arc, attributes);
    if (points.size() == 2) {
      const Point2 &a = points[0], &b = points[1];
      return dxf.writeLine(out, DL_LineData(a.x, a.y, 0.0, b.x, b.y, 0.0), attributes);
    }
    const DL_PolylineData data(static_cast<int>(points.size()), 0, 0, piece.closed ? 1 : 0);
    dxf.writePolyline(out, data, attributes);
    for (const Point2& p : points) dxf.writeVertex(out, DL_VertexData(p.x, p.y, 0.0, 0.0));
    dxf.writePolylineEnd(out);
  };
  for (const auto& line : sheet.lines) {
    const std::vector<double>& dashes = pen_of(line.layer).dashes;
    for (const OutlinePiece& piece : round_pieces(line.points, line.closed)) {
      if (piece.arc || piece.points.size() == 2 || dashes.empty()) {
        write(piece, on(line.layer));
        continue;
      }
      // Programs begin the dashes of a line type anew at each vertex, and of a curve's short sides
      // nothing would be left out.
      for (const auto& dash : dash_pieces(piece.points, piece.closed, dashes)) {
        write({dash}, on(line.layer, "CONTINUOUS"));
      }
    }
  }
  for (const auto& text : sheet.texts) {
    dxf.writeText(
        out,
        DL_TextData(text.at.x, text.at.y, 0.0, text.at.x, text.at.y, 0.0, text.height, 1.0, 0,
                    justification_of(text.alignment), 0, in_ascii(text.characters), "Standard",
                    text.turn * std::numbers::pi / 180.0),
        on(text.layer));
  }
}

void write(const DrawingSheet& sheet, const std::string& path) {
  DL_Dxf dxf;
  SheetWriter out(path.c_str(), DL_Codes::AC1015);
  if (out.openFailed()) throw std::runtime_error("dxflib cannot write the DXF");
  write_tables(dxf, out, sheet);
  out.sectionEntities();
  write_entities(dxf, out, sheet);
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
