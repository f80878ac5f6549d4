// Drawings for pens: strokes and lengths before and after, and the travel of the pen between its
// paths, in our order beside a greedy one's. Each input is drawn as tests/bench/README.md
// describes. For drawings with few enough points (--polygons), also prints the paths of each layer,
// for a lower bound (tests/bench/pen-travel). Growth with --low and --high, on strewn strokes.

#include <algorithm>
#include <cmath>

#include "clip/geometry/unit.h"
#include "displayfile/segments/sorted_display_file.h"
#include "interp/vector/pens/pen_drawing.h"
#include "interp/vector/pens/pen_order.h"
#include "interp/vector/pens/point_tree.h"
#include "interp/vector/pens/unique_strokes.h"
#include "programs/inputs/inputs.h"
#include "programs/scenes/random.h"
#include "tests/bench/benchmark.h"
#include "tests/bench/command/timing.h"

namespace displayfile::bench {

const char* const kAbout = "Drawings for pens: strokes, lengths, travel";

namespace {

constexpr double kMetre = 1e6;

/// The default of vpype's `linesort`, from its documentation: it begins with the first line and
/// always continues with the line that starts or, drawn backward, ends nearest to where the one
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

/// An input as lines of these kinds, or hatched: the latter by a sort, whose fills cover each
/// other.
std::vector<PenStrokes> drawn(const std::string& input, const std::string& lines, bool hatched) {
  GraphicsSystem system;
  MeshWords words;
  if (!is_drawing_program(input)) words.lines = line_selection(lines);
  const HiddenMethod method = hatched ? HiddenMethod::depth_sort : HiddenMethod::franklin;
  enter_inputs(std::span(&input, 1), system, words, 1.0, {.method = method});
  SortedDisplayFile sorted;
  const DisplayFile& file = sorted.update(system, method, {.method = method});
  Pens pens;
  if (hatched) pens.hatching.emplace();
  std::vector<PenStrokes> strokes = pen_strokes(file, 512, 512, Paper{}, pens);
  if (hatched) strokes = {std::move(strokes.back())};  // the sides are not hidden
  return strokes;
}

void measure(const std::string& input, const std::string& lines, bool hatched,
             const Options& options) {
  std::size_t strokes = 0, left = 0, paths = 0, points = 0;
  double before = 0.0, after = 0.0, as_found = 0.0, greedy = 0.0, ours = 0.0;
  Json layers = Json::array();
  for (const PenStrokes& of_pen : drawn(input, lines, hatched)) {
    for (const Stroke& s : of_pen.strokes) {
      before += std::sqrt(static_cast<double>(squared_distance(s.from, s.to)));
    }
    const std::vector<Stroke> unique = unique_strokes(of_pen.strokes);
    std::vector<PenPath> chains = stroke_chains(unique);
    strokes += of_pen.strokes.size();
    left += unique.size();
    paths += chains.size();
    as_found += travel(chains);
    greedy += travel(sorted_greedily(chains));
    Json layer = Json::array();
    for (const PenPath& path : chains) {
      after += length_of(path);
      points += path.closed ? path.points.size() : 2;
      Json of_path = Json::array();
      for (const SheetPoint& p : path.points) of_path.push_back({p.x, p.y});
      layer.push_back({{"closed", path.closed}, {"points", std::move(of_path)}});
    }
    order_for_pen(chains);
    ours += travel(chains);
    layers.push_back(std::move(layer));
  }
  const auto metres = [](double length) { return figure(length / kMetre); };
  print_row({{"table", "on A4, lengths in metres"},
             {"drawing", input.substr(input.find_last_of('/') + 1) + ", " +
                             (hatched         ? "hatched"
                              : lines.empty() ? "lines"
                                              : lines)},
             {"strokes", strokes},
             {"strokes drawn once", left},
             {"paths", paths},
             {"length", metres(before)},
             {"length drawn once", metres(after)},
             {"travel as found", metres(as_found)},
             {"greedy", metres(greedy)},
             {"ours", metres(ours)},
             {"ours / greedy", figure(ours / greedy)},
             {"layers", points <= options.polygons ? layers : Json()}});
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

void print_growth(std::size_t n) {
  const std::vector<PenPath> paths = strewn(n);
  std::vector<PenPath> ordered;
  std::vector<Stroke> strokes;
  strokes.reserve(n);
  for (const PenPath& path : paths) strokes.push_back({path.points[0], path.points[1]});
  const auto print = [&](const char* way, const auto& work) {
    const double least = least_seconds_each(Clock::processor, 2, work);
    Json row{{"table", "strewn strokes, growth"}, {"scene", "strewn"}, {"way", way}, {"n", n}};
    row["seconds"] = least;
    if (!ordered.empty()) {
      row["ours / greedy"] = figure(travel(ordered) / travel(sorted_greedily(paths)));
    }
    print_row(row);
  };
  print("finding what is drawn twice and joining", [&] { stroke_chains(unique_strokes(strokes)); });
  print("ordering", [&] {
    ordered = paths;
    order_for_pen(ordered);
  });
}

}  // namespace

void run(const Options& options) {
  for (const std::string& input : options.inputs) {
    if (is_drawing_program(input)) {
      measure(input, "", false, options);
    } else {
      measure(input, "outline,crease", false, options);
      measure(input, "all", false, options);
    }
    measure(input, "outline,crease", true, options);
  }
  for (const std::size_t n : options.sizes()) print_growth(n);
}

}  // namespace displayfile::bench
