#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "interp/draw/draw.h"
#include "programs/command/turntable_command.h"
#include "programs/inputs/input_names.h"
#include "programs/inputs/made_folders.h"
#include "programs/inputs/not_in_picture.h"
#include "programs/options/background_option.h"
#include "programs/options/hidden_surface_words.h"
#include "programs/options/mesh_words.h"
#include "programs/options/paper_options.h"
#include "programs/options/pick_option.h"
#include "programs/options/picture_size.h"
#include "programs/options/shading_word.h"
#include "programs/options/vector_words.h"

namespace displayfile {

class DrawnAgain;

/// `displayfile draw`. Like the other subcommands it adds itself to the command line, and run()
/// returns the exit status, 0 or 1 (a difference was found), or throws Error, with nothing written,
/// if its input, an option or an output is wrong.
struct DrawCommand {
  std::vector<std::string> inputs;
  std::string with;     ///< a drawing program before each input, or before all of one picture
  std::string output;   ///< with fields (programs/inputs/output_name.h): a picture of each input
  DrawOptions options;  ///< except options kept as words
  PictureSizeWord size;
  HiddenSurfaceWords hidden_surfaces;
  BackgroundWord background;
  PaperWords paper;
  VectorWords vectors;
  ShadingWord shading;  ///< that the inputs start with
  MeshWords meshes;
  bool stats = false;
  bool quiet = false;                     ///< no warnings; inputs not drawn are listed at the end
  bool check = false;                     ///< compares with the files that are there
  bool explain = false;                   ///< the choice of `auto`, and the reason
  std::optional<std::string> line_width;  ///< in words (programs/options/line_words.h)
  std::optional<std::string> line_order;  ///< entry or depth
  std::optional<std::string> halo;        ///< in words, as line_width
  std::optional<std::string> explode;     ///< in words (programs/options/explosion.h)
  std::optional<std::string> pick;        ///< where (programs/options/pick_option.h)
  std::optional<std::string> turntable;  ///< number of views (programs/command/turntable_command.h)
  std::optional<std::string> views;      ///< which of them
  std::optional<std::string> rows;       ///< which of the picture
  std::optional<std::string> scale;      ///< PAPER:SCENE (programs/sheet/drawing_scale.h)
  std::string unit;                      ///< of the scene, for the scale; empty: mm

  CLI::App& add_to(CLI::App& app);
  int run();

 private:
  struct Outputs {
    std::filesystem::path picture, ids, depth;  ///< empty: not requested
  };

  void add_output_options(CLI::App& command);
  void add_picture_options(CLI::App& command);
  DrawOptions all_options();
  MeshWords entering(const DrawOptions& drawing) const;
  StartingShading starting_shading() const;
  std::optional<ExactScale> exact_scale(const DrawOptions& drawing) const;
  void fit_to_all(const DrawOptions& drawing);
  TurntableViews views_drawn() const;
  /// Draws inputs, and makes the folders of outputs, if any are to be made, once all inputs are
  /// read. Returns the text of the printing options.
  std::string draw_into(std::span<const std::string> drawn, const std::filesystem::path& file,
                        const DrawOptions& drawing, MadeFolders* folders,
                        NotInPicture& left_out) const;
  std::vector<std::string> files_written(const std::filesystem::path& file) const;
  std::vector<Outputs> outputs_of_each(const DrawOptions& drawing) const;
  int draw_each(const DrawOptions& drawing, NotInPicture& left_out) const;
  /// Draws the one picture. Returns the text of the printing options.
  std::string draw_one(const DrawOptions& drawing, NotInPicture& left_out) const;
  /// Draws it to compare, and prints what differs.
  int check_one(const DrawOptions& drawing, NotInPicture& left_out) const;
  static Outputs placed(const DrawnAgain& again, std::size_t k, const Outputs& there);
  /// A line for each file that differs from the one drawn anew.
  std::string differences(const DrawnAgain& again, const Outputs& there,
                          const Outputs& drawn) const;

  std::vector<Figure> figures_;     ///< of each picture, with their common program
  std::vector<std::string> lists_;  ///< of inputs, as files (input_lists)
  // Read once from the words, all before any work is done.
  bool takes_papers_shape_ = false;
  MeshWords entering_;
  StartingShading starts_with_;
  TurntableViews views_drawn_;
};

}  // namespace displayfile
