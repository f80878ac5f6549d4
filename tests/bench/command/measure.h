#pragma once

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>

#include "tests/bench/command/bench_scene.h"
#include "tests/bench/command/contenders.h"
#include "tests/bench/command/report.h"
#include "tests/bench/command/timing.h"

namespace displayfile::bench {

/// Does the work once more, and counts its memory and its calls of the predicates' exact stage.
void count_memory_and_exact_calls(const std::function<void()>& work, Json& cell);

/// Measures one scene after another.
class Measurer {
 public:
  Measurer();
  ~Measurer();

  /// The scene that is measured from now on, with its truth. Scenes of a name grow from the first.
  void take(const BenchScene& scene, const Effort& effort);
  std::size_t polygons() const;
  /// The reference's time here over its time on the first scene of the same name.
  Json growth();

  Json measure(const Contender& contender, int threads);
  /// The time of a cell that was measured, a while later; nothing if it is long enough that no
  /// pause of the machine's can fall on all of its rounds.
  std::optional<Json> time_again(const Contender& contender, const Json& cell);

 private:
  struct Scene;
  /// Throws CannotDraw as the contender does.
  void measure(const Contender& contender, Json& cell);
  bool too_long(const Json& cell) const;
  void remember(const Json& cell);
  void compare(const Picture& picture, Json& cell) const;

  Effort effort_;
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<Scene> first_;  ///< of the same name
  /// Seconds of the first picture, by method, precision and threads: the most and the least so far
  /// of the same name.
  struct Longest {
    double seconds = 0.0, least_seconds = std::numeric_limits<double>::infinity();
    double polygons = 1.0, pixels = 1.0;
  };
  std::map<std::string, Longest> longest_;
};

}  // namespace displayfile::bench
