#pragma once

#include <CLI/App.hpp>
#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "interp/device/picture.h"
#include "interp/truth/judged_lines.h"
#include "programs/options/mesh_words.h"
#include "programs/options/picture_size.h"

namespace displayfile {

/// `displayfile truth`: computes the exact item buffer, from display-file, world or entered
/// coordinates; and the visible parts of the display file's lines, and the errors of a method of
/// lines.
struct TruthCommand {
  std::vector<std::string> inputs;
  PictureSizeWord size;
  MeshWords meshes;
  std::string ids;    ///< not written if empty
  std::string depth;  ///< not written if empty

  std::string from;

  std::string seen_lines;  ///< not written if empty
  std::string hidden;      ///< a method of lines that is judged, if not empty
  SurfacePlan judged{.method = HiddenMethod::franklin};  ///< by which method, and how
  std::size_t line_samples = 0;                          ///< whole lines are compared if 0

  CLI::App& add_to(CLI::App& app);
  int run();

 private:
  /// The source of the item buffer.
  enum class From { display_file, world, entered };
  From judged_from() const;
  bool wants_lines() const { return !seen_lines.empty() || !hidden.empty(); }
  HiddenMethod judged_method() const;
  std::ostream& reports() const;
  void write_seen_lines(const DisplayFile& file, std::ostream& to) const;
  int judge_lines(const DisplayFile& file, std::string& report) const;
  Picture true_picture(const GraphicsSystem& system, const RetainedScene& retained,
                       From judged_from, std::string& report) const;
};

}  // namespace displayfile
