#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "interp/draw.h"
#include "programs/hidden_surface_words.h"
#include "programs/mesh_words.h"
#include "programs/picture_size.h"
#include "programs/shading_word.h"

namespace displayfile {

/// `displayfile draw`. Like the other subcommands it adds itself to the command line, and run()
/// returns the exit status, 0 or 1 (a difference was found), or throws Error, with nothing written,
/// if its input, an option or an output is wrong.
struct DrawCommand {
  std::vector<std::string> inputs;
  std::string output;
  DrawOptions options;  ///< but for what is words
  PictureSizeWord size;
  HiddenSurfaceWords hidden_surfaces;
  ShadingWord shading;  ///< that the inputs start with
  MeshWords meshes;
  bool stats = false;
  bool explain = false;                  ///< what `auto` picked, and why
  std::optional<std::string> turntable;  ///< so many views of it (programs/turntable_command.h)

  CLI::App& add_to(CLI::App& app);
  int run() const;

 private:
  DrawOptions all_options() const;
};

}  // namespace displayfile
