#include <fmt/format.h>
#include <fmt/ostream.h>

#include <ostream>
#include <string>
#include <string_view>
#include <utility>

#include "clip/base/collected_text.h"
#include "displayfile/text/output_file.h"
#include "interp/vector/escaped_xml.h"
#include "interp/vector/file_key.h"
#include "interp/vector/sheet_number.h"
#include "programs/sheet/drawing_sheet.h"

namespace displayfile {

namespace {

std::string escaped_text(const std::string& text) {
  std::string out;
  append_escaped(out, text);
  return out;
}

std::string path_of(const DrawingSheet& sheet, const DrawingSheet::Line& line) {
  std::string path;
  for (const Point2& p : line.points) {
    path += fmt::format("{}{} {}", path.empty() ? "M" : "L", sheet_number(p.x),
                        sheet_number(sheet.height - p.y));
  }
  return path + (line.closed ? "Z" : "");
}

std::string_view anchor_of(TextStyle::Alignment alignment) {
  switch (alignment) {
    case TextStyle::Alignment::centre: return " text-anchor=\"middle\"";
    case TextStyle::Alignment::right: return " text-anchor=\"end\"";
    case TextStyle::Alignment::left: break;
  }
  return "";
}

void write_layer(const DrawingSheet& sheet, SheetLayer layer, std::ostream& out) {
  const SheetPen& pen = pen_of(layer);
  std::string path;
  for (const auto& line : sheet.lines) {
    if (line.layer == layer) path += path_of(sheet, line);
  }
  if (path.empty()) return;
  const std::string dashes =
      pen.dashes.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", fmt::join(pen.dashes, " "));
  fmt::print(out, "<path id=\"{}{}\" stroke-width=\"{}\"{} d=\"{}\"/>\n", pen.name, kOwn, pen.width,
             dashes, path);
}

}  // namespace

void write_sheet_svg(const DrawingSheet& sheet, const std::string& file) {
  OutputFile output(file);
  CollectedText out;  // whose names end in kOwn
  fmt::print(out,
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" "
             "viewBox=\"0 0 {0} {1}\">\n<title>{2}</title>\n"
             "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
             "<g fill=\"none\" stroke=\"#000\" stroke-linecap=\"round\" "
             "stroke-linejoin=\"round\">\n",
             sheet.width, sheet.height, escaped_text(sheet.title));
  for (const SheetLayer layer : kLayersFromBelow) {
    write_layer(sheet, layer, out);
  }
  fmt::print(out, "</g>\n<g font-family=\"{}\">\n", css_font(sheet.font));
  for (const auto& text : sheet.texts) {
    const double x = text.at.x, y = sheet.height - text.at.y;
    fmt::print(out, "<text x=\"{:.6g}\" y=\"{:.6g}\" font-size=\"{:.4g}\"{}{}>{}</text>\n", x, y,
               text.height / kCapitalsOfFont, anchor_of(text.alignment),
               text.turn == 0.0
                   ? ""
                   : fmt::format(" transform=\"rotate({:.6g} {:.6g} {:.6g})\"", -text.turn, x, y),
               escaped_text(text.characters));
  }
  out << "</g>\n</svg>\n";
  const std::string document = std::move(out).str();
  write_with_key(document, file_key({document}), output.stream());
  output.commit();
}

}  // namespace displayfile
