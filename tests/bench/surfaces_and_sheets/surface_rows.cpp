// Surfaces: the whole command beside gnuplot's hidden3d, growth, the bytes of the pictures; and the
// perimeter method, exact and as an array of columns, beside the truth and beside Franklin's.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/scene_lines.h"
#include "interp/truth/judged_lines.h"
#include "programs/bench/growth.h"
#include "programs/bench/temporary_folder.h"
#include "programs/bench/timing.h"
#include "programs/scenes/random.h"
#include "tests/bench/surfaces_and_sheets/rows.h"

namespace displayfile::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFunction = "0.5*sin(x*2)*cos(y*2)";

std::vector<std::string> our_command(int points, const std::string& output) {
  return {DISPLAYFILE_COMMAND,
          "surface",
          kFunction,
          "--x=-3:3",
          "--y=-3:3",
          fmt::format("--grid={0}x{0}", points),
          "--eye=30,30",
          "--parallel",
          "-o",
          output};
}

/// The same function, as many points, the same parallel view, axes with numbers on both sides. The
/// surface is a wire that hides itself, both sides in one style (offset 0), as ours has them: of
/// the options of hidden3d the documented ones change its time by less than it varies.
std::vector<std::string> command_of_gnuplot(int points, const std::string& output,
                                            const TemporaryFolder& folder) {
  const std::string script = folder.file("surface.gp");
  std::ofstream(script) << fmt::format(
      "set terminal svg size 640,480\nset output '{0}'\nset hidden3d offset 0\nset view 60,30\n"
      "set samples {1},{1}\nset isosamples {1},{1}\nset xrange [-3:3]\nset yrange [-3:3]\n"
      "unset key\nsplot {2} with lines\n",
      output, points, kFunction);
  return {"gnuplot", script};
}

void compare_with_gnuplot(const TableOptions& options, const TemporaryFolder& folder,
                          std::vector<Result>& results) {
  const std::string ours = folder.file("ours.svg"), others = folder.file("gnuplot.svg");
  if (!run({"gnuplot", "--version"}).succeeded) {
    results.push_back({"beside gnuplot", "100", "gnuplot is not installed", "", "", ""});
    return;
  }
  const std::string work = fmt::format("surface {0} x {0} to SVG", options.size);
  const Cost of_ours = least_cost(our_command(options.size, ours), options.rounds);
  const Cost of_gnuplot =
      least_cost(command_of_gnuplot(options.size, others, folder), options.rounds);
  const double faster = of_gnuplot.wall / of_ours.wall;
  results.push_back(
      {work, ">= 100 (goal 200)", fmt::format("{:.0f}", faster),
       fmt::format("{:.0f} in processor time", of_gnuplot.processor / of_ours.processor),
       "gnuplot hidden3d, whole process", holds_if(faster >= 100.0)});
  const double bytes =
      static_cast<double>(fs::file_size(ours)) / static_cast<double>(fs::file_size(others));
  results.push_back({"bytes of the SVG", "<= 0.25", fmt::format("{:.3f}", bytes), "", "gnuplot's",
                     holds_if(bytes <= 0.25)});
}

void measure_growth(const TableOptions& options, const TemporaryFolder& folder,
                    std::vector<Result>& results) {
  std::vector<double> cells, times;
  std::string each;
  for (const int points : {100, 200, 500, 1000, 2000}) {
    if (points > options.most) break;
    const Cost cost = least_cost(our_command(points, folder.file("growth.svg")), options.rounds);
    cells.push_back(static_cast<double>(points) * points);
    times.push_back(cost.processor);
    each += fmt::format("{}{:.2f}", each.empty() ? "" : " ",
                        times.back() / times.front() / (cells.back() / cells.front()));
  }
  const double exponent = fitted_exponent(cells, times);
  results.push_back({fmt::format("growth with cells, 100^2 to {}^2", options.most),
                     "<= 1.1 (goal 1.0)", fmt::format("{:.2f}", exponent), each,
                     "a cell, in that of the smallest", holds_if(exponent <= 1.1)});
}

/// Random heights, and heights of few values: flat cells, equal heights; views along the grid too.
DisplayFile random_surface(std::uint64_t seed) {
  Random random(seed);
  const auto from = [&](int low, int high) {
    return low + static_cast<int>(random.between(0.0, high - low + 1.0));
  };
  const int nx = from(2, 12), ny = from(2, 12), values = from(1, 4);
  const bool stepped = seed % 2 == 0;
  std::vector<double> heights(static_cast<std::size_t>(nx * ny));
  for (double& z : heights) z = stepped ? from(0, values) / 4.0 : random.between(-1.0, 1.0);
  const double azimuth = seed % 3 == 0 ? 45.0 * from(0, 7) : random.between(0.0, 360.0);
  const double elevation = seed % 5 == 0 ? 0.0 : random.between(-89.0, 89.0);
  const SineCosine a = sine_cosine_of_degrees(azimuth), e = sine_cosine_of_degrees(elevation);
  const Point3 eye{e.cosine * a.sine, -e.cosine * a.cosine, e.sine};
  GraphicsSystem g;
  g.set_view_plane_normal(-eye);
  g.set_view_up({0, 0, 1});
  if (seed % 4 < 2) {
    g.set_perspective(random.between(3.0, 8.0) * eye);
    g.set_window(-30, 30, -30, 30);
  } else {
    g.set_parallel(-eye);
    g.set_window(-4, 4, -4, 4);
  }
  g.open_segment(1);
  g.surface_3({-1, 1, nx, -1, 1, ny, heights});
  g.close_segment();
  return g.display_file();
}

void judge(const TableOptions& options, std::vector<Result>& results) {
  LineErrors exact, rounded;
  for (int seed = 0; seed < options.grids; ++seed) {
    const DisplayFile file = random_surface(static_cast<std::uint64_t>(seed));
    const auto add = [&](LineErrors& sum, const Precision& precision) {
      const JudgedLines judged =
          judged_lines(file, {.method = HiddenMethod::perimeter, .precision = precision});
      sum.missing += judged.errors.missing;
      sum.extra += judged.errors.extra;
    };
    add(exact, {});
    add(rounded, {.exact = false, .roundoff = 1e-9});
  }
  const double wrong = exact.missing + exact.extra;
  results.push_back({fmt::format("missing + extra, {} random grids", options.grids),
                     "0 but rounding", fmt::format("{:.1e}", wrong), "", "the truth's lines",
                     holds_if(wrong <= 1e-9 * options.grids)});
  results.push_back({"the same with ROUNDOFF: 1024 columns", "",
                     fmt::format("{:.1e}", rounded.missing + rounded.extra), "",
                     "the truth's lines", ""});
}

/// The perimeter method alone, on a surface of `points` each way.
void compare_methods(const TableOptions& options, std::vector<Result>& results) {
  const int points = std::min(options.size, 300);
  std::vector<double> heights;
  for (int j = 0; j < points; ++j) {
    for (int i = 0; i < points; ++i) {
      heights.push_back(0.5 * std::sin(-6.0 + 12.0 * i / (points - 1)) *
                        std::cos(-6.0 + 12.0 * j / (points - 1)));
    }
  }
  GraphicsSystem g;
  g.set_view_plane_normal({-0.43, 0.75, -0.5});
  g.set_parallel({-0.43, 0.75, -0.5});
  g.set_view_up({0, 0, 1});
  g.set_window(-5, 5, -5, 5);
  g.open_segment(1);
  g.surface_3({-3, 3, points, -3, 3, points, heights});
  g.close_segment();
  const ViewedScene scene(g.display_file());
  const auto seconds = [&](HiddenMethod method, const Precision& precision) {
    SortOptions sort;
    sort.precision = precision;
    return least_seconds_each(Clock::processor, options.rounds,
                              [&] { find_lines(scene, method, sort); });
  };
  const double exact = seconds(HiddenMethod::perimeter, {});
  const double rounded = seconds(HiddenMethod::perimeter, {.exact = false, .roundoff = 1e-9});
  const double franklin = seconds(HiddenMethod::franklin, {});
  const std::string work = fmt::format("lines of {0} x {0} found: ", points);
  results.push_back({work + "Franklin's time over the perimeter's", "",
                     fmt::format("{:.2f}", franklin / exact), "", "", ""});
  results.push_back(
      {work + "exact over ROUNDOFF", "", fmt::format("{:.2f}", exact / rounded), "", "", ""});
}

}  // namespace

void add_surface_rows(const TableOptions& options, std::vector<Result>& results) {
  const TemporaryFolder folder;
  compare_with_gnuplot(options, folder, results);
  measure_growth(options, folder, results);
  judge(options, results);
  compare_methods(options, results);
}

}  // namespace displayfile::bench
