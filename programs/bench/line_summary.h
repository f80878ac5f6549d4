#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "programs/bench/analysis.h"
#include "programs/bench/report.h"
#include "programs/bench/summary.h"

namespace displayfile::bench {

/// Lengths over several scenes, in units of their pictures.
struct WrongLength {
  double length = 0.0, missing = 0.0, extra = 0.0;
  double percent() const { return length == 0.0 ? 0.0 : 100.0 * (missing + extra) / length; }
};

/// A method of lines between speed and error, on one thread.
struct LineMethod {
  Column column;
  std::optional<double> time;  ///< mean, in times of kLineReference; of what is told in LineMethods
  WrongLength hard_cases, scenes;
  /// What the plot shows: of the hard cases, or of the scenes if there are none.
  double percent() const {
    return hard_cases.length > 0.0 ? hard_cases.percent() : scenes.percent();
  }
};

/// Scenes that methods of lines are told apart of: those that all of them draw, and surfaces, which
/// methods that draw nothing else draw too.
enum class LineScenes { any, surfaces };

/// All methods of lines that were measured on such scenes.
struct LineMethods {
  std::vector<LineMethod> all;
  /// Times are geometric means over these: the most polygons of each name on which no method was
  /// left out; if there is none, hard cases.
  std::vector<const SceneRow*> timed;
};
LineMethods line_methods(const Report& report, LineScenes scenes);

/// How the time of an exact method grows with the polygons of a generated scene.
struct LineFit {
  std::string scene, method;
  std::size_t points;
  double exponent;
};
std::vector<LineFit> line_fits(const Report& report, LineScenes scenes);

/// The table of methods of lines, and that of their lines of surfaces. Nothing if none was
/// measured.
std::optional<Summary> hidden_lines(const Report& report);
std::optional<Summary> hidden_lines_of_surfaces(const Report& report);

}  // namespace displayfile::bench
