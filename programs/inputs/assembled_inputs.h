#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/retained_scene.h"
#include "programs/inputs/planes_of_inputs.h"

namespace displayfile {

/// Inputs entered in order into one system, without a fitted view, and retained alone in world
/// coordinates.
struct AssembledInputs {
  /// Where a segment came from.
  struct Opening {
    std::size_t input;
    std::string object;  ///< the name of a mesh's object; empty: none
  };
  RetainedScene scene;
  GraphicsSystem system;
  PlanesOfInputs planes;
  std::vector<Opening> openings;  ///< of segments, in the order in which they are opened

  /// For pictures of an aspect ratio. Throws Error, naming the file and the position.
  AssembledInputs(std::span<const std::string> inputs, const ImportLimits& limits,
                  double aspect = 1.0);
  AssembledInputs(const AssembledInputs&) = delete;
  AssembledInputs& operator=(const AssembledInputs&) = delete;

  const Opening& opening(const RetainedScene::Segment& segment) const {
    return openings[segment.opened];
  }
  bool is_visible(const RetainedScene::Segment& segment) const;

 private:
  void enter(const std::string& input, std::size_t number, const ImportLimits& limits);
};

}  // namespace displayfile
