// Lines along which polygons pass through each other: what it costs to find them, against the
// hidden lines of all sides by Franklin's method, what is seen of them, and how that grows.
//   intersection_lines_bench [MESH...]
// Each mesh by itself, and twice: two that interpenetrate. Prints ratios and counts; run it on a
// machine that does nothing else.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "hidden/lines/visible_lines.h"
#include "programs/bench/growth.h"
#include "programs/bench/side_by_side.h"
#include "programs/bench/timing.h"
#include "tests/bench/command_line.h"
#include "tests/bench/device_scene.h"
#include "tests/bench/growth_options.h"
#include "tests/bench/result_table.h"

namespace displayfile::bench {
namespace {

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

std::vector<std::string> ratios_of(const SharedScene& scene, const GrowthOptions& options) {
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

std::vector<std::string> growth_of(const std::string& name, const GrowthOptions& options) {
  std::vector<double> sizes, finding, seeing;
  std::size_t first = 0, last = 0;
  for (const std::size_t n : sizes_of_growth(options.low, options.high)) {
    const SharedScene scene(generated(name, n));
    const Clock clock = clock_of(options.threads);
    std::vector<IntersectionLine> found;
    sizes.push_back(static_cast<double>(scene.polygons.size()));
    finding.push_back(least_seconds_each(
        clock, 3, [&] { found = intersection_lines(scene.items(), options.threads); }));
    seeing.push_back(least_seconds_each(clock, 3, [&] {
      visible_lines(scene.items(), {}, HiddenMethod::franklin,
                    {.precision = {}, .threads = options.threads}, found);
    }));
    last = found.size();
    if (sizes.size() == 1) first = last;
  }
  return {name, options.sizes(), fmt::format("{} to {}", first, last),
          fmt::format("{:.2f}", fitted_exponent(sizes, finding)),
          fmt::format("{:.2f}", fitted_exponent(sizes, seeing))};
}

void run(const GrowthOptions& options) {
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
  if (!options.want_growth()) return;
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
  displayfile::bench::GrowthOptions options;
  CLI::App app("Intersection lines, compared", "intersection_lines_bench");
  add_options(app, options);
  return displayfile::bench::parsed_and_run(app, argc, argv,
                                            [&] { displayfile::bench::run(options); });
}
