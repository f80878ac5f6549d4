#pragma once

#include <functional>
#include <string>
#include <vector>

#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"

namespace displayfile {

/// A way to draw that the hard cases judge, at one precision.
struct Method {
  std::string name;    ///< "z-buffer", and what it is drawn with: "roundoff=1e-6"
  std::string column;  ///< the same in a few letters
  bool exact;          ///< claims that no pixel is wrong
  /// Width and height in pixels; ids are drawn.
  std::function<Picture(const DisplayFile&, int size)> draw;
  /// What it gave so far, if that is not what was asked for: empty for most.
  std::function<std::string()> note = nullptr;
};

/// All that are built. OSMesa's if this build has it, at each depth that it can be asked for.
std::vector<Method> methods();

/// Where the item buffers differ.
long long wrong_pixels(const Picture& picture, const Picture& truth);

}  // namespace displayfile
