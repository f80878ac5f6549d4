#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "programs/options/background_option.h"
#include "programs/options/camera_options.h"
#include "programs/options/hidden_surface_words.h"
#include "programs/options/paper_options.h"
#include "programs/options/picture_size.h"
#include "programs/options/vector_words.h"
#include "programs/surface/surface_scene.h"

namespace displayfile {

/// `displayfile surface`: pictures of surfaces z = F(x, y).
struct SurfaceCommand {
  std::vector<std::string> surfaces;
  std::string output, program;
  std::string x, y, z, grid, curves = "both", sides = "both", colour, labels;
  int contours = 0;
  std::optional<int> samples;
  std::optional<std::string> line_width, text_size;
  bool axes = true, box = true, true_scale = false;
  CameraWords camera;
  HiddenSurfaceWords hidden_surfaces;
  PictureSizeWord size{"640x480"};
  BackgroundWord background;
  VectorWords vectors;
  PaperWords paper;

  CLI::App& add_to(CLI::App& app);
  int run() const;

 private:
  GridRange range() const;
  SurfaceLook look(const DrawOptions& drawing) const;
  DrawOptions drawing() const;
};

}  // namespace displayfile
