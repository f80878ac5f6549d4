#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace displayfile {

/// A scale of drawings, PAPER:PART.
struct DrawingScale {
  double paper = 1.0, part = 1.0;
  double factor() const { return paper / part; }
  std::string text() const;
};

/// Reads `2:1`, `1:50` and so on; nothing if it is not two positive numbers.
std::optional<DrawingScale> read_scale(std::string_view word);
/// The same for --scale: throws Error.
DrawingScale drawing_scale(std::string_view word);
/// The largest standard scale (ISO 5455: 1, 2 and 5 times a power of ten, to 1) for which fits(),
/// from 1000000:1 to 1:1000000000. Throws Error if none does.
DrawingScale largest_standard_scale(const std::function<bool(double)>& fits);

}  // namespace displayfile
