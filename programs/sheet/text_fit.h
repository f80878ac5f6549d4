#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// The approximate width of a text on paper whose capitals have that height. The reader's program
/// chooses the face: measured in DejaVu Sans, one of the widest without serifs.
double text_width(std::string_view text, double height);

/// Text in lines below each other.
struct FittedText {
  double height;  ///< of capital letters
  std::vector<std::string> lines;
  bool whole = true;  ///< else it ends in an ellipsis
};
inline constexpr double kLinePitch = 1.6;  ///< from baseline to baseline, in heights

/// The text in letters as large as the room allows: 3.5, 2.5 or 1.8 mm (ISO 3098-1), in several
/// lines if need be; broken within words, and then shortened, only if 1.8 mm is too large.
FittedText fit_text(std::string_view text, const Point2& room);

}  // namespace displayfile
