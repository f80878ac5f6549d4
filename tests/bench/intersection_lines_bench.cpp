// Lines along which polygons pass through each other: what it costs to find them, against the
// hidden lines of all sides by Franklin's method, what is seen of them, and how that grows.
//   intersection_lines_bench [MESH...]
// Each mesh by itself, and twice: two that interpenetrate. Prints ratios and counts; run it on a
// machine that does nothing else.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <exception>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "hidden/lines/visible_lines.h"
#include "programs/bench/growth.h"
#include "programs/bench/side_by_side.h"
#include "programs/bench/timing.h"
#include "tests/bench/device_scene.h"
#include "tests/bench/result_table.h"

namespace displayfile::bench {
namespace {

struct Options {
  std::vector<std::string> meshes;
  int threads = 1;
  int rounds = 5;
  int low = 4, high = 6;  ///< of the sizes of growth, powers of ten
};

/// A scene whose polygons share their corners, as those of a mesh do.
struct SharedScene {
  explicit SharedScene(const DeviceScene& scene) : name(scene.name), polygons(scene.polygons) {
    std::map<std::tuple<double, double, double>, std::uint32_t> known;
    for (const Point3& p : scene.points) {
      const auto next = static_cast<std::uint32_t>(points.size());
      const auto [at, is_new] = known.try_emplace({p.x, p.y, p.z}, next);
      if (is_new) points.push_back(p);
      corners.push_back(at->second);
    }
    lines = drawn_lines(items());
  }
  Primitives items() const { return {points, corners, {}, polygons}; }

  std::string name;
  std::vector<Point3> points;
  std::vector<std::uint32_t> corners;
  std::vector<Primitives::Item> polygons;
  std::vector<LineName> lines;
};

/// The scene, and beside it once more what it has, moved by a part of its size and turned round.
DeviceScene twice(const DeviceScene& scene) {
  DeviceScene both = scene;
  both.name += ", twice";
  Point3 low = scene.points[0], high = low;
  for (const Point3& p : scene.points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  std::vector<Point3> moved;
  for (const Point3& p : scene.points) {
    const Point3 turned{low.x + high.x - p.x, p.y, low.z + high.z - p.z};
    moved.push_back(turned + Point3{0.3, 0.1, 0.05} * (high - low));
  }
  for (const Primitives::Item& item : scene.polygons) both.add(&moved[item.first], item.sides);
  return both;
}

std::string text(const Spread& s) {
  return fmt::format("{:.3f} ({:.3f} to {:.3f})", s.median, s.least, s.greatest);
}

std::vector<std::string> ratios_of(const SharedScene& scene, const Options& options) {
  const LineOptions exact{.precision = {}, .threads = options.threads};
  const auto found = intersection_lines(scene.items(), options.threads);
  const auto franklin = [&](const std::vector<IntersectionLine>& intersections) {
    return visible_lines(scene.items(), scene.lines, HiddenMethod::franklin, exact, intersections);
  };
  const Spread find = times_faster(
      options.rounds, [&] { franklin({}); },
      [&] { intersection_lines(scene.items(), options.threads); });
  const Spread see = times_faster(
      options.rounds, [&] { franklin({}); }, [&] { franklin(found); });
  return {scene.name,
          std::to_string(scene.polygons.size()),
          std::to_string(scene.lines.size()),
          std::to_string(found.size()),
          std::to_string(franklin(found).intersections.size()),
          text(find),
          text(see)};
}

std::vector<std::string> growth_of(const std::string& name, const Options& options) {
  std::vector<double> sizes, finding, seeing;
  std::size_t first = 0, last = 0;
  for (const std::size_t n : sizes_of_growth(options.low, options.high)) {
    const SharedScene scene(generated(name, n));
    std::vector<IntersectionLine> found;
    double find = 0.0, see = 0.0;
    for (int i = 0; i < 3; ++i) {  // the least, as other work only adds to it
      const double time = seconds_each(clock_of(options.threads), 1, [&] {
        found = intersection_lines(scene.items(), options.threads);
      });
      const double more = seconds_each(clock_of(options.threads), 1, [&] {
        visible_lines(scene.items(), {}, HiddenMethod::franklin,
                      {.precision = {}, .threads = options.threads}, found);
      });
      find = i == 0 ? time : std::min(find, time);
      see = i == 0 ? more : std::min(see, more);
    }
    sizes.push_back(static_cast<double>(scene.polygons.size()));
    finding.push_back(find);
    seeing.push_back(see);
    last = found.size();
    if (sizes.size() == 1) first = last;
  }
  return {name, fmt::format("10^{} to 10^{}", options.low, options.high),
          fmt::format("{} to {}", first, last),
          fmt::format("{:.2f}", fitted_exponent(sizes, finding)),
          fmt::format("{:.2f}", fitted_exponent(sizes, seeing))};
}

void run(const Options& options) {
  fmt::print(
      "Intersection lines, {} thread(s). Times in one run, in those of the hidden lines of all "
      "sides: the median of {} rounds, least and greatest.\n\n",
      options.threads, options.rounds);
  std::vector<std::vector<std::string>> rows;
  for (const std::string& mesh : options.meshes) {
    const DeviceScene scene = read_model(mesh).all;
    rows.push_back(ratios_of(SharedScene(scene), options));
    rows.push_back(ratios_of(SharedScene(twice(scene)), options));
  }
  rows.push_back(ratios_of(SharedScene(generated("terrain", 20'000)), options));
  rows.push_back(ratios_of(SharedScene(generated("village", 20'000)), options));
  rows.push_back(ratios_of(SharedScene(generated("soup", 20'000)), options));
  rows.push_back(ratios_of(SharedScene(generated("planes", 100)), options));
  fmt::print("{}", text_table({"scene", "polygons", "sides", "intersections", "pieces of them",
                               "to find them", "all lines with them"},
                              rows));
  if (options.high <= options.low) return;
  rows.clear();
  for (const char* const name : {"terrain", "village", "soup"}) {
    rows.push_back(growth_of(name, options));
  }
  fmt::print("\nGrowth\n\n{}", text_table({"scene", "polygons", "intersections",
                                           "exponent of finding", "of seeing them alone"},
                                          rows));
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  displayfile::bench::Options options;
  CLI::App app("Intersection lines, compared");
  app.add_option("meshes", options.meshes, "meshes")->check(CLI::ExistingFile);
  app.add_option("--threads", options.threads)->check(CLI::Range(1, 1024));
  app.add_option("--rounds", options.rounds)->check(CLI::Range(1, 1000));
  app.add_option("--low", options.low, "growth from 10^this")->check(CLI::Range(1, 7));
  app.add_option("--high", options.high, "growth to 10^this; no more than --low: none")
      ->check(CLI::Range(1, 7));
  CLI11_PARSE(app, argc, argv);
  try {
    displayfile::bench::run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "intersection_lines_bench: {}\n", error.what());
    return 1;
  }
  return 0;
}
