// The time of drawing by each method, on generated scenes, on one thread: a line each, with the
// time in milliseconds. tests/bench/page-beside-native runs this program as this machine's and as
// WebAssembly, in turn, and compares.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "clip/surfaces.h"
#include "interp/draw/draw.h"
#include "programs/scenes/generated_scenes.h"
#include "programs/scenes/scene.h"

namespace displayfile {
namespace {

constexpr std::size_t kPolygons = 600, kCrossing = 30;  // those that all cross grow as n^3
constexpr std::uint64_t kSeed = 1;
constexpr int kSide = 384, kRepetitions = 5;

bool draws_pixels(HiddenMethod method) {
  return method != HiddenMethod::perimeter && method != HiddenMethod::automatic &&
         !is_colour_rule(method);
}

/// The median: in WebAssembly, the first drawings run before the code is fully compiled.
double time_of(const GraphicsSystem& system, HiddenMethod method) {
  DrawOptions options{.samples = 1};
  options.width = options.height = kSide;
  options.surfaces.method = method;
  std::vector<double> times;
  for (int k = 0; k < kRepetitions; ++k) {
    const auto start = std::chrono::steady_clock::now();
    draw(system, options);
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - start;
    times.push_back(taken.count());
  }
  std::ranges::nth_element(times, times.begin() + kRepetitions / 2);
  return times[kRepetitions / 2];
}

void measure() {
  for (const GeneratedScene& generated : generated_scenes()) {
    const GraphicsSystem system =
        entered(generated.make(generated.name == "planes" ? kCrossing : kPolygons, kSeed));
    for (const HiddenMethodEntry& entry : hidden_methods()) {
      const bool is_first_name = name_of(entry.method) == entry.name;
      if (!is_first_name || !draws_pixels(entry.method)) continue;
      try {
        fmt::print("{} {} {:.6f}\n", generated.name, entry.name, time_of(system, entry.method));
      } catch (const std::exception&) {
        continue;  // a method that does not draw such a scene, there as here
      }
    }
  }
}

}  // namespace
}  // namespace displayfile

int main() {
  try {
    displayfile::measure();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "drawing_times: %s\n", error.what());
    return 2;
  }
}
