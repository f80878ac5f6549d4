// Prints a generated scene, or one in which all touches, as a drawing program:
//   scene_program NAME POLYGONS [SEED]
// and without arguments the names of all, those in which polygons touch with a + before them.

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>

#include "displayfile/files.h"
#include "programs/scenes/generated_scenes.h"
#include "tests/bench/touching_scenes.h"

namespace displayfile::bench {
namespace {

template <class Scenes>
auto found(const Scenes& scenes, std::string_view name) {
  return std::ranges::find(scenes, name, [](const auto& scene) { return scene.name; });
}

Scene made(std::string_view name, std::size_t polygons, std::uint64_t seed) {
  const auto scene = found(touching_scenes(), name);
  if (scene != touching_scenes().end()) return scene->make(polygons, seed);
  return generated_scene(name).make(polygons, seed);
}

/// Without its setting of touching, which is the command's.
void print(const Scene& scene) {
  std::stringstream recorded;
  {
    Recorder recorder(recorded);
    GraphicsSystem system;
    system.set_recorder(&recorder);
    enter(scene, system);
  }
  for (std::string line; std::getline(recorded, line);) {
    if (!line.starts_with("set-touching")) std::cout << line << '\n';
  }
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  using namespace displayfile;
  if (argc < 3) {
    for (const GeneratedScene& scene : generated_scenes()) std::cout << scene.name << '\n';
    for (const bench::TouchingScene& scene : bench::touching_scenes()) {
      std::cout << '+' << scene.name << '\n';
    }
    return 0;
  }
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  bench::print(bench::made(argv[1], std::strtoull(argv[2], nullptr, 10), seed));
  return 0;
}
