// How SVG has disjoint fills: interp/vector/seams.md.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "interp/vector/path_data.h"
#include "interp/vector/seams.h"
#include "interp/vector/svg_device.h"

namespace displayfile {

namespace {

/// The mask of the outline, in units. Its own bounds leave room, not to be an edge themselves.
void append_mask(std::string& out, std::size_t number, const LatticeLoops& outline, double unit) {
  LatticePoint low = outline.points.front(), high = low;
  for (const LatticePoint& p : outline.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const int room = static_cast<int>(std::ceil(kTrapWidth / unit));
  fmt::format_to(std::back_inserter(out),
                 "<mask id=\"figure-{}\" maskUnits=\"userSpaceOnUse\" x=\"{}\" y=\"{}\" "
                 "width=\"{}\" height=\"{}\">\n<path class=\"whole\" d=\"",
                 number, low.x - room, low.y - room, high.x - low.x + 2 * room,
                 high.y - low.y + 2 * room);
  append_loops(out, outline);
  out += "\"/>\n</mask>\n";
}

}  // namespace

/// The outlines of the regions again, from the last to the first: on a side that two share, the
/// earlier is on top.
void SvgDevice::append_traps(const Figure& figure, std::size_t first_region) {
  fmt::format_to(std::back_inserter(body_), "<g class=\"traps\"><g id=\"t{}\">\n", figures_);
  for (std::size_t i = figure.regions.size(); i-- > 0;) {
    fmt::format_to(std::back_inserter(body_), "<use xlink:href=\"#r{}\"/>\n", first_region + i);
  }
  body_ += "</g></g>\n";
  static const int n=getenv("TRAPS")?atoi(getenv("TRAPS")):kTraps;
  for (int k = 1; k < n; ++k) fmt::format_to(std::back_inserter(body_), "<use stroke-width=\"{}\" xlink:href=\"#t{}\"/>", kTrapWidth / figure.unit / (1 << k), figures_);
}

void SvgDevice::append_regions(const Figure& figure, std::size_t first_region) {
  int segment = 0;
  const auto change_to = [&](int other) {
    if (segment != 0) close_group();
    if (other != 0) open_group(other);
    segment = other;
  };
  body_ += "<g class=\"pieces\">\n";
  const bool trapped = options().seams == Seams::trapped;
  for (std::size_t i = 0; i < figure.regions.size(); ++i) {
    const FigureRegion& region = figure.regions[i];
    if (region.segment != segment) change_to(region.segment);
    body_ += "<path";
    if (trapped) fmt::format_to(std::back_inserter(body_), " id=\"r{}\"", first_region + i);
    fmt::format_to(std::back_inserter(body_), " class=\"f{}\"",
                   fill_class({region.paint.pixel, trapped}));
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
  const std::size_t first_region = regions_ + 1;
  regions_ += figure.regions.size();
  const bool masked = options().seams == Seams::trapped && figure.regions.size() > 1;
  fmt::format_to(std::back_inserter(body_), "<g class=\"figure\" transform=\"scale({})\"",
                 figure.unit);
  if (masked) {
    fmt::format_to(std::back_inserter(body_),
                   " mask=\"url(#figure-{})\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"",
                   figures_);
  }
  body_ += ">\n";
  if (masked) {
    append_mask(body_, figures_, figure.outline, figure.unit);
    append_traps(figure, first_region);
  }
  append_regions(figure, first_region);
  body_ += "</g>\n";
  joinable_ = {};
}

}  // namespace displayfile
