#pragma once

#include <CLI/App.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "interp/draw/draw.h"
#include "programs/options/hidden_surface_words.h"
#include "programs/options/mesh_words.h"
#include "programs/options/picture_size.h"
#include "programs/options/shading_word.h"
#include "programs/page/one_file_page.h"

namespace displayfile {

/// `displayfile page`: writes a scene, or the project's page with the gallery, as one file for a
/// browser, also from disk, with its renderer (programs/page/README.md). Structured as DrawCommand.
struct PageCommand {
  std::vector<std::string> inputs;  ///< none: the product's page
  std::string output, title, package;
  PictureSizeWord size;
  HiddenSurfaceWords hidden_surfaces;
  ShadingWord shading;
  MeshWords meshes;

  CLI::App& add_to(CLI::App& app);
  int run();

 private:
  DrawOptions drawing() const;
  StartingShading starting_shading() const;
  /// Adds the entries that every drawing page has in `data`.
  PageContents product(nlohmann::ordered_json data, const PageFiles& files) const;
  PageContents scene(nlohmann::ordered_json data, DrawOptions options) const;
};

}  // namespace displayfile
