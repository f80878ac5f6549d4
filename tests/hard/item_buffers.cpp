// The item buffers of all methods on every hard case and on random degenerate scenes: a line each,
// with its hash. Another build, for another machine or for a page, must print the same text.

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "hard/methods.h"
#include "programs/scenes/hard_cases.h"
#include "programs/scenes/random_scenes.h"
#include "programs/scenes/scene.h"

namespace displayfile {
namespace {

constexpr int kSize = 32;
constexpr std::uint64_t kRandomScenes = 300;

/// FNV-1a, by 32 bits.
std::uint64_t hash(const std::vector<std::int32_t>& ids) {
  std::uint64_t value = 0xcbf29ce484222325;
  for (const std::int32_t id : ids) {
    value = (value ^ static_cast<std::uint32_t>(id)) * 0x100000001b3;
  }
  return value;
}

void print(const std::string& name, const Scene& scene, const std::vector<Method>& all) {
  const GraphicsSystem system = entered(scene);
  for (const Method& method : all) {
    if (method.name.starts_with("OSMesa")) continue;  // which a page has not
    const Picture picture = method.draw(system.display_file(), kSize);
    fmt::print("{}: {}: {:016x}\n", name, method.name, hash(picture.ids));
  }
}

void print_all() {
  const std::vector<Method> all = methods();
  for (const HardCase& family : hard_cases()) {
    for (const double severity : family.severities) {
      print(fmt::format("{} {}", family.name, severity), family.make(family.size, severity, 1),
            all);
    }
  }
  for (std::uint64_t seed = 0; seed < kRandomScenes; ++seed) {
    print(fmt::format("random {}", seed), random_degenerate_scene(seed), all);
  }
}

}  // namespace
}  // namespace displayfile

int main() {
  try {
    displayfile::print_all();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "item_buffers: %s\n", error.what());
    return 2;
  }
}
