#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <ostream>
#include <string>

#include "displayfile/text/output.h"
#include "interp/vector/escaped_xml.h"
#include "interp/vector/file_key.h"
#include "interp/vector/pens/pen_files.h"

namespace displayfile {

namespace {

void append_millimetres(std::string& out, std::int64_t units) {
  if (units < 0) out.push_back('-');
  const std::int64_t size = units < 0 ? -units : units;
  fmt::format_to(std::back_inserter(out), "{}", size / 1000);
  if (size % 1000 == 0) return;
  fmt::format_to(std::back_inserter(out), ".{:03}", size % 1000);
  while (out.back() == '0') out.pop_back();
}

void append_pair(std::string& out, std::int64_t x, std::int64_t y) {
  append_millimetres(out, x);
  if (y >= 0) out.push_back(' ');
  append_millimetres(out, y);
}

/// Writes the differences between points: the numbers are short, and their sums exact.
void append_path_data(std::string& out, const PenPath& path) {
  SheetPoint pen{0, 0};
  char command = 'M';
  for (const SheetPoint& p : path.points) {
    if (command != ' ') out.push_back(command);
    const std::int64_t dx = p.x - pen.x;
    if (command == ' ' && dx >= 0) out.push_back(' ');
    append_pair(out, dx, p.y - pen.y);
    command = command == 'M' ? 'l' : ' ';
    pen = p;
  }
  if (path.points.size() == 1) out += "l0 0";
  if (path.closed) out.push_back('z');
}

/// The document, whose names end in kOwn.
std::string document_of(const PenDrawing& drawing, const VectorOptions& options) {
  std::string text = fmt::format(
      "{2}<svg xmlns=\"http://www.w3.org/2000/svg\"{3} version=\"1.1\" "
      "width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\">\n",
      drawing.fit.width, drawing.fit.height, options.is_inline ? "" : kXmlDeclaration,
      kInkscapeNamespace);
  std::size_t number = 0;
  for (const PenLayer& layer : drawing.layers) {
    ++number;
    text += fmt::format(
        "<g id=\"pen-{0}{4}\" inkscape:groupmode=\"layer\" inkscape:label=\"{1}\" "
        "fill=\"none\" stroke=\"{2}\" stroke-width=\"{3}\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\">\n",
        number, name_of_layer(number, layer), colour_of_layer(layer),
        in_millimetres(layer.pen.width), kOwn);
    for (const PenPath& path : layer.paths) {
      text += "<path d=\"";
      append_path_data(text, path);
      text += "\"/>\n";
    }
    text += "</g>\n";
  }
  return text + "</svg>\n";
}

}  // namespace

std::string in_millimetres(std::int64_t units) {
  std::string text;
  append_millimetres(text, units);
  return text;
}

std::string colour_of_layer(const PenLayer& layer) {
  const std::uint32_t c = layer.pen.colour;
  return fmt::format("#{:02x}{:02x}{:02x}", c & 0xff, (c >> 8) & 0xff, (c >> 16) & 0xff);
}

std::string name_of_layer(std::size_t number, const PenLayer& layer) {
  return fmt::format("{} {} {} mm", number, colour_of_layer(layer),
                     in_millimetres(layer.pen.width));
}

void write_pens_svg(const PenDrawing& drawing, const Destination& to,
                    const VectorOptions& options) {
  const std::unique_ptr<Output> output = output_to(to);
  write_with_own_names({document_of(drawing, options)}, options.id_prefix, output->stream());
  output->commit();
}

}  // namespace displayfile
