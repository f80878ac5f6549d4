#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clip/surfaces.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/views/picture_windows.h"
#include "programs/options/camera_options.h"
#include "programs/options/explosion.h"
#include "programs/options/import_words.h"
#include "programs/options/line_words.h"

namespace displayfile {

struct ViewOfAll;  // programs/inputs/inputs.h

/// The options of commands that enter meshes, as words: the camera, the colour and the import
/// library's limits.
struct MeshWords : CameraWords {
  std::string colour;
  ImportWords import;
  std::optional<LineSelection> lines;    ///< not an option: the selection of --lines for all inputs
  std::optional<double> line_width;      ///< not an option: that of --line-width, in pixels
  std::vector<StyleOfKind> line_styles;  ///< not an option: those of --lines
  /// Not an option: the value of --touching for all inputs.
  std::optional<Touching> touching;
  /// Not an option: the lines of meshes, where neither --lines nor a program selects any.
  std::optional<LineSelection> lines_of_meshes;
  std::optional<Explosion> explosion;  ///< not an option: the value of --explode for all inputs
  std::optional<ExactScale> scale;     ///< not an option: that of --scale
  std::shared_ptr<const ViewOfAll> together;  ///< not an option: the view of --fit all

  /// `many`: the command draws a picture of each of many inputs.
  void add_to(CLI::App& command, bool many = false);
  /// Throws Error for a word that is not understood.
  MeshOptions options() const;
  /// Sets the state in which the inputs are entered.
  void start(GraphicsSystem& system, double aspect) const;
};

}  // namespace displayfile
