#pragma once

#include <functional>
#include <string>
#include <vector>

#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"

namespace displayfile {

/// A method that the hard cases judge, at one precision.
struct Method {
  std::string name;    ///< "z-buffer", or its settings: "roundoff=1e-6"
  std::string column;  ///< the same in a few letters
  bool exact;          ///< claims that no pixel is wrong
  /// Width and height in pixels; ids are drawn.
  std::function<Picture(const DisplayFile&, int size)> draw;
  /// The properties granted so far, if they differ from the requested ones: empty for most.
  std::function<std::string()> note = nullptr;
};

/// All methods of this build. OSMesa's if the build has it, at each depth that can be requested.
std::vector<Method> methods();

/// Where the item buffers differ.
long long wrong_pixels(const Picture& picture, const Picture& truth);

}  // namespace displayfile
