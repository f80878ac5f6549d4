#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "interp/draw/draw.h"
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

}  // namespace displayfile
