// Disjoint fills in SVG: interp/vector/seams.md.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "interp/vector/file_key.h"
#include "interp/vector/path_data.h"
#include "interp/vector/seams.h"
#include "interp/vector/svg_device.h"

namespace displayfile {

namespace {

void append_white_path(std::string& out, const char* attributes, const LatticeLoops& loops) {
  fmt::format_to(std::back_inserter(out), "<path class=\"whole{}\"{} d=\"", kOwn, attributes);
  append_loops(out, loops);
  out += "\"/>\n";
}

/// Appends the mask of the outline, in units. Its bounds leave room, so that they are not visible
/// as an edge. Pieces rounded to the same loops have no outline.
void append_mask(std::string& out, std::size_t number, const Figure& figure) {
  LatticePoint low = figure.regions.front().loops.points.front(), high = low;
  for (const LatticeLoops& part : figure.outline) {
    for (const LatticePoint& p : part.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  const int room = static_cast<int>(std::ceil(kTrapWidth / figure.unit));
  fmt::format_to(std::back_inserter(out),
                 "<mask id=\"figure-{}{}\" maskUnits=\"userSpaceOnUse\" x=\"{}\" y=\"{}\" "
                 "width=\"{}\" height=\"{}\">\n",
                 number, kOwn, low.x - room, low.y - room, high.x - low.x + 2 * room,
                 high.y - low.y + 2 * room);
  for (const LatticeLoops& part : figure.outline) append_white_path(out, "", part);
  for (const LatticeLoops& tents : figure.outline_tents) {
    append_white_path(out, " fill-rule=\"nonzero\"", tents);
  }
  out += "</mask>\n";
}

}  // namespace

/// Appends the beginning of a path: a class, which regions and traps share, or a ramp as its fill
/// or stroke.
void SvgDevice::append_paint(const char* property, const FillPaint& paint, const Figure& figure) {
  auto out = std::back_inserter(body_);
  if (paint.ramp) {
    fmt::format_to(out, "<path {}=\"url(#r{}{})\"", property, ramps_.number(paint, figure.unit),
                   kOwn);
  } else {
    fmt::format_to(out, "<path class=\"f{}{}\"", fill_class({paint.pixel, !figure.traps.empty()}),
                   kOwn);
  }
}

/// Appends the traps once for each width: a group, then references to it.
void SvgDevice::append_traps(const Figure& figure) {
  auto out = std::back_inserter(body_);
  fmt::format_to(out, "<g class=\"traps{1}\">\n<g id=\"traps-{0}{1}\" class=\"sides{1}\">\n",
                 figures_, kOwn);
  for (const FigureTrap& trap : figure.traps) {
    append_paint("stroke", trap.paint, figure);
    body_ += " d=\"";
    append_chains(body_, trap.sides);
    body_ += "\"/>\n";
  }
  body_ += "</g>\n";
  for (std::size_t k = 1; k < kTrapWidths.size(); ++k) {
    fmt::format_to(out, "<use xlink:href=\"#traps-{}{}\" stroke-width=\"{:.0f}\"/>\n", figures_,
                   kOwn, std::ceil(kTrapWidths[k] / figure.unit));
  }
  body_ += "</g>\n";
}

void SvgDevice::append_regions(const Figure& figure) {
  int segment = 0;
  const auto change_to = [&](int other) {
    if (segment != 0) close_group();
    if (other != 0) open_group(other);
    segment = other;
  };
  fmt::format_to(std::back_inserter(body_), "<g class=\"pieces{}\"", kOwn);
  if (options().layers) append_layer("pieces");
  body_ += ">\n";
  for (const FigureRegion& region : figure.regions) {
    if (region.segment != segment) change_to(region.segment);
    append_paint("fill", region.paint, figure);
    if (options().pick_ids) {
      fmt::format_to(std::back_inserter(body_), " data-pick=\"{}\"", region.pick);
    }
    body_ += " d=\"";
    append_loops(body_, region.loops);
    if (options().pick_ids) {
      fmt::format_to(std::back_inserter(body_), "\"><title>{}</title></path>\n", region.pick);
    } else {
      body_ += "\"/>\n";
    }
  }
  change_to(0);
  body_ += "</g>\n";
}

void SvgDevice::paint_figure(const Figure& figure) {
  ++figures_;
  const bool trapped = !figure.traps.empty();
  fmt::format_to(std::back_inserter(body_), "<g class=\"figure{}\" transform=\"scale({})\"", kOwn,
                 figure.unit);
  if (trapped) {
    fmt::format_to(std::back_inserter(body_),
                   " mask=\"url(#figure-{}{})\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"",
                   figures_, kOwn);
  }
  if (options().layers) append_layer("surfaces");
  body_ += ">\n";
  if (trapped) {
    append_mask(body_, figures_, figure);
    append_traps(figure);
  }
  append_regions(figure);
  body_ += "</g>\n";
  joinable_ = {};
}

}  // namespace displayfile
