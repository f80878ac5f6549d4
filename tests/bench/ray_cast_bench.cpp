// Ray casting in image space beside Embree's primary rays:
//   ray_cast_bench [--size N] [--threads N] [--triangles N] [MESH...]
// The same triangles and the same parallel rays through the pixel centres; Embree's in coherent
// packets of eight. Prints ratios, and how many pixels see another triangle; run it on a machine
// that does nothing else. Embree is single precision and counts no ties, so that it differs where
// triangles touch or are nearly as deep.

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "interp/image_space.h"
#include "programs/bench/side_by_side.h"
#include "programs/scenes/generated_scenes.h"
#include "tests/bench/device_scene.h"
#include "tests/bench/embree_rays.h"

namespace displayfile::bench {
namespace {

constexpr int kRowsOfTask = 16;

struct Options {
  int size = 1024, threads = 1, rounds = 9;
  std::vector<std::size_t> triangles{10'000, 100'000};
  std::vector<std::string> scenes, meshes;
};

/// The scene's polygons, those of more sides cut into fans.
FillScene in_triangles(const DeviceScene& scene) {
  DisplayFile file;
  Segment& segment = file.create(1);
  segment.set_style(LineStyle{LineStyle::Kind::none});
  segment.set_style(FillStyle{FillStyle::Kind::solid});
  const std::vector<std::uint8_t> edges(3, 1);
  for (const SortItems::Item& polygon : scene.polygons) {
    const Point3* const p = scene.points.data() + polygon.first;
    for (std::uint32_t k = 2; k < polygon.sides; ++k) {
      segment.enter_polygon(std::vector<Point3>{p[0], p[k - 1], p[k]}, edges);
    }
  }
  return FillScene(file);
}

/// Rows in tasks, on so many threads.
void for_rows(const Options& options, const auto& draw) {
  tbb::task_arena(options.threads).execute([&] {
    tbb::parallel_for(0, (options.size + kRowsOfTask - 1) / kRowsOfTask, [&](int task) {
      draw(task * kRowsOfTask, std::min(options.size, (task + 1) * kRowsOfTask));
    });
  });
}

void compare(const DeviceScene& device_scene, const Options& options) {
  using Fill = FillScene::Fill;
  const FillScene scene = in_triangles(device_scene);
  const PictureSize size{options.size, options.size};
  const auto width = static_cast<std::size_t>(size.width);
  const auto method = make_image_space_method(HiddenMethod::ray_cast);
  const ImageSpaceMethod::Request request{scene, size, std::nullopt};
  method->prepare(request, options.threads);
  std::vector<Fill> seen(width * width), seen_by_embree(width * width);
  const auto ours = [&] {
    for_rows(options, [&](int begin, int end) {
      method->draw_rows(begin, end, [&](int row, int first, std::span<const Fill> fills) {
        std::ranges::copy(
            fills, seen.begin() +
                       static_cast<std::ptrdiff_t>(static_cast<std::size_t>(row) * width) + first);
      });
    });
  };
  const EmbreeRays embree(scene, size.width, size.height, options.threads);
  const auto embrees = [&] {
    for_rows(options, [&](int begin, int end) { embree.cast(begin, end, seen_by_embree); });
  };
  const Spread rays = times_faster(options.rounds, ours, embrees);
  std::size_t hits = 0, others = 0;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    hits += seen[k] != FillScene::kBackground;
    others += seen[k] != seen_by_embree[k];
  }
  const Spread build = times_faster(
      3, [&] { method->prepare(request, options.threads); },
      [&] { EmbreeRays(scene, size.width, size.height, options.threads); });
  fmt::print(
      "{:<28} {:>8} triangles, {:>3.0f} % hit: rays {:>5.2f} times as fast ({:.2f} to {:.2f}), "
      "scene {:.2f} times; Embree sees another at {} pixels\n",
      device_scene.name, scene.end() - 1,
      100.0 * static_cast<double>(hits) / static_cast<double>(seen.size()), rays.median, rays.least,
      rays.greatest, build.median, others);
  std::fflush(stdout);
}

void run(const Options& options) {
  if (!EmbreeRays::version()) {
    fmt::print("this build has no Embree\n");
    return;
  }
  fmt::print("Ray casting against Embree {}, {} x {} rays, threads {}\n", *EmbreeRays::version(),
             options.size, options.size, options.threads);
  for (const std::string& path : options.meshes) compare(read_model(path).all, options);
  for (const std::size_t n : options.triangles) {
    for (const GeneratedScene& scene : generated_scenes()) {
      const std::string name(scene.name);
      const auto& named = options.scenes;
      if (!named.empty() && std::ranges::find(named, name) == named.end()) continue;
      compare(generated(name, n), options);
    }
  }
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  displayfile::bench::Options options;
  CLI::App app{"Ray casting in image space beside Embree's primary rays"};
  app.add_option("--size", options.size, "pixels a side")->check(CLI::Range(1, 8192));
  app.add_option("--threads", options.threads, "of each")->check(CLI::Range(1, 64));
  app.add_option("--rounds", options.rounds, "that are timed")->check(CLI::Range(1, 1000));
  app.add_option("--scenes", options.scenes, "generated ones, by name; all, if none is named")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--triangles", options.triangles, "of the generated scenes, about so many each")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("meshes", options.meshes, "any that Assimp reads")->check(CLI::ExistingFile);
  CLI11_PARSE(app, argc, argv);
  displayfile::bench::run(options);
}
