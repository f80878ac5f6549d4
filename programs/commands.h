#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interp/draw.h"
#include "programs/pick_option.h"

namespace displayfile {

// The subcommands of `displayfile`. Each returns the exit status, 0 or 1 (a difference was
// found), and throws Error, with nothing written, if its input or an output is wrong.

struct DrawCommand {
  std::vector<std::string> inputs;
  std::string output;
  DrawOptions options;
  bool stats = false;
  bool explain = false;             ///< what `auto` picked, and why
  Shading shading = Shading::flat;  ///< that the inputs start with
  std::optional<PickOption> pick;   ///< what is seen there
  std::optional<int> turntable;     ///< so many views of it (programs/turntable_command.h)
  int run() const;
};

struct TruthCommand {
  std::vector<std::string> inputs;
  int width = 512, height = 512;
  std::string ids;
  std::string depth;  ///< not written if empty
  int run() const;
};

struct CompareCommand {
  std::string a, b;
  std::string marks;  ///< picture of the wrong pixels; not written if empty
  int run() const;
};

struct ImportCommand {
  std::vector<std::string> meshes;
  Shading shading = Shading::flat;  ///< gouraud: with normals of vertices
  std::string output;
  int run() const;
};

}  // namespace displayfile
