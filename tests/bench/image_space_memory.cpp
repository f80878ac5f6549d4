#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <string>

#include "interp/visibility/image_space.h"
#include "programs/bench/counted_memory.h"
#include "programs/scenes/generated_scenes.h"

// The memory that each image-space method takes for a picture, beside a z-buffer of the whole
// picture: what is taken with new besides the scene. Counts, the same on every machine.

namespace displayfile {
namespace {

struct Options {
  int size = 16'384;
  std::string scene = "terrain";
  std::size_t polygons = 10'000;
};

std::int64_t bytes_of(ImageSpaceMethod& method, const ViewedScene& scene, int size) {
  return bench::most_bytes_held([&] {
    method.prepare({scene, {size, size}, {}}, 1);
    method.draw_rows(0, size, [](int, int, std::span<const ViewedScene::Fill>) {});
  });
}

void print(std::string_view name, std::int64_t bytes, std::int64_t of_z_buffer) {
  fmt::print("{:<24} {:>15} bytes {:>12.1f} times less\n", name, bytes,
             static_cast<double>(of_z_buffer) / static_cast<double>(bytes));
}

void run(const Options& options) {
  const GraphicsSystem system = entered(generated_scene(options.scene).make(options.polygons, 1));
  const ViewedScene scene(system.display_file());
  fmt::print("{}, {} polygons, {} x {} pixels\n", options.scene, scene.end() - 1, options.size,
             options.size);
  constexpr std::int64_t kBytesAPixel = 8;  // a depth in single precision and a fill
  const std::int64_t of_z_buffer = kBytesAPixel * options.size * options.size;
  print("z-buffer of the picture", of_z_buffer, of_z_buffer);
  for (const ImageSpaceEntry& entry : image_space_methods()) {
    if (entry.method == HiddenMethod::z_buffer) continue;
    print(name_of(entry.method), bytes_of(*entry.make(), scene, options.size), of_z_buffer);
  }
}

}  // namespace
}  // namespace displayfile

int main(int argc, char** argv) {
  displayfile::Options options;
  CLI::App app{"memory of the image-space methods"};
  app.add_option("--size", options.size, "of the picture, both ways");
  app.add_option("--scene", options.scene, "a generated scene");
  app.add_option("--polygons", options.polygons, "of the scene, about");
  CLI11_PARSE(app, argc, argv);
  try {
    displayfile::run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  return 0;
}
