// Issue 4's table: fragments, speed and memory of the sorts in object space, side by side with
// gl2ps and Sketch where they are installed, and what each choice of a BSP root costs.
//   sort_bench [MESH...]
// Prints ratios and counts; run it on a machine that does nothing else.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "clip/error.h"
#include "displayfile/graphics_system.h"
#include "hidden/sort/hidden_surface_sort.h"
#include "programs/bench/gl2ps_sort.h"
#include "programs/bench/growth.h"
#include "programs/bench/process.h"
#include "programs/bench/side_by_side.h"
#include "programs/bench/temporary_folder.h"
#include "programs/bench/timing.h"
#include "programs/scenes/generated_scenes.h"
#include "tests/bench/device_scene.h"
#include "tests/bench/peak_memory.h"
#include "tests/bench/result_table.h"
#include "tests/bench/root_choice.h"
#include "tests/bench/sketch.h"
#include "tests/bench/traversal.h"

namespace displayfile::bench {
namespace {

struct Options {
  std::vector<std::string> meshes;
  std::vector<std::string> parts;  ///< empty: all
  bool quick = false;
  int threads = 1;
  int rounds = 7;
  std::string figure, csv;
  std::string memory_of;  ///< a method: only that, in this process
  std::size_t polygons = 1'000'000;
};

constexpr std::array kMethods = {HiddenMethod::bsp, HiddenMethod::depth_sort};

SortOptions sort_options(const Options& options, bool exact = true) {
  SortOptions sort;
  sort.precision.exact = exact;
  sort.threads = options.threads;
  return sort;
}

std::size_t pieces(const DeviceScene& scene, HiddenMethod method, const Options& options) {
  return sort_hidden_surfaces(scene.items(), method, sort_options(options)).pieces.size();
}

/// In a window of 1024 x 1024 pixels. All polygons are triangles.
Gl2psSort gl2ps_of(const DeviceScene& scene, bool best_root) {
  return {scene.points, {1024, 1024}, best_root};
}

std::string two(double x) { return fmt::format("{:.2f}", x); }
std::string spread_text(const Spread& s) {
  return fmt::format("{} to {}", two(s.least), two(s.greatest));
}
std::string a_polygon(std::size_t count, const DeviceScene& scene) {
  return fmt::format("{:.4f}", static_cast<double>(count) / static_cast<double>(scene.size()));
}

// ---- Pieces ----------------------------------------------------------------------------

/// The closed scans, on which depth sort has a bound of its own.
bool is_scan(const Model& model) {
  return model.name.find("spot") != std::string::npos ||
         model.name.find("bunny") != std::string::npos;
}

struct Peers {
  std::optional<std::string> gl2ps = Gl2psSort::version(), sketch = Sketch::version();
};

void pieces_of_depth_sort(const Model& model, const DeviceScene& scene, const Peers& peers,
                          const Options& options, std::vector<Result>& results) {
  const std::string work = scene.name + ": pieces a polygon, depth sort";
  const std::size_t ours = pieces(scene, HiddenMethod::depth_sort, options);
  if (peers.sketch) {
    const TemporaryFolder folder;
    const std::size_t theirs = Sketch(scene, folder).fragments(Sketch::Sort::depth);
    results.push_back({work, "at most Sketch's " + a_polygon(theirs, scene), a_polygon(ours, scene),
                       "", "", holds_if(ours <= theirs)});
  } else {
    results.push_back(
        {work, "at most Sketch's", a_polygon(ours, scene), "", "Sketch is not installed", ""});
  }
  if (!is_scan(model)) return;
  const bool holds = static_cast<double>(ours) <= 1.002 * static_cast<double>(scene.size());
  results.push_back({work, "at most 1.002", a_polygon(ours, scene), "", "", holds_if(holds)});
}

void pieces_of_bsp(const DeviceScene& scene, const Peers& peers, const Options& options,
                   std::vector<Result>& results) {
  const std::size_t ours = pieces(scene, HiddenMethod::bsp, options);
  std::string beside;
  if (peers.gl2ps) {
    beside = fmt::format("gl2ps {}, with its best root {}",
                         a_polygon(gl2ps_of(scene, false).pieces().size(), scene),
                         a_polygon(gl2ps_of(scene, true).pieces().size(), scene));
  }
  if (peers.sketch) {
    const TemporaryFolder folder;
    const std::size_t theirs = Sketch(scene, folder).fragments(Sketch::Sort::bsp);
    beside += (beside.empty() ? "" : ", ") + ("sketch -b " + a_polygon(theirs, scene));
  }
  const double each = static_cast<double>(ours) / static_cast<double>(scene.size());
  results.push_back({scene.name + ": pieces a polygon, BSP", "at most 2.0 (goal 1.5)",
                     a_polygon(ours, scene), "", beside,
                     holds_if(each <= 2.0) + (each <= 1.5 ? ", goal too" : "")});
}

/// Both variants of a model; one, where they are the same.
std::vector<const DeviceScene*> variants(const Model& model) {
  if (!model.closed) return {&model.all};
  return {&model.entered, &model.all};
}

void pieces_of(const Model& model, const Peers& peers, const Options& options,
               std::vector<Result>& results) {
  for (const DeviceScene* scene : variants(model)) {
    pieces_of_depth_sort(model, *scene, peers, options, results);
    pieces_of_bsp(*scene, peers, options, results);
  }
}

// ---- Time ------------------------------------------------------------------------------

Result at_least(const std::string& work, double asked, const Spread& measured,
                const std::string& beside) {
  return {work,
          fmt::format("at least {:g} times as fast", asked),
          two(measured.median),
          spread_text(measured),
          beside,
          holds_if(measured.median >= asked)};
}

/// By the processor's time on one thread, as gl2ps has but one; with its best root and without.
void against_gl2ps(const Model& model, const Peers& peers, const Options& options,
                   std::vector<Result>& results) {
  Options alone = options;
  alone.threads = 1;
  for (const DeviceScene* scene : variants(model)) {
    struct Asked {
      HiddenMethod method;
      double times;
    };
    for (const Asked& asked :
         {Asked{HiddenMethod::bsp, 10.0}, Asked{HiddenMethod::depth_sort, 20.0}}) {
      for (const bool best_root : {false, true}) {
        const std::string work =
            fmt::format("{}: the sort alone, {}, 1 thread, against gl2ps's BSP{}", scene->name,
                        name_of(asked.method), best_root ? " with its best root" : "");
        if (!peers.gl2ps) {
          results.push_back({work, fmt::format("at least {:g} times as fast", asked.times), "", "",
                             "no gl2ps here", ""});
          continue;
        }
        const auto ours = [&] {
          return seconds_each(Clock::processor, 1, [&] {
            sort_hidden_surfaces(scene->items(), asked.method, sort_options(alone));
          });
        };
        const Spread faster = ratio_of_seconds(options.rounds, ours,
                                               [&] { return gl2ps_of(*scene, best_root).sort(); });
        results.push_back(at_least(work, asked.times, faster, ""));
      }
    }
  }
}

void against_sketch(const Model& model, const Peers& peers, const Options& options,
                    std::vector<Result>& results) {
  const std::string work = model.name + ": mesh to sorted SVG, whole process, against Sketch";
  if (!peers.sketch) {
    results.push_back({work, "at least 3 times as fast", "", "", "Sketch is not installed", ""});
    return;
  }
  const TemporaryFolder folder;
  const Sketch sketch(model.entered, folder);
  const std::vector<std::string> command = {
      DISPLAYFILE_COMMAND,      "draw", model.path, "--hidden", "depth-sort", "-o",
      folder.file("sorted.svg")};
  if (!run(command).succeeded) throw Error("displayfile draw failed on " + model.path);
  const Spread faster = times_faster(
      options.rounds, [&] { run(command); }, [&] { sketch.draw(Sketch::Sort::depth); });
  results.push_back(at_least(work, 3.0, faster, "its depth sort, .sk to .tex"));
}

/// The work done as often as makes the clock's grain and a small scene's noise small.
auto repeated(const auto& work) {
  constexpr double kEnough = 0.05;
  const double once = seconds(work);
  const int times = std::clamp(static_cast<int>(std::ceil(kEnough / once)), 1, 1000);
  return [work, times] {
    for (int i = 0; i < times; ++i) work();
  };
}

void exact_against_roundoff(const Model& model, const Options& options,
                            std::vector<Result>& results) {
  for (const HiddenMethod method : kMethods) {
    const auto sorted = [&](bool exact) {
      return [&, exact] {
        sort_hidden_surfaces(model.entered.items(), method, sort_options(options, exact));
      };
    };
    const Spread ratio =
        times_faster(options.rounds, repeated(sorted(false)), repeated(sorted(true)));
    results.push_back(
        {fmt::format("{}: exact against roundoff, {}", model.entered.name, name_of(method)),
         "at most 1.3 times the time", two(ratio.median), spread_text(ratio), "",
         holds_if(ratio.median <= 1.3)});
  }
}

// ---- Growth and memory -----------------------------------------------------------------

/// Whether the total overlap is proportional to the number of polygons, as the bound supposes.
struct GrowthScene {
  std::string_view name;
  bool sparse;
};
constexpr std::array kGrowthScenes = {GrowthScene{"village", true}, GrowthScene{"terrain", true},
                                      GrowthScene{"soup", true}, GrowthScene{"city", false}};

/// The least of a few times, where one is soon done.
double time_of_sort(const DeviceScene& scene, HiddenMethod method, const Options& options) {
  double least = 0.0;
  for (int i = 0; i < (scene.size() <= 40'000 ? 3 : 1); ++i) {
    const double time =
        seconds([&] { sort_hidden_surfaces(scene.items(), method, sort_options(options)); });
    least = i == 0 ? time : std::min(least, time);
  }
  return least;
}

void growth_of(const GrowthScene& kind, const Options& options, std::vector<Result>& results) {
  constexpr int kRuns = 3;
  std::vector<double> sizes, overlaps;
  // The seconds of each method in each run, a figure a size.
  std::array<std::array<std::vector<double>, kRuns>, kMethods.size()> times;
  const int high = options.quick || !kind.sparse ? 5 : 6;
  for (const std::size_t n : sizes_of_growth(3, high)) {
    const DeviceScene scene = generated(std::string(kind.name), n);
    sizes.push_back(static_cast<double>(scene.size()));
    overlaps.push_back(overlaps_per_polygon(scene));
    for (int run = 0; run < kRuns; ++run) {
      for (std::size_t m = 0; m < kMethods.size(); ++m) {
        times[m][static_cast<std::size_t>(run)].push_back(
            time_of_sort(scene, kMethods[m], options));
      }
    }
  }
  for (std::size_t m = 0; m < kMethods.size(); ++m) {
    std::vector<double> exponents;
    for (const auto& run : times[m]) exponents.push_back(fitted_exponent(sizes, run));
    const Spread exponent = spread(exponents);
    results.push_back({fmt::format("{}: growth from 10^3 to 10^{} polygons, {}", kind.name, high,
                                   name_of(kMethods[m])),
                       kind.sparse ? "exponent at most 1.15" : "", two(exponent.median),
                       spread_text(exponent),
                       fmt::format("extents overlapped by each: {:.1f} to {:.1f}", overlaps.front(),
                                   overlaps.back()),
                       kind.sparse ? holds_if(exponent.median <= 1.15) : "not sparse"});
  }
}

constexpr std::string_view kMemoryScene = "terrain";

/// In a process of its own: prints the peak bytes of the sort with the display file.
void print_memory(const Options& options) {
  const Scene scene = generated_scene(kMemoryScene).make(options.polygons, 1);
  GraphicsSystem system;
  system.set_hidden_surfaces({.removal = true});
  system.set_back_face_removal(false);
  system.set_hidden_surfaces({.method = hidden_method(options.memory_of)});
  system.set_threads(options.threads);
  const auto bytes = peak_bytes([&] { enter(scene, system); });
  if (!bytes) throw Error("the system does not tell how much memory a process takes");
  fmt::print("{} {}\n", *bytes, scene.polygons());
}

void memory(const std::string& program, const Options& options, std::vector<Result>& results) {
  const std::size_t n = options.quick ? 100'000 : 1'000'000;
  for (const HiddenMethod method : kMethods) {
    const Finished child = run({program, "--memory-of", std::string(name_of(method)), "--polygons",
                                std::to_string(n), "--threads", std::to_string(options.threads)});
    unsigned long long bytes = 0, polygons = 0;
    if (!child.succeeded ||
        std::sscanf(child.output.c_str(), "%llu %llu", &bytes, &polygons) != 2) {
      results.push_back({fmt::format("memory, {}", name_of(method)), "at most 600 bytes a polygon",
                         "", "", "not told by this system", ""});
      continue;
    }
    const double each = static_cast<double>(bytes) / static_cast<double>(polygons);
    results.push_back({fmt::format("{}, {} polygons entered and sorted: peak memory, {}",
                                   kMemoryScene, polygons, name_of(method)),
                       "at most 600 bytes a polygon", fmt::format("{:.0f}", each), "",
                       "resident, of a process of its own", holds_if(each <= 600.0)});
  }
}

/// Counts the polygons as entered, of which the tree makes more.
Result traversal_of(const DeviceScene& scene) {
  constexpr double kAsked = 20e6;
  constexpr int kEyes = 64;
  const Traversal walked = traversal(scene, kEyes);
  const auto [least, median, greatest] = walked.polygons_a_second;
  return {fmt::format("{}, {} polygons: traversal of a retained tree", scene.name, scene.size()),
          "at least 20 million polygons a second",
          two(median / kAsked) + " times that",
          spread_text({least / kAsked, median / kAsked, greatest / kAsked}),
          fmt::format("{:.2f} pieces a polygon, {} times that in pieces",
                      static_cast<double>(walked.pieces) / static_cast<double>(walked.polygons),
                      two(walked.pieces_a_second.median / kAsked)),
          holds_if(median >= kAsked)};
}

void traversals(const Model& model, const Options& options, std::vector<Result>& results) {
  results.push_back(traversal_of(model.all));
  results.push_back(traversal_of(generated("soup", options.quick ? 100'000 : 1'000'000)));
}

// ---- The choice of a root --------------------------------------------------------------

/// The textbook's choice costs n^2 on what is convex: beyond this it is left out.
std::size_t most_polygons(RootChoice root, const Options& options) {
  if (root != RootChoice::last) return options.quick ? 20'000 : 200'000;
  return options.quick ? 10'000 : 100'000;
}

void print_roots(const std::vector<Model>& models, const Options& options) {
  std::vector<std::vector<std::string>> rows;
  std::vector<const DeviceScene*> scenes;
  const DeviceScene ball = sphere(20'000);
  for (const Model& model : models) scenes.push_back(&model.entered);
  scenes.push_back(&ball);
  for (const DeviceScene* scene : scenes) {
    for (const RootChoice root : kRootChoices) {
      if (scene->size() > most_polygons(root, options)) continue;
      const RootCost cost = root_cost(*scene, root, options.threads);
      const auto sorted = [&](RootChoice choice) {
        return [&, choice] { root_cost(*scene, choice, options.threads); };
      };
      const Spread ratio = root == RootChoice::free
                               ? Spread{1.0, 1.0, 1.0}
                               : times_faster(1, sorted(RootChoice::free), sorted(root));
      rows.push_back({scene->name, std::to_string(scene->size()), std::string(name_of(root)),
                      fmt::format("{:.4f}", cost.pieces), fmt::format("{:.1f}", cost.comparisons),
                      std::to_string(cost.depth), two(ratio.median)});
    }
  }
  fmt::print("\nThe choice of a BSP root, exact\n\n{}",
             text_table({"scene", "polygons", "root", "pieces a polygon", "comparisons a polygon",
                         "depth", "time, of free's"},
                        rows));
}

void write_text(const std::string& path, const std::string& text) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  const bool written =
      file != nullptr && std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (file == nullptr || std::fclose(file) != 0 || !written) {
    throw Error(path + ": cannot be written");
  }
}

/// Counts only: any machine gives the same figure.
void plot_roots(const Options& options) {
  std::vector<RootCost> costs;
  for (const std::string name : {"sphere", "terrain", "soup"}) {
    for (const std::size_t n : sizes_of_growth(2, options.quick ? 4 : 5)) {
      const DeviceScene scene = name == "sphere" ? sphere(n) : generated(name, n);
      for (const RootChoice root : kRootChoices) {
        if (n > most_polygons(root, options)) continue;
        costs.push_back(root_cost(scene, root, options.threads));
        costs.back().scene = name;
      }
    }
  }
  if (!options.figure.empty()) write_text(options.figure, figure(costs));
  if (!options.csv.empty()) write_text(options.csv, csv(costs));
}

// ---- All of it -------------------------------------------------------------------------

void print_heading(const Peers& peers, const Options& options) {
  fmt::print(
      "Sorts in object space, exact unless said otherwise; {} thread(s) of ours; beside {} and "
      "{}.\nTimes are ratios taken in turn in this run: the median of {} rounds.\n"
      "gl2ps's is gl2psEndPage in a format that writes no polygons (rescaling, tree, traversal, "
      "freeing); ours is sort_hidden_surfaces,\nfreeing its result too. Both get the same "
      "triangles in device coordinates.\n\n",
      options.threads, peers.gl2ps ? "gl2ps " + *peers.gl2ps : "no gl2ps",
      peers.sketch.value_or("no Sketch"), options.rounds);
}

const Model& largest(const std::vector<Model>& models) {
  return *std::ranges::max_element(models, {}, [](const Model& m) { return m.all.size(); });
}

void run_all(const std::string& program, const Options& options) {
  const auto wanted = [&](std::string_view part) {
    return options.parts.empty() || std::ranges::find(options.parts, part) != options.parts.end();
  };
  const Peers peers;
  std::vector<Model> models;
  for (const std::string& path : options.meshes) models.push_back(read_model(path));
  print_heading(peers, options);
  std::vector<Result> results;
  for (const Model& model : models) {
    if (wanted("pieces")) pieces_of(model, peers, options, results);
  }
  if (!models.empty() && wanted("time")) {
    against_gl2ps(largest(models), peers, options, results);
    against_sketch(largest(models), peers, options, results);
    for (const Model& model : models) exact_against_roundoff(model, options, results);
    traversals(largest(models), options, results);
  }
  if (wanted("growth")) {
    for (const GrowthScene& kind : kGrowthScenes) growth_of(kind, options, results);
  }
  if (wanted("memory")) memory(program, options, results);
  if (!results.empty()) fmt::print("{}", text_table(results));
  if (wanted("roots")) print_roots(models, options);
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  namespace bench = displayfile::bench;
  bench::Options options;
  options.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  CLI::App app("Sorts in object space: pieces, speed, growth and memory, beside gl2ps and Sketch");
  app.add_option("mesh", options.meshes, "meshes, in any format that the command reads")
      ->check(CLI::ExistingFile);
  app.add_flag("--quick", options.quick, "growth to 10^5 polygons, memory at 10^5");
  app.add_option("--threads", options.threads, "of ours; the results are the same")
      ->check(CLI::Range(1, 256));
  app.add_option("--rounds", options.rounds, "of each comparison")->check(CLI::Range(1, 1000));
  app.add_option("--parts", options.parts, "only these: pieces, time, growth, memory, roots")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"pieces", "time", "growth", "memory", "roots"}));
  app.add_option("--plot", options.figure,
                 "write a figure of what each choice of root costs (SVG), and print no table");
  app.add_option("--csv", options.csv, "its figures");
  app.add_option(
      "--memory-of", options.memory_of,
      "print the peak memory of this method's sort of a scene, in bytes, and its polygons");
  app.add_option("--polygons", options.polygons, "of that scene");
  CLI11_PARSE(app, argc, argv);
  try {
    if (!options.memory_of.empty()) {
      bench::print_memory(options);
    } else if (!options.figure.empty() || !options.csv.empty()) {
      bench::plot_roots(options);
    } else {
      bench::run_all("/proc/self/exe", options);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "sort_bench: {}\n", error.what());
    return 2;
  }
}
