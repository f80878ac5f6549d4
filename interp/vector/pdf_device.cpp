#include "interp/vector/pdf_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <utility>

#include "clip/base/error.h"
#include "displayfile/text/output.h"
#include "interp/device/cairo.h"
#include "interp/device/interpreter.h"
#include "interp/device/picture.h"
#include "interp/text/cairo_text.h"
#include "interp/vector/cairo_figure.h"
#include "interp/vector/cairo_stream.h"
#include "interp/vector/pdf_layers.h"

namespace displayfile {

namespace {

void require_success(cairo_status_t status) {
  require_cairo_success(status, "Cairo cannot write the page");
}

/// The picture's place on its paper; without paper, pixels are points.
std::optional<PaperFit> sheet_of(const VectorOptions& options, int width, int height) {
  if (!options.paper) return std::nullopt;
  return fit_on_paper(*options.paper, width, height);
}

/// The sides of the page, in points.
Point2 page_sides(const VectorOptions& options, int width, int height) {
  const auto sheet = sheet_of(options, width, height);
  if (!sheet) return {width, height};
  return kPointsOfMillimetre * Point2(sheet->width, sheet->height);
}

cairo_surface_t* page_surface(PageFormat format, std::ostream& out, const Point2& sides) {
  return (format == PageFormat::pdf
              ? cairo().pdf_surface_create_for_stream
              : cairo().ps_surface_create_for_stream)(write_to_stream, &out, sides.x, sides.y);
}

/// Removes the date that Cairo writes.
std::string without_date(std::string eps) {
  constexpr std::string_view kDate = "%%CreationDate:";
  const std::size_t at = eps.find(kDate);
  if (at != eps.npos) eps.erase(at, eps.find('\n', at) + 1 - at);
  return eps;
}

/// Replaces Cairo's bounding boxes, which are those of the drawing, by the page's, in points. They
/// have whole numbers; the box with fractions that a page on paper needs follows the first. Cairo
/// places the page at the upper left of the larger box.
std::string with_boxes(std::string eps, const Point2& page) {
  constexpr std::string_view kBox = "BoundingBox:", kEndOfBoxes = "%%EndPageSetup";
  const Point2 whole = glm::ceil(page);
  std::string exact = page == whole ? ""
                                    : fmt::format("\n%%HiResBoundingBox: 0 {:.7g} {:.7g} {}",
                                                  whole.y - page.y, page.x, whole.y);
  for (std::size_t at = eps.find(kBox); at < eps.find(kEndOfBoxes); at = eps.find(kBox, at)) {
    at += kBox.size();
    const std::string box = fmt::format(" 0 0 {} {}", whole.x, whole.y) + std::exchange(exact, "");
    eps.replace(at, eps.find('\n', at) - at, box);
    at += box.size();
  }
  return eps;
}

}  // namespace

void PdfDevice::Destroy::operator()(_cairo* context) const { cairo().destroy(context); }
void PdfDevice::Destroy::operator()(_cairo_surface* surface) const {
  cairo().surface_destroy(surface);
}

PdfDevice::PdfDevice(std::ostream& out, int width, int height, const Background& background,
                     const VectorOptions& options, PageFormat format)
    : VectorDevice(width, height, background, options),
      out_(out),
      format_(format),
      surface_(page_surface(format, document_, page_sides(options, width, height))) {
  require_success(cairo().surface_status(surface_.get()));
  if (format == PageFormat::pdf) {  // by default Cairo stores the time
    cairo().pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                     "2000-01-01T00:00:00Z");
  } else {
    cairo().ps_surface_set_eps(surface_.get(), true);
  }
  context_.reset(cairo().create(surface_.get()));
  require_success(cairo().status(context_.get()));
  cairo().set_fill_rule(context_.get(), CAIRO_FILL_RULE_EVEN_ODD);
  cairo().set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
  if (const auto sheet = sheet_of(options, width, height)) {
    const double points = sheet->pixel * kPointsOfMillimetre;
    cairo().translate(context_.get(), sheet->left * kPointsOfMillimetre,
                      sheet->top * kPointsOfMillimetre);
    cairo().scale(context_.get(), points, points);
    cairo().rectangle(context_.get(), 0.0, 0.0, width, height);
    cairo().clip(context_.get());
  }
  if (background.kind == Background::Kind::none) return;
  set_colour(background.colour);
  cairo().rectangle(context_.get(), 0.0, 0.0, width, height);
  cairo().fill(context_.get());
}

PdfDevice::~PdfDevice() = default;

/// Cairo has no layers: content of a layer is marked by a structure element that it supports.
void PdfDevice::begin_layer(std::string_view name) {
  if (name == layer_ || format_ == PageFormat::eps) return;
  if (!layer_.empty()) cairo().tag_end(context_.get(), kMarkOfLayer);
  layer_ = name;
  if (name.empty()) return;
  cairo().tag_begin(context_.get(), kMarkOfLayer, nullptr);
  layers_.emplace_back(name);
}

void PdfDevice::begin_layer(int segment, std::string_view kind) {
  const std::string_view own = layer_of(segment);
  if (own.empty() || kind.empty()) return begin_layer(own.empty() ? kind : own);
  begin_layer(fmt::format("{}: {}", own, kind));
}

/// Rounds to 8 bits a component, as in every other picture.
void PdfDevice::set_colour(const Colour& colour) {
  set_cairo_colour(context_.get(), pixel_of(colour));
}

void PdfDevice::set_path(const Path& path) {
  cairo().new_path(context_.get());
  for (std::size_t i = 0; i < path.runs.size(); ++i) {
    const auto run = path.run(i);
    cairo().move_to(context_.get(), run[0].x, run[0].y);
    for (const Point2& p : run.subspan(1)) cairo().line_to(context_.get(), p.x, p.y);
    if (path.runs[i].closed) cairo().close_path(context_.get());
  }
}

void PdfDevice::paint_fill(const Path& path, const FillPaint& paint, bool seam) {
  begin_layer(segment_, {});
  cairo_t* context = context_.get();
  set_cairo_paint(context, paint);
  set_path(path);
  if (seam) {
    cairo().fill_preserve(context);
    cairo().set_line_width(context, kSeamWidth);
    cairo().set_dash(context, nullptr, 0, 0.0);
    cairo().stroke(context);
  } else {
    cairo().fill(context);
  }
}

void PdfDevice::paint_figure(const Figure& figure) {
  cairo().set_dash(context_.get(), nullptr, 0, 0.0);
  if (options().layers) {
    return paint_cairo_figure_without_masks(context_.get(), figure, [&](int segment) {
      begin_layer(segment != 0 ? segment : segment_, {});
    });
  }
  begin_layer({});
  if (format_ == PageFormat::pdf) return paint_cairo_figure(context_.get(), figure);
  paint_cairo_figure_without_masks(context_.get(), figure);
}

void PdfDevice::paint_lines(const Path& path, const LineStyle& style, LineKinds kinds,
                            LineCap cap) {
  begin_layer(segment_, first_name_of(kinds));
  cairo_t* context = context_.get();
  set_colour(style.colour);
  if (cap == LineCap::square) {
    const Point2& dot = path.points.front();
    const double w = style.width;
    cairo().rectangle(context, dot.x - 0.5 * w, dot.y - 0.5 * w, w, w);
    return cairo().fill(context);
  }
  cairo().set_line_cap(context, cap == LineCap::round ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  cairo().set_line_width(context, style.width);
  const double dashes[] = {style.dash, style.gap};
  cairo().set_dash(context, dashes, style.kind == LineStyle::Kind::dashed ? 2 : 0, 0.0);
  set_path(path);
  cairo().stroke(context);
}

void PdfDevice::paint_text(const DeviceText& text, const Point2& anchor, double size) {
  begin_layer(segment_, {});
  set_colour(text.line.colour);
  CairoText(context_.get(), options().lettering.family(), text, anchor, size).show();
}

void PdfDevice::finish() {
  finish_lines();
  begin_layer({});
  cairo().show_page(context_.get());
  document_.require_whole();
  require_success(cairo().status(context_.get()));
  cairo().surface_finish(surface_.get());
  document_.require_whole();
  require_success(cairo().surface_status(surface_.get()));
  if (format_ == PageFormat::eps) {
    out_ << with_boxes(without_date(std::move(document_).str()),
                       page_sides(options(), width(), height()));
    return;
  }
  out_ << (layers_.empty() ? std::move(document_).str()
                           : with_layers(std::move(document_).str(), layers_));
}

namespace {

void write_page(PageFormat format, const DisplayFile& display_file, int width, int height,
                const Destination& to, const Background& background, bool colour_rule,
                const VectorOptions& options) {
  require_picture_size(width, height);
  const std::unique_ptr<Output> file = output_to(to);
  try {
    PdfDevice device(file->stream(), width, height, background, options, format);
    if (colour_rule) device.fill_with_background();
    device.take_titles(display_file);
    interpret(display_file, device);
    device.draw_texts(display_file);
    device.draw_annotation(display_file, kPointsOfMillimetre);
    device.finish();
  } catch (const Error& e) {
    throw Error(fmt::format("{}: {}", to.name(), e.what()));
  }
  file->commit();
}

}  // namespace

void write_pdf(const DisplayFile& display_file, int width, int height, const Destination& to,
               const Background& background, bool colour_rule, const VectorOptions& options) {
  write_page(PageFormat::pdf, display_file, width, height, to, background, colour_rule, options);
}

void write_eps(const DisplayFile& display_file, int width, int height, const Destination& to,
               const Background& background, bool colour_rule, const VectorOptions& options) {
  write_page(PageFormat::eps, display_file, width, height, to, background, colour_rule, options);
}

}  // namespace displayfile
