#pragma once

#include <string>

#include "clip/view.h"

namespace displayfile {

/// An exact scale of pictures on paper, for parallel views.
struct ExactScale {
  std::string name;       ///< for messages, such as "--scale 1:2"
  double millimetres;     ///< on paper, of a unit of the view plane
  double picture_height;  ///< in mm
};

/// The window, around the middle of `shown`, that a viewport has at this scale in pictures with
/// this aspect ratio. Throws Error, beginning with the scale's name, for a projection that is not
/// parallel, or if what is shown does not fit: by how much.
Rectangle window_at_scale(const ExactScale& scale, View::Projection projection,
                          const Rectangle& shown, const Rectangle& viewport, double aspect);

}  // namespace displayfile
