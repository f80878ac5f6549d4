#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <utility>

#include "interp/vector/fill_paint.h"

namespace displayfile {

/// The ramps of an SVG document: for each colour a gradient c1, c2, ... with the stops, and for
/// each ramp a gradient r1, r2, ... that refers to it and has the ends.
class SvgRamps {
 public:
  /// The number of a paint's ramp, with ends in units of this many pixels, as the coordinates of
  /// the elements that refer to it.
  std::size_t number(const FillPaint& paint, double unit);
  /// Writes the ramps as the document's definitions, if there are any.
  void write(std::ostream& out) const;

 private:
  std::map<std::uint32_t, std::size_t> colours_;
  std::map<std::pair<FillPaint, double>, std::size_t> numbers_;
  std::string stops_, ends_;
};

}  // namespace displayfile
