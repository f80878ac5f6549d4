#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "clip/view.h"
#include "displayfile/segments/display_file.h"

namespace displayfile {

class WorldRays;

/// A retained scene in its views, to be drawn by draw (interp/draw/draw.h) as a display file is:
/// what is seen is found by rays cast in world coordinates.
struct ViewedWorld {
  /// What is noted of a primitive that is an item of the viewed scene
  /// (displayfile/segments/viewed_scene.h).
  struct Source {
    static constexpr std::uint32_t kNotSeen = ~std::uint32_t{0};
    std::uint32_t item = kNotSeen;
    std::uint32_t view = 0;  ///< its number
  };
  DisplayFile display_file;     ///< as if the application had drawn it there
  std::vector<View> views;      ///< one, or those that the segments were drawn in
  std::vector<Source> sources;  ///< of the primitives
  std::shared_ptr<const WorldRays> rays;
};

}  // namespace displayfile
