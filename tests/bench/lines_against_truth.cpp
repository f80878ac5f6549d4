// How wrong the lines are that methods find of meshes: points on every drawn line, judged by exact
// arithmetic by all polygons that may cover them (interp/truth/true_lines.md).
//   lines_against_truth MESH... [--samples 1000000]
// Each mesh is seen from a general direction, in perspective and in parallel, and along its axes,
// whole or cut by the window.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "interp/truth/judged_lines.h"
#include "programs/inputs.h"
#include "tests/bench/command_line.h"
#include "tests/bench/result_table.h"

namespace displayfile::bench {
namespace {

struct Options {
  std::vector<std::string> meshes;
  std::string method = "franklin", precision = "exact";
  std::size_t samples = 1'000'000;
  int threads = 1;
};

struct Seen {
  const char* from;
  EyeDirection direction;
  bool parallel;
  bool whole = true;
};
constexpr Seen kSeen[] = {{"aside", {30.0, 20.0}, false},
                          {"aside, parallel", {30.0, 20.0}, true},
                          {"front", {0.0, 0.0}, true},
                          {"right", {90.0, 0.0}, true},
                          {"above", {0.0, 90.0}, true},
                          {"front, perspective", {0.0, 0.0}, false},
                          {"aside, cut", {200.0, 35.0}, false, false}};

DisplayFile entered(const std::string& mesh, const Seen& seen) {
  GraphicsSystem system;
  MeshOptions options;
  options.camera.eye = seen.direction;
  options.camera.parallel = seen.parallel;
  options.sides_drawn = true;
  const std::vector<std::string> inputs{mesh};
  enter_inputs(inputs, system, options);
  if (seen.whole) return system.display_file();
  const Rectangle window = system.view().window;  // the middle of it
  GraphicsSystem closer;
  const View& view = system.view();
  closer.set_view_reference_point(view.reference_point);
  closer.set_view_plane_normal(view.plane_normal);
  closer.set_view_up(view.up);
  closer.set_perspective(view.centre_of_projection);
  closer.set_view_depth(view.front, view.back);
  const auto part = [](double low, double high, double t) { return low + t * (high - low); };
  closer.set_window(part(window.x_min, window.x_max, 0.3), part(window.x_min, window.x_max, 0.7),
                    part(window.y_min, window.y_max, 0.3), part(window.y_min, window.y_max, 0.7));
  enter_inputs(inputs, closer, options);
  return closer.display_file();
}

std::vector<std::string> judged(const std::string& mesh, const Seen& seen, const Options& options) {
  const DisplayFile file = entered(mesh, seen);
  const JudgedLines judged = judged_lines(file, {.method = hidden_method(options.method),
                                                 .precision = precision(options.precision),
                                                 .samples = options.samples,
                                                 .threads = options.threads});
  const std::string name = mesh.substr(mesh.find_last_of('/') + 1);
  return {name,
          seen.from,
          std::to_string(judged.lines),
          std::to_string(judged.pieces),
          std::to_string(judged.samples),
          std::to_string(judged.wrong),
          fmt::format("{:.3g}", judged.errors.missing),
          fmt::format("{:.3g}", judged.errors.extra),
          fmt::format("{:.1f}", judged.errors.length)};
}

void run(const Options& options) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& mesh : options.meshes) {
    for (const Seen& seen : kSeen) rows.push_back(judged(mesh, seen, options));
  }
  fmt::print("Lines by {}, {}; lengths in units of the picture.\n\n{}", options.method,
             options.precision,
             text_table({"mesh", "seen from", "lines", "pieces", "points judged", "wrong",
                         "missing", "extra", "length"},
                        rows));
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  displayfile::bench::Options options;
  CLI::App app("Lines of meshes against the truth", "lines_against_truth");
  app.add_option("meshes", options.meshes, "meshes")->check(CLI::ExistingFile)->required();
  app.add_option("--method", options.method, "roberts, appel or franklin");
  app.add_option("--precision", options.precision, "exact, roundoff or roundoff=EPS");
  app.add_option("--samples", options.samples, "points of each view, at least");
  app.add_option("--threads", options.threads)->check(CLI::Range(1, 1024));
  return displayfile::bench::parsed_and_run(app, argc, argv,
                                            [&] { displayfile::bench::run(options); });
}
