#include <memory>
#include <numbers>
#include <ostream>

#include "displayfile/text/output_file.h"
#include "interp/device/cairo.h"
#include "interp/device/picture.h"
#include "interp/vector/cairo_stream.h"
#include "programs/sheet/drawing_sheet.h"

namespace displayfile {

namespace {

void draw_lines(const DrawingSheet& sheet, SheetLayer layer, cairo_t* context) {
  const SheetPen& pen = pen_of(layer);
  cairo().set_line_width(context, pen.width);
  cairo().set_dash(context, pen.dashes.data(), static_cast<int>(pen.dashes.size()), 0.0);
  for (const auto& line : sheet.lines) {
    if (line.layer != layer) continue;
    cairo().new_path(context);
    for (const Point2& p : line.points) cairo().line_to(context, p.x, sheet.height - p.y);
    if (line.closed) cairo().close_path(context);
    cairo().stroke(context);
  }
}

void draw_texts(const DrawingSheet& sheet, cairo_t* context) {
  cairo().select_font_face(context, sheet.font.c_str(), CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
  for (const auto& text : sheet.texts) {
    cairo().set_font_size(context, text.height / kCapitalsOfFont);
    cairo_text_extents_t extents;
    cairo().text_extents(context, text.characters.c_str(), &extents);
    cairo().save(context);
    cairo().translate(context, text.at.x, sheet.height - text.at.y);
    cairo().rotate(context, -text.turn * std::numbers::pi / 180.0);
    cairo().move_to(context, -before_anchor(text.alignment) * extents.x_advance, 0.0);
    cairo().show_text(context, text.characters.c_str());
    cairo().restore(context);
  }
}

}  // namespace

void write_sheet_pdf(const DrawingSheet& sheet, const std::string& file) {
  OutputFile output(file);
  const auto require = [&](cairo_status_t status) {
    require_cairo_success(status, file + ": Cairo cannot write the PDF");
  };
  const auto destroy_surface = [](cairo_surface_t* s) { cairo().surface_destroy(s); };
  const auto destroy = [](cairo_t* c) { cairo().destroy(c); };
  const std::unique_ptr<cairo_surface_t, decltype(destroy_surface)> surface(
      cairo().pdf_surface_create_for_stream(write_to_stream, &output.stream(),
                                            sheet.width * kPointsOfMillimetre,
                                            sheet.height * kPointsOfMillimetre));
  require(cairo().surface_status(surface.get()));
  // Left to itself Cairo stores the time.
  cairo().pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                   "2000-01-01T00:00:00Z");
  const std::unique_ptr<cairo_t, decltype(destroy)> context(cairo().create(surface.get()));
  require(cairo().status(context.get()));
  cairo().scale(context.get(), kPointsOfMillimetre, kPointsOfMillimetre);
  cairo().set_source_rgb(context.get(), 0.0, 0.0, 0.0);
  cairo().set_line_cap(context.get(), CAIRO_LINE_CAP_ROUND);
  cairo().set_line_join(context.get(), CAIRO_LINE_JOIN_ROUND);
  for (const SheetLayer layer : kLayersFromBelow) {
    draw_lines(sheet, layer, context.get());
  }
  draw_texts(sheet, context.get());
  cairo().show_page(context.get());
  require(cairo().status(context.get()));
  cairo().surface_finish(surface.get());
  require(cairo().surface_status(surface.get()));
  output.commit();
}

}  // namespace displayfile
