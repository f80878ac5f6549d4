#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <utility>

#include "interp/vector/fill_paint.h"

namespace displayfile {

/// The ramps of an SVG document: one gradient for each colour has the stops and is called c1, c2,
/// ..., and one for each ramp, which refers to it, has the ends and is called r1, r2, ...
class SvgRamps {
 public:
  /// The number of the ramp of a paint that has one, with ends in units of this many pixels, as the
  /// coordinates of the elements that refer to it.
  std::size_t number(const FillPaint& paint, double unit);
  /// Writes them as the document's definitions, unless there are none.
  void write(std::ostream& out) const;

 private:
  std::map<std::uint32_t, std::size_t> colours_;
  std::map<std::pair<FillPaint, double>, std::size_t> numbers_;
  std::string stops_, ends_;
};

}  // namespace displayfile
