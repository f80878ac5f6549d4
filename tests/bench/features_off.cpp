// Counts the instructions of five drawings in which every feature is off, by callgrind
// (tests/bench/left_out.md):
//   features_off
// prints a line a scene: its name and the count.

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>

#include "clip/geometry/secret_hash.h"
#include "programs/process/exit_status.h"
#include "programs/scenes/generated_scenes.h"
#include "tests/bench/command/callgrind.h"
#include "tests/bench/command/features.h"

namespace displayfile::bench {
namespace {

constexpr std::size_t kPolygons = 1000;
constexpr std::size_t kTimesDrawn =
    2;  // at the last drawing, data that are made once for all are there

struct Drawing {
  std::string_view name, scene;
  std::optional<HiddenMethod> method;
};
constexpr std::array kDrawings{Drawing{"soup, painted in order", "soup", std::nullopt},
                               Drawing{"terrain, z-buffer", "terrain", HiddenMethod::z_buffer},
                               Drawing{"city, z-buffer", "city", HiddenMethod::z_buffer},
                               Drawing{"terrain, bsp", "terrain", HiddenMethod::bsp},
                               Drawing{"city, map", "city", HiddenMethod::map}};

/// The function that callgrind counts: not inlined, with a plain name.
extern "C" [[gnu::noinline]] void displayfile_features_off(const FeatureUse* use,
                                                           const Scene* scene) {
  draw_with(*use, *scene);
}

void draw_to_be_counted() {
  for (const Drawing& drawing : kDrawings) {
    FeatureUse use;
    use.method = drawing.method;
    const Scene scene = generated_scene(drawing.scene).make(kPolygons, 1);
    for (std::size_t k = 0; k < kTimesDrawn; ++k) displayfile_features_off(&use, &scene);
  }
}

int run(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "--under-callgrind") {
    draw_to_be_counted();
    return 0;
  }
  const auto counts = counted_calls({"--under-callgrind"}, "displayfile_features_off",
                                    kTimesDrawn * kDrawings.size());
  for (std::size_t k = 0; k < kDrawings.size(); ++k) {
    fmt::print("{}\t{}\n", kDrawings[k].name,
               counts[kTimesDrawn * k + kTimesDrawn - 1].instructions());
  }
  return 0;
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  displayfile::SecretHash::use_known_numbers();
  return displayfile::exit_status(displayfile::bench::run, argc, argv);
}
