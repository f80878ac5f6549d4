#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "interp/draw/draw.h"
#include "programs/options/line_words.h"
#include "programs/options/picture_size.h"

namespace displayfile {

/// The options --paper, --margin, --dpi, --pens, --hatch, --order and --pen-layers, as words.
struct PaperWords {
  std::string paper, hatch;
  std::optional<double> margin, dpi;
  std::optional<std::string> order, layers;
  bool pens = false;

  void add_to(CLI::App& command);
  /// Sets the size, paper, density and pens of the options. Without a size on the command line, a
  /// picture on paper takes the shape of the paper between its margins, with pixels of a point, or
  /// as the density has them; then it returns true. The options' previous size decides the
  /// orientation of the paper, where its word does not. Throws Error for an invalid word, or for a
  /// length out of its range. `at_scale`: the shape is exact, so that contents that fit on the
  /// paper fit in the picture; pixels are then up to a fiftieth larger or smaller than a point.
  bool read(DrawOptions& options, const PictureSizeWord& size, bool at_scale = false) const;
};

/// The size of a picture's pixels with these options, if it is known: on paper, with a density, and
/// in PDF and EPS, where a pixel without either is a point. `file` is the picture's name. Numbers
/// without a unit are millimetres on paper, and where --size is in millimetres. Throws Error for an
/// unknown format.
PixelSize pixel_size(const DrawOptions& options, const PictureSizeWord& size,
                     const std::string& file);

}  // namespace displayfile
