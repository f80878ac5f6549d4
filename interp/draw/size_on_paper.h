#pragma once

#include <optional>
#include <string_view>

#include "interp/draw/draw.h"

namespace displayfile {

/// A size on paper.
struct MillimetreSize {
  double width, height;
};

/// Reads WIDTHxHEIGHTmm, such as 80x60mm; none for a word that does not end in mm. Throws Error,
/// beginning with the option's name, for another word that does, and for sides that paper cannot
/// have.
std::optional<MillimetreSize> millimetre_size(std::string_view word, std::string_view option);

/// Sets the picture's size in pixels, with the paper and the density that the options have: a
/// picture of that size on their paper or, without one, on a sheet of that size; with a density, of
/// pixels for it. Pixels without a density are points.
void take_size_on_paper(const MillimetreSize& size, DrawOptions& options);

/// The same for a picture with the shape of the paper (A4 unless one is set) between its margins;
/// the options' size before decides the paper's orientation unless it has one. `at_scale`: at a
/// scale a picture without a density may be over the margins by an invisible amount, so that
/// contents that fit on the paper fit in the picture; pixels are then up to a fiftieth larger or
/// smaller than a point.
void take_shape_of_paper(DrawOptions& options, bool at_scale = false);

}  // namespace displayfile
