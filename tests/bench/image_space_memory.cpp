// The memory that each image-space method takes for a picture, beside a z-buffer of the whole
// picture: bytes allocated with new besides the scene. These counts are the same on every machine.

#include "interp/visibility/image_space.h"
#include "programs/scenes/generated_scenes.h"
#include "tests/bench/benchmark.h"
#include "tests/bench/command/counted_memory.h"

namespace displayfile::bench {

const char* const kAbout = "Memory of the image-space methods";

void run(const Options& options) {
  for (const std::string& name : options.scenes_or({"terrain"})) {
    const GraphicsSystem system = entered(generated_scene(name).make(options.polygons, 1));
    const ViewedScene scene(system.display_file());
    // A depth in single precision and a fill, for each pixel.
    const double of_z_buffer = 8.0 * options.size * options.size;
    for (const ImageSpaceEntry& entry : image_space_methods()) {
      if (entry.method == HiddenMethod::z_buffer) continue;
      const auto method = entry.make();
      const auto bytes = most_bytes_held([&] {
        method->prepare({scene, {options.size, options.size}, {}}, 1);
        method->draw_rows(0, options.size, [](int, int, std::span<const ViewedScene::Fill>) {});
      });
      print_row({{"table", "bytes beside a z-buffer of the picture"},
                 {"scene", name},
                 {"polygons", scene.end() - 1},
                 {"size", options.size},
                 {"method", name_of(entry.method)},
                 {"bytes", bytes},
                 {"times less", figure(of_z_buffer / static_cast<double>(bytes))}});
    }
  }
}

}  // namespace displayfile::bench
