#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/collected_text.h"
#include "displayfile/text/output.h"
#include "interp/device/cairo.h"
#include "interp/vector/cairo_figure.h"
#include "interp/vector/cairo_stream.h"
#include "interp/vector/pdf_layers.h"
#include "interp/vector/pens/pen_files.h"

namespace displayfile {

namespace {

void draw_path(cairo_t* context, const PenPath& path) {
  constexpr double kPointsOfUnit = kPointsOfMillimetre / kUnitsOfMillimetre;
  cairo().new_path(context);
  for (const SheetPoint& p : path.points) {  // the first of them moves
    cairo().line_to(context, p.x * kPointsOfUnit, p.y * kPointsOfUnit);
  }
  if (path.closed || path.points.size() == 1) cairo().close_path(context);
  cairo().stroke(context);
}

void draw_layer(cairo_t* context, const PenLayer& layer) {
  set_cairo_colour(context, layer.pen.colour);
  cairo().set_line_width(context, layer.pen.width * kPointsOfMillimetre / kUnitsOfMillimetre);
  for (const PenPath& path : layer.paths) draw_path(context, path);
}

}  // namespace

void write_pens_pdf(const PenDrawing& drawing, const Destination& to, const VectorOptions&) {
  const std::unique_ptr<Output> output = output_to(to);
  CollectedText document;  // until its layers are marked
  const auto require = [&](cairo_status_t status) {
    require_cairo_success(status, to.name() + ": Cairo cannot write the PDF");
  };
  const auto destroy_surface = [](cairo_surface_t* s) { cairo().surface_destroy(s); };
  const auto destroy = [](cairo_t* c) { cairo().destroy(c); };
  const std::unique_ptr<cairo_surface_t, decltype(destroy_surface)> surface(
      cairo().pdf_surface_create_for_stream(write_to_stream, &document,
                                            drawing.fit.width * kPointsOfMillimetre,
                                            drawing.fit.height * kPointsOfMillimetre));
  require(cairo().surface_status(surface.get()));
  // By default Cairo stores the time.
  cairo().pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                   "2000-01-01T00:00:00Z");
  const std::unique_ptr<cairo_t, decltype(destroy)> context(cairo().create(surface.get()));
  require(cairo().status(context.get()));
  cairo().set_line_cap(context.get(), CAIRO_LINE_CAP_ROUND);
  cairo().set_line_join(context.get(), CAIRO_LINE_JOIN_ROUND);
  const bool has_layers = has_pdf_layers();
  std::vector<std::string> names;
  for (const PenLayer& layer : drawing.layers) {
    if (has_layers) cairo().tag_begin(context.get(), kMarkOfLayer, nullptr);
    draw_layer(context.get(), layer);
    if (!has_layers) continue;
    cairo().tag_end(context.get(), kMarkOfLayer);
    names.push_back(name_of_layer(names.size() + 1, layer));
  }
  cairo().show_page(context.get());
  document.require_whole();
  require(cairo().status(context.get()));
  cairo().surface_finish(surface.get());
  document.require_whole();
  require(cairo().surface_status(surface.get()));
  std::string bytes = std::move(document).str();
  output->stream() << (names.empty() ? std::move(bytes) : with_layers(bytes, names));
  output->commit();
}

}  // namespace displayfile
