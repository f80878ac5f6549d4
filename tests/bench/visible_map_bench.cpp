// The visible-surface map: pieces and time beside the sorts, and how time
// grows with the scene.
//   visible_map_bench [MESH...]
// Prints ratios and counts; run it on a machine that does nothing else.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "displayfile/hidden_surface_check.h"
#include "hidden/map/map_pieces.h"
#include "interp/vector/svg_device.h"
#include "programs/bench/growth.h"
#include "programs/bench/side_by_side.h"
#include "programs/bench/timing.h"
#include "tests/bench/command_line.h"
#include "tests/bench/device_scene.h"
#include "tests/bench/growth_options.h"
#include "tests/bench/result_table.h"

namespace displayfile::bench {
namespace {

struct Options : GrowthOptions {
  std::vector<std::string> scenes = {"terrain", "village", "soup"};
  std::size_t planes = 200;
};

/// A scene in one segment of a display file, each polygon of a shade of its own.
DisplayFile entered(const DeviceScene& scene) {
  DisplayFile file;
  Segment& segment = file.create(1);
  segment.set_style(LineStyle{LineStyle::Kind::none});
  for (std::size_t k = 0; k < scene.polygons.size(); ++k) {
    FillStyle style;
    const double grey = static_cast<double>(k % 200) / 255.0;
    style.colour = {grey, grey, 0.2 + grey};
    segment.set_style(style);
    const auto& polygon = scene.polygons[k];
    segment.enter_polygon(std::span(scene.points).subspan(polygon.first, polygon.sides),
                          std::vector<std::uint8_t>(polygon.sides, 0));
  }
  return file;
}

std::size_t find(const DisplayFile& file, HiddenMethod method, int threads) {
  SortOptions options;
  options.threads = threads;
  const auto sorted = hidden_surface_check(file.visible_segments(), method, options);
  return sorted->counts.pieces;
}

/// From the display file to a file of the picture.
void sort_and_write(const DisplayFile& file, HiddenMethod method, int threads) {
  DisplayFile sorted = file;
  SortOptions options;
  options.threads = threads;
  sorted.set_sorted(hidden_surface_check(sorted.visible_segments(), method, options));
  const auto path = std::filesystem::temp_directory_path() / "visible_map_bench.svg";
  write_svg(sorted, 512, 512, path);
  std::filesystem::remove(path);
}

std::string text(const Spread& s) {
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", s.median, s.least, s.greatest);
}

std::vector<std::string> row_of(const DeviceScene& scene, const Options& options) {
  const DisplayFile file = entered(scene);
  const auto map = [&] { find(file, HiddenMethod::map, options.threads); };
  const auto by = [&](HiddenMethod method) {
    return [&file, &options, method] { find(file, method, options.threads); };
  };
  const Spread written = times_faster(options.rounds, map, [&] {
    sort_and_write(file, HiddenMethod::depth_sort, options.threads);
  });
  const Spread depth_sort = times_faster(options.rounds, map, by(HiddenMethod::depth_sort));
  const Spread bsp = times_faster(1, map, by(HiddenMethod::bsp));
  const Spread one = times_faster(options.rounds, map, [&] { find(file, HiddenMethod::map, 1); });
  return {scene.name,
          std::to_string(scene.size()),
          std::to_string(find(file, HiddenMethod::map, options.threads)),
          std::to_string(find(file, HiddenMethod::depth_sort, options.threads)),
          std::to_string(find(file, HiddenMethod::bsp, options.threads)),
          text(written),
          text(depth_sort),
          fmt::format("{:.2f}", bsp.median),
          options.threads == 1 ? "" : text(one)};
}

std::vector<std::string> growth_of(const std::string& name, const Options& options) {
  std::vector<double> sizes, seconds_of_map, overlaps;
  for (const std::size_t n : sizes_of_growth(options.low, options.high)) {
    const DeviceScene scene = generated(name, n);
    sizes.push_back(static_cast<double>(scene.size()));
    overlaps.push_back(overlaps_per_polygon(scene));
    seconds_of_map.push_back(least_seconds_each(clock_of(options.threads), 2, [&] {
      const VisibleMap map = visible_map(scene.items(), {.threads = options.threads});
      pieces_of_map(scene.items(), map);
    }));
  }
  return {name, options.sizes(), fmt::format("{:.2f}", fitted_exponent(sizes, seconds_of_map)),
          fmt::format("{:.1f} to {:.1f}", overlaps.front(), overlaps.back())};
}

void run(const Options& options) {
  fmt::print(
      "The map from a display file to pieces, {} thread(s). Others' times over the map's, in one "
      "run: the median of {} rounds, least and greatest.\n\n",
      options.threads, options.rounds);
  std::vector<std::vector<std::string>> rows;
  for (const std::string& mesh : options.meshes) {
    rows.push_back(row_of(read_model(mesh).all, options));
  }
  for (const std::string& name : options.scenes) {
    rows.push_back(row_of(generated(name, 20'000), options));
  }
  if (options.planes > 0) rows.push_back(row_of(generated("planes", options.planes), options));
  fmt::print("{}", text_table({"scene", "polygons", "pieces of the map", "of depth sort", "of BSP",
                               "depth sort, written", "depth sort", "BSP", "one thread over these"},
                              rows));
  if (!options.want_growth()) return;
  rows.clear();
  for (const std::string& name : options.scenes) rows.push_back(growth_of(name, options));
  fmt::print("\nGrowth\n\n{}",
             text_table({"scene", "polygons", "exponent", "extents overlapped by each"}, rows));
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  displayfile::bench::Options options;
  CLI::App app("The visible-surface map, compared", "visible_map_bench");
  add_options(app, options);
  app.add_option("--scenes", options.scenes, "generated scenes")->delimiter(',');
  app.add_option("--planes", options.planes, "crossing planes; 0: none");
  return displayfile::bench::parsed_and_run(app, argc, argv,
                                            [&] { displayfile::bench::run(options); });
}
