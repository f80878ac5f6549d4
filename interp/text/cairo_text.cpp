#include "interp/text/cairo_text.h"

#include <cmath>
#include <numbers>

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
  if (text.turn != 0.0) {
    const double angle = text.turn * std::numbers::pi / 180.0;
    along_ = {std::cos(angle), -std::sin(angle)};
  }
  set_font(context, size);
  cairo().text_extents(context, text.characters.c_str(), &extents_);
  require_success(context);
  const double before = part_before_anchor(text.style.alignment) * extents_.x_advance;
  start_ = {anchor.x - before * along_.x, anchor.y - before * along_.y};
}

Rectangle CairoText::ink() const {
  const Point2 down(-along_.y, along_.x);
  Rectangle all = Rectangle::nothing();
  for (const double right : {0.0, extents_.width}) {
    for (const double below : {0.0, extents_.height}) {
      all.include(start_ + (extents_.x_bearing + right) * along_ +
                  (extents_.y_bearing + below) * down);
    }
  }
  return all;
}

void CairoText::show() const {
  if (text_.turn == 0.0) {
    cairo().move_to(context_, start_.x, start_.y);
    cairo().show_text(context_, text_.characters.c_str());
    return require_success(context_);
  }
  cairo().save(context_);
  cairo().translate(context_, start_.x, start_.y);
  cairo().rotate(context_, std::atan2(along_.y, along_.x));
  cairo().move_to(context_, 0.0, 0.0);
  cairo().show_text(context_, text_.characters.c_str());
  cairo().restore(context_);
  require_success(context_);
}

}  // namespace displayfile
