#include "programs/options/paper_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "interp/draw/picture_formats.h"
#include "interp/draw/size_on_paper.h"
#include "programs/options/colour_word.h"
#include "programs/options/number_in.h"
#include "programs/options/option_groups.h"

namespace displayfile {

namespace {

std::optional<double> number_of(std::string_view word) {
  double value = 0.0;
  const char* const end = word.data() + word.size();
  const auto [stop, failure] = std::from_chars(word.data(), end, value);
  if (failure != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// SPACING[,ANGLE][,cross][,width=MM][,#rrggbb|NAME]
Hatching hatching_of(const std::string& text) {
  Hatching hatching;
  const auto fail = [&] {
    throw Error(
        fmt::format("--hatch {}: expected SPACING[,ANGLE][,cross][,width=MM][,COLOUR], in mm and "
                    "degrees, COLOUR #rrggbb or a CSS name, such as 0.8,45,cross",
                    text));
  };
  const auto number = [&](std::string_view word) {
    const auto value = number_of(word);
    if (!value) fail();
    return *value;
  };
  constexpr std::string_view kWidth = "width=";
  std::size_t place = 0;
  for (std::string_view rest = text; place == 0 || !rest.empty(); ++place) {
    const std::size_t comma = rest.find(',');
    const std::string_view word = rest.substr(0, comma);
    if (comma + 1 == rest.size()) fail();
    rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
    if (place == 0) {
      hatching.spacing = number(word);
    } else if (word == "cross") {
      hatching.cross = true;
    } else if (word.starts_with(kWidth)) {
      hatching.width = number(word.substr(kWidth.size()));
    } else if (place == 1 && number_of(word)) {
      hatching.angle = number(word);
    } else if (const auto colour = colour_of(word)) {
      hatching.colour = colour;
    } else {
      fail();
    }
  }
  return hatching;
}

/// COLOUR,...
std::vector<Colour> layers_of(const std::string& text) {
  std::vector<Colour> layers;
  for (std::string_view rest = text;;) {
    const std::size_t comma = rest.find(',');
    const std::string_view word = rest.substr(0, comma);
    const auto colour = colour_of(word);
    if (!colour) {
      throw Error(
          fmt::format("--pen-layers {}: '{}': expected colours separated by commas, each "
                      "#rrggbb or a CSS name, such as red,#0000ff",
                      text, word));
    }
    layers.push_back(*colour);
    if (comma == std::string_view::npos) return layers;
    rest = rest.substr(comma + 1);
  }
}

PenOrder order_of(const std::string& word) {
  try {
    return pen_order(word);
  } catch (const Error& error) {
    throw Error("--order: " + std::string(error.what()));
  }
}

}  // namespace

void PaperWords::add_to(CLI::App& command) {
  command
      .add_option(
          "--paper", paper,
          "paper size, of which the picture takes the shape unless --size is set; an SVG, PDF "
          "or EPS is drawn as large as fits: A0 to A6, letter, legal, tabloid, or WIDTHxHEIGHT "
          "in mm; with -portrait or -landscape appended, by default the picture's "
          "orientation; of a PNG with --dpi")
      ->type_name("PAPER")
      ->group(kPaperOptions);
  command.add_option("--margin", margin, "margin around the picture on the paper in mm [10]")
      ->type_name("MM")
      ->transform(any_number<double>())
      ->group(kPaperOptions);
  command
      .add_option("--dpi", dpi,
                  "pixels per inch of a PNG, which states it; widths and sizes in mm and --paper "
                  "then hold for it too")
      ->type_name("DPI")
      ->transform(any_number<double>())
      ->group(kPaperOptions);
  command
      .add_flag("--pens", pens,
                "for plotters and laser cutters: strokes only, none drawn twice, ordered for short "
                "travel, one layer per pen (colour and width), in .svg, .pdf or .dxf; on A4 unless "
                "--paper is set; auto "
                "means franklin, and meshes have the lines outline,boundary,crease unless --lines "
                "or a program before them selects others")
      ->group(kPaperOptions);
  command
      .add_option(
          "--hatch", hatch,
          "--pens, with fills hatched by parallel lines: "
          "SPACING[,ANGLE][,cross][,width=MM][,COLOUR]. Lines are SPACING mm apart where a fill is "
          "as dark as the pen and farther apart for brighter fills, at ANGLE degrees [45]; cross "
          "adds perpendicular lines to fills darker than the middle tone; lines run on over the "
          "facets of what is round, unless --shading is set; the pen has a width "
          "[0.3] and colour [black; white on dark paper]. Methods are map and, only where no fill "
          "covers another, --hidden none or back-face")
      ->type_name("SPACING,...")
      ->group(kPaperOptions);
  command
      .add_option("--order", order,
                  "with --pens or --hatch, the order of the paths of a pen: for short travel, or "
                  "for a cutter, what lies inside of closed contours before them [travel]")
      ->type_name("travel|cut")
      ->group(kPaperOptions);
  command
      .add_option("--pen-layers", layers,
                  "with --pens or --hatch, the order of the layers by the pens' colours, each "
                  "#rrggbb or a CSS name: red,#0000ff; other pens follow in order of first use")
      ->type_name("COLOUR,...")
      ->group(kPaperOptions);
}

bool PaperWords::read(DrawOptions& options, const PictureSizeWord& size, bool at_scale) const {
  if (dpi && !(*dpi >= 1.0 && *dpi <= kHighestDensity)) {
    throw Error(fmt::format("--dpi {}: expected 1 to {}", *dpi, kHighestDensity));
  }
  options.dpi = dpi;
  if (!paper.empty()) options.vectors.paper = paper_of(paper);
  if (pens || !hatch.empty()) options.pens.emplace();
  if (!hatch.empty()) options.pens->hatching = hatching_of(hatch);
  const auto require_pens_set = [&](const char* option, const std::string& word) {
    if (options.pens) return;
    throw Error(fmt::format("{} {}: expected with --pens or --hatch", option, word));
  };
  if (order) {
    const PenOrder wanted = order_of(*order);
    require_pens_set("--order", *order);
    options.pens->order = wanted;
  }
  if (layers) {
    std::vector<Colour> wanted = layers_of(*layers);
    require_pens_set("--pen-layers", *layers);
    options.pens->layers = std::move(wanted);
  }
  if (margin && !options.vectors.paper && !options.pens) {
    throw Error(fmt::format("--margin {}: expected with --paper, --pens or --hatch", *margin));
  }
  if (margin && !options.vectors.paper) options.vectors.paper.emplace();
  if (margin) options.vectors.paper->margin = *margin;
  const auto millimetres = size.millimetres();
  if (millimetres) {
    take_size_on_paper(*millimetres, options);
    return false;
  }
  size.read(options.width, options.height);
  const bool takes_papers = !size.is_set() && (options.vectors.paper || options.pens);
  if (takes_papers) take_shape_of_paper(options, at_scale);
  return takes_papers;
}

PixelSize pixel_size(const DrawOptions& options, const PictureSizeWord& size,
                     const std::string& file) {
  std::optional<Paper> sheet = options.vectors.paper;
  if (!sheet && options.pens) sheet.emplace();
  if (options.dpi) {
    return {kMillimetresOfInch / *options.dpi, sheet || size.millimetres().has_value()};
  }
  if (sheet) return {fit_on_paper(*sheet, options.width, options.height).pixel, true};
  const Destination to(file);
  const bool has_format = !options.format.empty() || !to.extension().empty();
  if (has_format && format_of(to, options).has_points()) return {1.0 / kPointsOfMillimetre};
  return {};
}

}  // namespace displayfile
