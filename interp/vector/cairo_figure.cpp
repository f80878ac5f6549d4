#include "interp/vector/cairo_figure.h"

#include <algorithm>
#include <array>
#include <memory>
#include <span>

#include "interp/device/cairo.h"
#include "interp/vector/seams.h"
#include "interp/vector/tents.h"

namespace displayfile {

namespace {

/// A component in [0,1]. Cairo writes six decimals, and MuPDF truncates 255 times the value:
/// without an increment the result would be the level below.
double component(std::uint32_t level) {
  constexpr double kLastDecimal = 1e-6;
  return level == 0 ? 0.0 : std::min(level / 255.0 + kLastDecimal, 1.0);
}

/// The red, green and blue components.
std::array<double, 3> components_of(std::uint32_t pixel) {
  return {component(pixel & 0xff), component((pixel >> 8) & 0xff), component((pixel >> 16) & 0xff)};
}

/// Cairo writes a gradient anew each time that it paints with it, and files with many are slow to
/// read. A region that varies by no more than this many levels is therefore painted in the middle
/// colour, and so are traps, of which little is visible, and all traps where there are many ramps,
/// which are short then.
constexpr double kEvenLevelsOfRegion = 2.0, kEvenLevelsOfTrap = 8.0;
constexpr std::ptrdiff_t kManyRamps = 1000;

double even_levels_of_traps(const Figure& figure) {
  const auto ramps = std::ranges::count_if(
      figure.regions, [](const FigureRegion& region) { return region.paint.ramp.has_value(); });
  return ramps <= kManyRamps ? kEvenLevelsOfTrap : 255.0;
}

/// Sets the paint for an area with these points: one colour if it varies by no more than that many
/// levels.
void set_paint(_cairo* context, const FillPaint& paint, std::span<const LatticePoint> points,
               double unit, double even_levels) {
  if (!paint.ramp) return set_cairo_colour(context, paint.pixel);
  double low = 1.0, high = 0.0;
  for (const LatticePoint& p : points) {
    const double part = std::clamp(paint.ramp->at(Point2(p.x, p.y) * unit), 0.0, 1.0);
    low = std::min(low, part);
    high = std::max(high, part);
  }
  const auto full = components_of(paint.pixel);
  if ((high - low) * 255.0 * std::ranges::max(full) > even_levels) {
    return set_cairo_paint(context, paint);
  }
  const double middle = (low + high) / 2.0;
  cairo().set_source_rgb(context, full[0] * middle, full[1] * middle, full[2] * middle);
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

void fill_regions(_cairo* context, const Figure& figure,
                  const std::function<void(int segment)>& before = {}) {
  for (const FigureRegion& region : figure.regions) {
    if (before) before(region.segment);
    set_paint(context, region.paint, region.loops.points, figure.unit, kEvenLevelsOfRegion);
    set_path(context, region.loops, figure.unit);
    cairo().fill(context);
  }
}

void stroke_traps(_cairo* context, const Figure& figure) {
  const double even_levels = even_levels_of_traps(figure);
  cairo().set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  for (const double width : kTrapWidths) {
    cairo().set_line_width(context, width);
    for (const FigureTrap& trap : figure.traps) {
      set_paint(context, trap.paint, trap.sides.points, figure.unit, even_levels);
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
    for (const LatticeLoops& part : figure.outline) {
      set_path(context, part, figure.unit);
      cairo().fill(context);
    }
    cairo().set_fill_rule(context, CAIRO_FILL_RULE_WINDING);
    for (const LatticeLoops& tents : figure.outline_tents) {
      set_path(context, tents, figure.unit);
      cairo().fill(context);
    }
    cairo().set_fill_rule(context, CAIRO_FILL_RULE_EVEN_ODD);
  });
  cairo().set_source(context, pieces.get());
  cairo().mask(context, mask.get());
  cairo().set_source_rgb(context, 0.0, 0.0, 0.0);  // the groups may go
}

void paint_cairo_figure_without_masks(_cairo* context, const Figure& figure,
                                      const std::function<void(int segment)>& before) {
  if (!figure.traps.empty()) {
    cairo().set_fill_rule(context, CAIRO_FILL_RULE_WINDING);
    const double even_levels = even_levels_of_traps(figure);
    for (const FigureTents& tents : tents_of(figure.regions, kTrapWidth / 2.0 / figure.unit)) {
      if (before) before(tents.segment);
      set_paint(context, tents.paint, tents.triangles.points, figure.unit, even_levels);
      set_path(context, tents.triangles, figure.unit);
      cairo().fill(context);
    }
    cairo().set_fill_rule(context, CAIRO_FILL_RULE_EVEN_ODD);
  }
  fill_regions(context, figure, before);
}

}  // namespace displayfile
