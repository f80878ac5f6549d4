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

/// The options of commands that enter meshes, as words: those of the camera, the colour, and what
/// the import library may take.
struct MeshWords : CameraWords {
  std::string colour;
  ImportWords import;
  std::optional<LineSelection> lines;    ///< no option: what --lines selects of all inputs
  std::optional<double> line_width;      ///< no option: that of --line-width, in pixels
  std::vector<StyleOfKind> line_styles;  ///< no option: those that --lines sets
  /// No option: what --touching sets of all inputs.
  std::optional<Touching> touching;
  /// No option: the lines of meshes, where neither --lines nor a program selects any.
  std::optional<LineSelection> lines_of_meshes;
  std::optional<Explosion> explosion;         ///< no option: what --explode sets of all inputs
  std::optional<ExactScale> scale;            ///< no option: that of --scale
  std::shared_ptr<const ViewOfAll> together;  ///< no option: the view of --fit all

  /// `many`: the command draws a picture of each of many inputs.
  void add_to(CLI::App& command, bool many = false);
  /// Throws Error for a word that is not understood.
  MeshOptions options() const;
  /// What the inputs start with.
  void start(GraphicsSystem& system, double aspect) const;
};

}  // namespace displayfile
