#include "interp/vector/cairo_figure.h"

#include <array>
#include <memory>
#include <span>

#include "interp/cairo.h"
#include "interp/vector/seams.h"
#include "interp/vector/tents.h"

namespace displayfile {

namespace {

/// Red, green and blue in [0,1].
std::array<double, 3> components_of(std::uint32_t pixel) {
  return {(pixel & 0xff) / 255.0, ((pixel >> 8) & 0xff) / 255.0, ((pixel >> 16) & 0xff) / 255.0};
}

void add_line(_cairo* context, std::span<const LatticePoint> points, double unit, bool closed) {
  cairo().move_to(context, points[0].x * unit, points[0].y * unit);
  for (const LatticePoint& p : points.subspan(1)) {
    cairo().line_to(context, p.x * unit, p.y * unit);
  }
  if (closed) cairo().close_path(context);
}

void set_path(_cairo* context, const LatticeLoops& loops, double unit) {
  cairo().new_path(context);
  for (std::size_t k = 0; k < loops.size(); ++k) add_line(context, loops.loop(k), unit, true);
}

void fill_regions(_cairo* context, const Figure& figure) {
  for (const FigureRegion& region : figure.regions) {
    set_cairo_paint(context, region.paint);
    set_path(context, region.loops, figure.unit);
    cairo().fill(context);
  }
}

void stroke_traps(_cairo* context, const Figure& figure) {
  cairo().set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  for (const double width : kTrapWidths) {
    cairo().set_line_width(context, width);
    for (const FigureTrap& trap : figure.traps) {
      set_cairo_paint(context, trap.paint);
      cairo().new_path(context);
      for (std::size_t k = 0; k < trap.sides.size(); ++k) {
        add_line(context, trap.sides.chain(k), figure.unit, trap.sides.closed[k]);
      }
      cairo().stroke(context);
    }
  }
  cairo().set_line_cap(context, CAIRO_LINE_CAP_BUTT);
}

struct DestroyPattern {
  void operator()(cairo_pattern_t* pattern) const { cairo().pattern_destroy(pattern); }
};
using Pattern = std::unique_ptr<cairo_pattern_t, DestroyPattern>;

template <class Paint>
Pattern group(_cairo* context, const Paint& paint) {
  cairo().push_group(context);
  paint();
  return Pattern(cairo().pop_group(context));
}

}  // namespace

void set_cairo_colour(_cairo* context, std::uint32_t pixel) {
  const auto [red, green, blue] = components_of(pixel);
  cairo().set_source_rgb(context, red, green, blue);
}

void set_cairo_paint(_cairo* context, const FillPaint& paint) {
  if (!paint.ramp) return set_cairo_colour(context, paint.pixel);
  const ColourRamp& ramp = *paint.ramp;
  const Pattern gradient(
      cairo().pattern_create_linear(ramp.black_x, ramp.black_y, ramp.full_x, ramp.full_y));
  const auto [red, green, blue] = components_of(paint.pixel);
  cairo().pattern_add_color_stop_rgb(gradient.get(), 0.0, 0.0, 0.0, 0.0);
  cairo().pattern_add_color_stop_rgb(gradient.get(), 1.0, red, green, blue);
  cairo().set_source(context, gradient.get());
}

void paint_cairo_figure(_cairo* context, const Figure& figure) {
  if (figure.traps.empty()) return fill_regions(context, figure);
  const Pattern pieces = group(context, [&] {
    stroke_traps(context, figure);
    fill_regions(context, figure);
  });
  const Pattern mask = group(context, [&] {
    cairo().set_source_rgb(context, 1.0, 1.0, 1.0);
    set_path(context, figure.outline, figure.unit);
    cairo().fill(context);
  });
  cairo().set_source(context, pieces.get());
  cairo().mask(context, mask.get());
  cairo().set_source_rgb(context, 0.0, 0.0, 0.0);  // the groups may go
}

void paint_cairo_figure_without_masks(_cairo* context, const Figure& figure) {
  if (!figure.traps.empty()) {
    cairo().set_fill_rule(context, CAIRO_FILL_RULE_WINDING);
    for (const FigureTents& tents : tents_of(figure.regions, kTrapWidth / 2.0 / figure.unit)) {
      set_cairo_paint(context, tents.paint);
      set_path(context, tents.triangles, figure.unit);
      cairo().fill(context);
    }
    cairo().set_fill_rule(context, CAIRO_FILL_RULE_EVEN_ODD);
  }
  fill_regions(context, figure);
}

}  // namespace displayfile
