#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/bench/command/bench_scene.h"

namespace displayfile {

/// `displayfile bench`: speed against error, as rows of text, JSON and a page
/// (tests/bench/command/bench.md).
struct BenchCommand {
  bench::SceneChoice scenes;
  std::vector<std::string> methods;    ///< only these; all if empty
  std::vector<std::string> roundoffs;  ///< beside exact; the usual ones if empty
  std::vector<int> threads;            ///< the usual ones if empty
  int rounds = 0;                      ///< of a ratio; 0: the usual number
  double most_seconds = 0.0;           ///< of a cell's ratio; 0: the usual
  std::string page = "report.html";
  std::string json;  ///< not written if empty
  /// True if the costs of features are measured; not set: with the default scenes.
  std::optional<bool> features;
  bool moving_camera = false;  ///< only new views of retained scenes, no method by itself
  bool features_under_callgrind =
      false;  ///< only makes the drawings that callgrind counts, for `features`

  std::string beside;  ///< only makes the comparisons of this task (tests/bench/command/beside.h)

  /// 1 if a method that claims to be exact has a wrong pixel, or missing or extra length. Throws
  /// Error as the other commands.
  int run() const;
};

namespace bench {
/// Those that --methods takes, of pixels and of lines.
std::vector<std::string> method_names();
}  // namespace bench

}  // namespace displayfile
