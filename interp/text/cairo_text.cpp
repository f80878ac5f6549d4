#include "interp/text/cairo_text.h"

namespace displayfile {

namespace {

/// How much of a text's width stands left of its anchor.
double part_before_anchor(TextStyle::Alignment alignment) {
  switch (alignment) {
    case TextStyle::Alignment::left: return 0.0;
    case TextStyle::Alignment::centre: return 0.5;
    case TextStyle::Alignment::right: break;
  }
  return 1.0;
}

void require_success(cairo_t* context) {
  require_cairo_success(cairo().status(context), "Cairo cannot draw a text");
}

/// Left to itself Cairo fits letters to pixels.
void set_font(cairo_t* context, double size) {
  cairo().select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
  cairo().set_font_size(context, size);
  cairo_font_options_t* const options = cairo().font_options_create();
  cairo().font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo().font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo().font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo().set_font_options(context, options);
  cairo().font_options_destroy(options);
}

}  // namespace

CairoText::CairoText(cairo_t* context, const DeviceText& text, const Point2& anchor, double size)
    : context_(context), text_(text) {
  set_font(context, size);
  cairo().text_extents(context, text.characters.c_str(), &extents_);
  require_success(context);
  start_ = {anchor.x - part_before_anchor(text.style.alignment) * extents_.x_advance, anchor.y};
}

Rectangle CairoText::ink() const {
  const double left = start_.x + extents_.x_bearing, top = start_.y + extents_.y_bearing;
  return {left, left + extents_.width, top, top + extents_.height};
}

void CairoText::show() const {
  cairo().move_to(context_, start_.x, start_.y);
  cairo().show_text(context_, text_.characters.c_str());
  require_success(context_);
}

}  // namespace displayfile
