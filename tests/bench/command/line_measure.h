#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "clip/surfaces.h"
#include "tests/bench/command/bench_scene.h"
#include "tests/bench/command/report.h"
#include "tests/bench/command/timing.h"

namespace displayfile::bench {

/// A method that finds lines, at one precision.
struct LineContender {
  HiddenMethod method;
  Precision precision;

  std::string method_name() const { return std::string(name_of(method)); }
  std::string precision_name() const;
};

/// Every such method of this build, exact and with each ROUNDOFF.
std::vector<LineContender> line_contenders(std::span<const double> roundoffs);
/// False if the method draws only surfaces, and the scene is not one.
bool draws(const LineContender& contender, const BenchScene& scene);

/// The unit of all times of lines: Franklin's method, exact, on one thread.
inline constexpr const char* kLineReference = "franklin, exact, 1 thread";

/// Measures methods of lines on one scene after another: the visible parts of all sides of
/// polygons, whatever their style, and of all lines; against the truth (interp/truth/true_lines.h).
class LineMeasurer {
 public:
  LineMeasurer();
  ~LineMeasurer();

  /// Sets the scene to be measured, with its truth, which is found on `threads` threads. Scenes of
  /// a name grow from the first.
  void take(const BenchScene& scene, const Effort& effort, int threads);
  /// The reference's time here over its time on the first scene of the same name.
  Json growth();
  Json measure(const LineContender& contender, int threads);

 private:
  struct Scene;
  struct Longest {
    double seconds, lines;
  };
  bool too_long(const std::string& contender) const;
  void measure(const LineContender& contender, const std::string& name, Json& cell);

  Effort effort_;
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<Scene> first_;                          // of the same name
  std::vector<std::pair<std::string, Longest>> longest_;  // of each contender, of the same name
};

}  // namespace displayfile::bench
