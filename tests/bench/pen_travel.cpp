// Drawings for pens: strokes and lengths before and after, and the travel of the pen between its
// paths, in our order beside others'.
//   pen_travel INPUT... [--rounds 100] [--low 3 --high 6]
// Each input is drawn as it is said in tests/bench/README.md. Prints counts, lengths and ratios.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "clip/unit.h"
#include "displayfile/sorted_display_file.h"
#include "interp/vector/pens/pen_drawing.h"
#include "interp/vector/pens/pen_files.h"
#include "interp/vector/pens/pen_order.h"
#include "interp/vector/pens/point_tree.h"
#include "interp/vector/pens/unique_strokes.h"
#include "programs/bench/growth.h"
#include "programs/bench/timing.h"
#include "programs/inputs.h"
#include "programs/scenes/random.h"
#include "tests/bench/command_line.h"
#include "tests/bench/result_table.h"
#include "tests/bench/travel_bound.h"

namespace displayfile::bench {
namespace {

struct Options {
  std::vector<std::string> inputs;
  std::string pictures;      ///< a folder for the drawings as SVG; empty: none
  int rounds = 100;          ///< of the lower bound
  std::size_t most = 6'000;  ///< points for which it is sought
  int low = 3, high = 6;     ///< of the numbers of paths of growth, powers of ten
};

/// What vpype's `linesort` does by default, from its documentation: it begins with the first line,
/// and goes on always to the line that starts or, drawn backward, ends nearest to where the one
/// before ended. Closed paths are lines like others, from where they start.
std::vector<PenPath> sorted_greedily(const std::vector<PenPath>& paths) {
  std::vector<SheetPoint> ends;
  for (const PenPath& path : paths) {
    ends.push_back(path.points.front());
    ends.push_back(path.closed ? path.points.front() : path.points.back());
  }
  PointTree tree(ends);
  std::vector<PenPath> sorted;
  for (std::uint32_t next = 0; next != PointTree::kNone;) {
    tree.remove(next);
    tree.remove(next ^ 1u);
    sorted.push_back(paths[next / 2]);
    if (next % 2 == 1 && !sorted.back().closed) std::ranges::reverse(sorted.back().points);
    next = tree.nearest(ends[next ^ 1u]);
  }
  return sorted;
}

struct Drawn {
  std::string name;
  std::vector<PenStrokes> strokes;
};

/// An input as lines of these kinds, or hatched: by a sort, whose fills cover each other.
Drawn drawn(const std::string& input, const std::string& lines, bool hatched) {
  GraphicsSystem system;
  MeshWords words;
  if (!is_drawing_program(input)) words.lines = line_selection(lines);
  const std::vector<std::string> inputs{input};
  const HiddenMethod method = hatched ? HiddenMethod::depth_sort : HiddenMethod::franklin;
  enter_inputs(inputs, system, words, 1.0, {.method = method});
  SortedDisplayFile sorted;
  const DisplayFile& file = sorted.update(system, method, {.method = method});
  Pens pens;
  if (hatched) pens.hatching.emplace();
  std::vector<PenStrokes> strokes = pen_strokes(file, 512, 512, Paper{}, pens);
  if (hatched) strokes = {std::move(strokes.back())};  // the sides are not hidden
  const std::string name = input.substr(input.find_last_of('/') + 1);
  return {name + ", " +
              (hatched                     ? "hatched"
               : is_drawing_program(input) ? "lines"
                                           : lines),
          std::move(strokes)};
}

double length_of_all(std::span<const Stroke> strokes) {
  double sum = 0.0;
  for (const Stroke& s : strokes) {
    sum += std::sqrt(static_cast<double>(squared_distance(s.from, s.to)));
  }
  return sum;
}

std::vector<std::string> row_of(const Drawn& drawing, const Options& options) {
  std::size_t strokes = 0, left = 0, paths = 0;
  PenDrawing picture{fit_on_paper(Paper{}, 512, 512), {}};
  double before = 0.0, after = 0.0, as_found = 0.0, greedy = 0.0, ours = 0.0, bound = 0.0;
  bool bounded = true;
  for (const PenStrokes& of_pen : drawing.strokes) {
    strokes += of_pen.strokes.size();
    before += length_of_all(of_pen.strokes);
    const std::vector<Stroke> unique = unique_strokes(of_pen.strokes);
    left += unique.size();
    std::vector<PenPath> chains = stroke_chains(unique);
    paths += chains.size();
    for (const PenPath& path : chains) after += length_of(path);
    as_found += travel(chains);
    greedy += travel(sorted_greedily(chains));
    std::size_t points = 0;
    for (const PenPath& p : chains) points += p.closed ? p.points.size() : 2;
    bounded = bounded && points <= options.most;
    if (bounded) bound += travel_bound(chains, options.rounds);
    order_for_pen(chains);
    ours += travel(chains);
    picture.layers.push_back({of_pen.pen, std::move(chains)});
  }
  if (!options.pictures.empty()) {
    write_pens_svg(picture, options.pictures + "/" + drawing.name + ".svg");
  }
  constexpr double kMetre = 1e6;
  return {drawing.name,
          std::to_string(strokes),
          std::to_string(left),
          std::to_string(paths),
          fmt::format("{:.3f}", before / kMetre),
          fmt::format("{:.3f}", after / kMetre),
          fmt::format("{:.3f}", as_found / kMetre),
          fmt::format("{:.3f}", greedy / kMetre),
          fmt::format("{:.3f}", ours / kMetre),
          fmt::format("{:.3f}", ours / greedy),
          bounded ? fmt::format("{:.3f}", ours / bound) : "-"};
}

/// Short strokes anywhere on a sheet that grows with their number.
std::vector<PenPath> strewn(std::size_t n) {
  Random random(18);
  const double side = 1000.0 * std::sqrt(static_cast<double>(n));
  const auto unit = [&](double low, double high) {
    return static_cast<std::int32_t>(std::lround(random.between(low, high)));
  };
  std::vector<PenPath> paths;
  for (std::size_t k = 0; k < n; ++k) {
    const SheetPoint p{unit(0.0, side), unit(0.0, side)};
    paths.push_back({{p, {p.x + unit(-500.0, 500.0), p.y + unit(-500.0, 500.0)}}, false});
  }
  return paths;
}

void print_growth(const Options& options) {
  std::vector<double> sizes, ordering, joining;
  std::vector<std::vector<std::string>> rows;
  for (const std::size_t n : sizes_of_growth(options.low, options.high)) {
    const std::vector<PenPath> paths = strewn(n);
    std::vector<PenPath> ordered;
    sizes.push_back(static_cast<double>(n));
    ordering.push_back(least_seconds_each(Clock::processor, 2, [&] {
      ordered = paths;
      order_for_pen(ordered);
    }));
    std::vector<Stroke> strokes;
    for (const PenPath& path : paths) strokes.push_back({path.points[0], path.points[1]});
    joining.push_back(
        least_seconds_each(Clock::processor, 2, [&] { stroke_chains(unique_strokes(strokes)); }));
    const std::vector<PenPath> greedy = sorted_greedily(paths);
    rows.push_back(
        {std::to_string(n), fmt::format("{:.3f}", travel(ordered) / travel(greedy)),
         fmt::format("{:.2f}", ordering.back() / ordering.front() / (sizes.back() / sizes.front())),
         fmt::format("{:.2f}", joining.back() / joining.front() / (sizes.back() / sizes.front()))});
  }
  fmt::print(
      "\nStrewn strokes: growth\n\n{}\nExponents: {:.2f} of ordering, {:.2f} of finding what is "
      "drawn twice and joining\n",
      text_table({"strokes", "ours / greedy", "ordering, each, in that of the fewest",
                  "joining, likewise"},
                 rows),
      fitted_exponent(sizes, ordering), fitted_exponent(sizes, joining));
}

void run(const Options& options) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& input : options.inputs) {
    if (is_drawing_program(input)) {
      rows.push_back(row_of(drawn(input, "", false), options));
    } else {
      rows.push_back(row_of(drawn(input, "outline,crease", false), options));
      rows.push_back(row_of(drawn(input, "all", false), options));
    }
    rows.push_back(row_of(drawn(input, "outline,crease", true), options));
  }
  fmt::print("On A4, lengths in metres.\n\n{}",
             text_table({"drawing", "strokes", "drawn once", "paths", "length", "drawn once",
                         "travel as found", "greedy", "ours", "ours / greedy", "ours / bound"},
                        rows));
  if (options.high > options.low) print_growth(options);
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  displayfile::bench::Options options;
  CLI::App app("Drawings for pens", "pen_travel");
  app.add_option("inputs", options.inputs, "meshes and drawing programs")->check(CLI::ExistingFile);
  app.add_option("--rounds", options.rounds, "of the lower bound")->check(CLI::Range(1, 10'000));
  app.add_option("--pictures", options.pictures, "a folder for the drawings as SVG");
  app.add_option("--most", options.most, "points of paths for which the bound is sought");
  app.add_option("--low", options.low, "growth from 10^this")->check(CLI::Range(1, 7));
  app.add_option("--high", options.high, "growth to 10^this; no more than --low: none")
      ->check(CLI::Range(1, 7));
  return displayfile::bench::parsed_and_run(app, argc, argv,
                                            [&] { displayfile::bench::run(options); });
}
