#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <string>
#include <vector>

#include "programs/inputs/golden_check.h"
#include "programs/options/hidden_surface_words.h"
#include "programs/options/mesh_words.h"
#include "programs/options/picture_size.h"

namespace displayfile {

/// `displayfile check`: compares inputs with golden files, by the instructions of their segments in
/// drawing order. It draws nothing, except for another kind of check.
struct CheckCommand {
  std::vector<std::string> inputs;
  std::string with;  ///< a drawing program before each input, and before one reference of all
  HiddenSurfaceWords hidden_surfaces;
  PictureSizeWord size{""};  ///< of the pictures, or of those that windows are made for
  MeshWords meshes;
  /// A folder, or one file for all inputs. In a folder the golden file of FOLDER/NAME.draw is
  /// FOLDER/NAME.txt if it is there or another of the inputs has that name; otherwise NAME.txt.
  std::string golden;
  bool update = false;
  bool summary = false;
  bool quiet = false;  ///< report only inputs that do not pass, at the end
  /// Replaces the check of instructions, if selected.
  std::shared_ptr<GoldenCheckOption> other = nullptr;

  CLI::App& add_to(CLI::App& app);
  int run();  ///< 2 if an input is invalid, otherwise 1 if one differs

 private:
  bool is_one_file() const;
  std::vector<std::string> golden_files(std::string_view extension) const;
};

}  // namespace displayfile
