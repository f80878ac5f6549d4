#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "clip/view.h"
#include "displayfile/segments/display_file.h"

namespace displayfile {

class WorldRays;

/// A retained scene in its views, drawn by draw (interp/draw/draw.h) like a display file:
/// visibility is found by rays in world coordinates.
struct ViewedWorld {
  /// Data of a primitive that is an item of the viewed scene (displayfile/segments/viewed_scene.h).
  struct Source {
    static constexpr std::uint32_t kNotSeen = ~std::uint32_t{0};
    std::uint32_t item = kNotSeen;
    std::uint32_t view = 0;  ///< index into views
  };
  DisplayFile display_file;     ///< as if the application had drawn it there
  std::vector<View> views;      ///< one, or those of the segments
  std::vector<Source> sources;  ///< of the primitives
  std::shared_ptr<const WorldRays> rays;
};

}  // namespace displayfile
