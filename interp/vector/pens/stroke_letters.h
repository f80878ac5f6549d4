#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// A text as strokes, for a pen. Its base line begins at (0, 0) and runs along x; capitals are 1
/// high.
struct StrokeLetters {
  std::vector<std::pair<Point2, Point2>> strokes;
  double width = 0.0;
};

/// UTF-8. Letters of ASCII, digits and the signs of annotation; other characters are boxes.
StrokeLetters stroke_letters(std::string_view characters);

}  // namespace displayfile
