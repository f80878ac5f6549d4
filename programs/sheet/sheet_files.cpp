#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <set>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "interp/text/hershey_font.h"
#include "interp/text/letter_paths.h"
#include "interp/vector/dxf/dxf_drawing.h"
#include "programs/options/vector_words.h"
#include "programs/process/warnings.h"
#include "programs/sheet/drawing_sheet.h"
#include "programs/sheet/text_fit.h"

namespace displayfile {

namespace {

/// Texts in a Hershey font become lines, narrowed to the width for which their place was chosen.
DrawingSheet with_strokes(DrawingSheet sheet, const HersheyFont& font) {
  for (const DrawingSheet::Text& text : sheet.texts) {
    const double size = text.height / HersheyFont::kCapitalsOfSize;
    const double width = font.width(text.characters) * size;
    const double across =
        width > 0.0 ? size * std::min(1.0, text_width(text.characters, text.height) / width) : size;
    const double left = before_anchor(text.alignment) * font.width(text.characters) * across;
    const double turn = text.turn * std::numbers::pi / 180.0;
    const Point2 along(std::cos(turn), std::sin(turn)), up(-along.y, along.x);
    for (auto& stroke : font.strokes(text.characters, {-left, 0.0}, across, -size)) {
      for (Point2& p : stroke) p = text.at + p.x * along + p.y * up;
      sheet.lines.push_back({text.layer, std::move(stroke)});
    }
  }
  sheet.texts.clear();
  return sheet;
}

void warn_of_lacking(const DrawingSheet& sheet, const HersheyFont& font, const std::string& file) {
  std::set<std::string> lacking;
  for (const DrawingSheet::Text& text : sheet.texts) font.add_lacking(text.characters, lacking);
  if (lacking.empty()) return;
  warnings() << fmt::format("{}: the Hershey font {} lacks {}: left out\n", file, font.name(),
                            fmt::join(lacking, " "));
}

}  // namespace

void require_sheet_file(const std::string& file, const std::string& font) {
  require_lettering_of_option({.font = font});
  const std::string extension = extension_of(file);
  if (extension == ".svg" || extension == ".pdf") return;
  if (extension != ".dxf") {
    throw Error(fmt::format("{}: expected a sheet that ends in .svg, .pdf or .dxf", file));
  }
  if (!kWritesDxf) {
    throw Error(
        fmt::format("{}: this build has no dxflib, which writes DXF: install it (Debian: "
                    "libdxflib-dev) and build again",
                    file));
  }
  if (font == DrawingSheet().font || Lettering{.font = font}.is_of_strokes()) return;
  throw Error(
      fmt::format("--font {}: DXF has texts in the font of its reader: expected hershey, or no "
                  "font",
                  font));
}

void write_sheet(const DrawingSheet& sheet, const std::string& file) {
  require_sheet_file(file, sheet.font);
  if (const Lettering lettering{.font = sheet.font};
      lettering.is_of_strokes() && !sheet.texts.empty()) {
    const HersheyFont& font = hershey_font_of(lettering);
    warn_of_lacking(sheet, font, file);
    return write_sheet(with_strokes(sheet, font), file);
  }
  const std::string extension = extension_of(file);
  if (extension == ".svg") return write_sheet_svg(sheet, file);
  if (extension == ".pdf") return write_sheet_pdf(sheet, file);
  write_sheet_dxf(sheet, file);
}

}  // namespace displayfile
