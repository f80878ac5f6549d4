#include "interp/vector/cairo_figure.h"

#include <memory>

#include "interp/cairo.h"
#include "interp/vector/seams.h"

namespace displayfile {

namespace {

void set_path(_cairo* context, const LatticeLoops& loops, double unit) {
  cairo().new_path(context);
  for (std::size_t k = 0; k < loops.size(); ++k) {
    bool first = true;
    for (const LatticePoint& p : loops.loop(k)) {
      (first ? cairo().move_to : cairo().line_to)(context, p.x * unit, p.y * unit);
      first = false;
    }
    cairo().close_path(context);
  }
}

void fill_regions(_cairo* context, const Figure& figure) {
  for (const FigureRegion& region : figure.regions) {
    set_cairo_colour(context, region.paint.pixel);
    set_path(context, region.loops, figure.unit);
    cairo().fill(context);
  }
}

/// From the last to the first: on a side that two share, the earlier is on top.
void stroke_traps(_cairo* context, const Figure& figure, double width) {
  cairo().set_line_width(context, width);
  for (auto region = figure.regions.rbegin(); region != figure.regions.rend(); ++region) {
    set_cairo_colour(context, region->paint.pixel);
    set_path(context, region->loops, figure.unit);
    cairo().stroke(context);
  }
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
  cairo().set_source_rgb(context, (pixel & 0xff) / 255.0, ((pixel >> 8) & 0xff) / 255.0,
                         ((pixel >> 16) & 0xff) / 255.0);
}

void paint_cairo_figure(_cairo* context, const Figure& figure, Seams seams) {
  if (seams == Seams::butted || figure.regions.size() == 1) return fill_regions(context, figure);
  const Pattern pieces = group(context, [&] {
    static const int n=getenv("TRAPS")?atoi(getenv("TRAPS")):kTraps;
    for (int k = 0; k < n; ++k) stroke_traps(context, figure, kTrapWidth / (1 << k));
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

}  // namespace displayfile
