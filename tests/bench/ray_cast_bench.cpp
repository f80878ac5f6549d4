// Ray casting in image space beside Embree's primary rays:
//   ray_cast_bench [--size N] [--threads N] [--triangles N] [MESH...]
// The same triangles, the same parallel rays through the pixel centres and as many threads;
// Embree's in coherent packets as wide as the processor's vectors, through trees of both its
// qualities. Prints ratios, and how many pixels see another triangle; run it on a machine that does
// nothing else. Embree is single precision and counts no ties, so that it differs where triangles
// touch or are nearly as deep.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "displayfile/mesh/mesh.h"
#include "programs/bench/beside_embree.h"
#include "programs/scenes/generated_scenes.h"
#include "programs/scenes/scene.h"

namespace displayfile::bench {
namespace {

struct Options {
  int size = 1024, threads = 1, rounds = 9;
  std::vector<std::size_t> triangles{10'000, 100'000};
  std::vector<std::string> scenes, meshes;
};

void compare(const std::string& name, const DisplayFile& file, const Options& options) {
  const DisplayFile cut = display_file_of(in_triangles(ViewedScene(file)));
  const ViewedScene triangles(cut);
  for (const auto quality : {EmbreeRays::Quality::moderate, EmbreeRays::Quality::high}) {
    const BesideEmbree beside = cast_beside_embree(triangles, options.size, options.threads,
                                                   quality, {.rounds = options.rounds});
    fmt::print(
        "{:<28} {:>8} triangles, {:>3.0f} % hit, {:<8}: rays {:>5.2f} times as fast ({:.2f} to "
        "{:.2f}), tree {:.2f} times; Embree sees another at {} pixels\n",
        name, triangles.end() - 1, 100.0 * beside.hit,
        quality == EmbreeRays::Quality::high ? "high" : "moderate", beside.rays.median,
        beside.rays.least, beside.rays.greatest, beside.building.median, beside.others);
  }
  std::fflush(stdout);
}

void run(const Options& options) {
  if (!EmbreeRays::version()) {
    fmt::print("this build has no Embree\n");
    return;
  }
  fmt::print("Ray casting against Embree {}, {} rays a packet, {} x {} rays, threads {}\n",
             *EmbreeRays::version(), EmbreeRays::packet_width(), options.size, options.size,
             options.threads);
  for (const std::string& path : options.meshes) {
    GraphicsSystem system;
    import_mesh(path, system);
    compare(path.substr(path.rfind('/') + 1), system.display_file(), options);
  }
  for (const std::size_t n : options.triangles) {
    for (const GeneratedScene& scene : generated_scenes()) {
      const std::string name(scene.name);
      const auto& named = options.scenes;
      if (!named.empty() && std::ranges::find(named, name) == named.end()) continue;
      compare(name, entered(scene.make(n, 1)).display_file(), options);
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
