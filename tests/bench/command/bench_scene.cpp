#include "tests/bench/command/bench_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <glm/common.hpp>
#include <system_error>

#include "clip/base/error.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/segments/viewed_scene.h"
#include "interp/scan/scan_convert.h"
#include "programs/inputs/inputs.h"
#include "programs/scenes/generated_scenes.h"
#include "programs/scenes/hard_cases.h"
#include "programs/scenes/random.h"
#include "programs/scenes/shapes.h"
#include "tests/bench/command/walk.h"
#include "tests/bench/command/waves.h"

namespace displayfile::bench {

namespace {

constexpr int kHardCaseSize = 32;
constexpr std::string_view kSurface = "surface";
constexpr std::string_view kWalk = "walk";
constexpr std::string_view kStack = "stack";
constexpr std::string_view kDefault = "default";

/// n polygons of it cover each pixel and pass through each other: it is measured at smaller sizes.
bool all_overlap(std::string_view name) { return name == "planes"; }

std::vector<std::size_t> polygon_counts(std::string_view name, const SceneChoice& choice) {
  if (!choice.polygons.empty()) return choice.polygons;
  if (all_overlap(name)) {
    return choice.full ? std::vector<std::size_t>{5, 15, 40, 100, 300, 1000}
                       : std::vector<std::size_t>{5, 15, 40, 100};
  }
  return choice.full ? std::vector<std::size_t>{100, 300, 1000, 3000, 10000, 30000}
                     : std::vector<std::size_t>{100, 300, 1000, 3000};
}

std::vector<int> picture_sizes(std::string_view name, const SceneChoice& choice) {
  if (!choice.sizes.empty()) return choice.sizes;
  if (all_overlap(name)) return {48, 96, 192, 384};
  return choice.full ? std::vector<int>{128, 256, 512, 1024, 2048}
                     : std::vector<int>{96, 192, 384, 1024};
}

/// The common part of the series by polygons and the series by pixels.
struct SharedScene {
  std::size_t polygons;
  int size;
};
SharedScene shared_scene(std::string_view name, const SceneChoice& choice) {
  const auto counts = polygon_counts(name, choice);
  const auto sizes = picture_sizes(name, choice);
  return {counts[counts.size() >= 2 ? counts.size() - 2 : 0],
          sizes[std::min<std::size_t>(1, sizes.size() - 1)]};
}

void add_generated(BenchScene::Kind kind, std::string_view name, const SceneChoice& choice,
                   std::vector<BenchScene>& scenes) {
  const SharedScene shared = shared_scene(name, choice);
  const auto add = [&](std::size_t n, int size) {
    scenes.push_back({kind, std::string(name), n, 0.0, false, size, choice.seed});
  };
  for (const std::size_t n : polygon_counts(name, choice)) add(n, shared.size);
  for (const int size : picture_sizes(name, choice)) {
    if (size != shared.size) add(shared.polygons, size);
  }
}

/// With the number of polygons and the size that the series of the city share.
void add_walk(const SceneChoice& choice, std::vector<BenchScene>& scenes) {
  const auto shared = shared_scene("city", choice);
  scenes.push_back({BenchScene::Kind::walk, std::string(kWalk), shared.polygons, 0.0, false,
                    shared.size, choice.seed});
}

/// Gaps of 1e-1 to 1e-17 for families with a gap, otherwise the severities of the table.
void add_hard_case(const HardCase& family, const SceneChoice& choice,
                   std::vector<BenchScene>& scenes) {
  std::vector<double> severities = family.severities;
  if (family.has_gap()) {
    severities.clear();
    for (int power = 1; power <= 17; power += choice.full ? 1 : 2) severities.push_back(power);
  }
  const std::vector<int> sizes = choice.sizes.empty() ? std::vector{kHardCaseSize} : choice.sizes;
  for (const double severity : severities) {
    for (const int size : sizes) {
      scenes.push_back({BenchScene::Kind::hard_case, std::string(family.name), family.size,
                        severity, family.has_gap(), size, choice.seed});
    }
  }
}

/// Fewer than of a generated scene: there may be many inputs.
std::vector<int> input_sizes(const SceneChoice& choice) {
  if (choice.sizes.empty() && !choice.full) return {256, 512, 1024};
  return picture_sizes("", choice);
}

void add_input(const std::string& path, const SceneChoice& choice,
               std::vector<BenchScene>& scenes) {
  for (const int size : input_sizes(choice)) {
    scenes.push_back({BenchScene::Kind::input, path, 0, 0.0, false, size});
  }
  scenes.back().make();  // throws now, not in the middle of a run
}

template <class Entries>
auto find(const Entries& entries, std::string_view name) {
  const auto entry = std::ranges::find(entries, name, [](const auto& e) { return e.name; });
  return entry == entries.end() ? nullptr : &*entry;
}

void add_named(const std::string& name, const SceneChoice& choice,
               std::vector<BenchScene>& scenes) {
  if (find(generated_scenes(), name) != nullptr || name == kStack) {
    return add_generated(BenchScene::Kind::generated, name, choice, scenes);
  }
  if (name == kSurface) return add_generated(BenchScene::Kind::surface, name, choice, scenes);
  if (name == kWalk) return add_walk(choice, scenes);
  if (const HardCase* family = find(hard_cases(), name)) {
    return add_hard_case(*family, choice, scenes);
  }
  std::error_code failed;
  if (std::filesystem::is_regular_file(name, failed)) return add_input(name, choice, scenes);
  std::string generated;
  for (const GeneratedScene& scene : generated_scenes()) generated += std::string(scene.name) + ' ';
  throw Error(
      fmt::format("{}: no such scene or file: expected one of {}, a family of hard cases "
                  "such as cycle_of_3 or parallel_sheets, a drawing program or a mesh",
                  name, fmt::format("{}{} {} {}", generated, kStack, kSurface, kWalk)));
}

/// All generated scenes, the surface, the walk and all hard cases.
std::vector<std::string> default_names() {
  std::vector<std::string> names;
  for (const GeneratedScene& scene : generated_scenes()) names.emplace_back(scene.name);
  names.emplace_back(kSurface);
  names.emplace_back(kWalk);
  for (const HardCase& family : hard_cases()) names.emplace_back(family.name);
  return names;
}

DisplayFile as_entered(const GraphicsSystem& system) {
  HiddenSurfaceOptions options;
  options.method = HiddenMethod::none;
  return SortedDisplayFile{}.update(system, HiddenMethod::none, options);
}

}  // namespace

std::size_t BenchScene::pixels() const {
  const auto side = static_cast<std::size_t>(size);
  return side * side * (kind == Kind::walk ? kViewsOfWalk : 1);
}

std::string BenchScene::id() const { return fmt::format("{0} {1}x{1}", id_but_size(), size); }

std::string BenchScene::id_but_size() const {
  std::string text = name;
  if (kind == Kind::walk) text += fmt::format(" n={}, {} views", n, kViewsOfWalk);
  if (kind == Kind::generated || kind == Kind::surface) text += fmt::format(" n={}", n);
  if (kind == Kind::hard_case && gap) text += fmt::format(" gap=1e-{:g}", severity);
  if (kind == Kind::hard_case && !gap) text += fmt::format(" severity={:g}", severity);
  if (seed != kUsualSeed) text += fmt::format(" seed={}", seed);
  return text;
}

namespace {

/// With touching polygons found, the default unless a program sets otherwise.
void enter_as_users(Scene scene, GraphicsSystem& system) {
  scene.touching = kUnlessSet;
  enter(scene, system);
}

}  // namespace

void BenchScene::enter(GraphicsSystem& system) const {
  switch (kind) {
    case Kind::walk: return enter_as_users(walk(n, seed).front(), system);
    case Kind::generated: return enter_as_users(generated(name, n, seed), system);
    case Kind::surface: return enter_waves(n, seed, system);
    case Kind::hard_case:
      return displayfile::enter(hard_case(name).make(n, severity, seed), system);
    case Kind::input: enter_inputs(std::span(&name, 1), system);
  }
}

DisplayFile BenchScene::make() const {
  GraphicsSystem system;
  enter(system);
  return kind == Kind::input ? as_entered(system) : system.display_file();
}

bool has_default(const SceneChoice& choice) {
  return choice.names.empty() || std::ranges::find(choice.names, kDefault) != choice.names.end();
}

std::vector<BenchScene> chosen_scenes(const SceneChoice& choice) {
  std::vector<std::string> names = choice.names;
  if (names.empty()) names.emplace_back(kDefault);
  std::vector<BenchScene> scenes;
  const auto add = [&](const std::string& name) {
    if (std::ranges::find(scenes, name, &BenchScene::name) == scenes.end()) {
      add_named(name, choice, scenes);
    }
  };
  for (const std::string& name : names) {
    if (name == kDefault) {
      for (const std::string& usual : default_names()) add(usual);
    } else {
      add(name);
    }
  }
  return scenes;
}

std::vector<std::string> scene_names() {
  std::vector<std::string> names = default_names();
  names.insert(names.end(), {std::string(kStack), std::string(kDefault)});
  return names;
}

Scene generated(const std::string& name, std::size_t n, std::uint64_t seed) {
  if (name != kStack) return generated_scene(name).make(n, seed);
  Random random(seed);
  std::vector<Polygon> sheets;
  for (std::size_t i = 0; i < n; ++i) {
    const double z = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    sheets.push_back(random_regular(random, 4, {0.4, 0.6}, {0.5, 0.7}, {0.8 * z, 0.1, 0.05}));
  }
  random.shuffle(sheets);
  Scene scene;
  scene.add(sheets);
  return scene;
}

Json cover(const BenchScene& of, const DisplayFile& file) {
  const ViewedScene scene(file);
  const auto side = static_cast<std::size_t>(of.size);
  std::vector<bool> covered(side * side);
  double pixels = 0.0, runs = 0.0;
  struct Box {
    Point2 low, high;
  };
  std::vector<Box> boxes;
  ScanConverter converter;
  for (ViewedScene::Fill fill = 1; fill < scene.end(); ++fill) {
    const auto corners = scene.vertices(fill);
    Box box{Point2(corners[0]), Point2(corners[0])};
    for (const Point3& p : corners) {
      box = {glm::min(box.low, Point2(p)), glm::max(box.high, Point2(p))};
    }
    boxes.push_back(box);
    converter.scan_convert(
        corners, {{of.size, of.size}, 0, of.size}, [&](int row, int first, int end) {
          pixels += end - first;
          runs += 1.0;
          const auto at = static_cast<std::ptrdiff_t>(side) * row;
          std::fill(covered.begin() + at + first, covered.begin() + at + end, true);
        });
  }
  constexpr std::size_t kSample = 500;
  const std::size_t step = std::max<std::size_t>(1, boxes.size() / kSample);
  double sampled = 0.0, overlaps = 0.0;
  for (std::size_t i = 0; i < boxes.size(); i += step, sampled += 1.0) {
    for (const Box& other : boxes) {
      overlaps += boxes[i].low.x < other.high.x && other.low.x < boxes[i].high.x &&
                          boxes[i].low.y < other.high.y && other.low.y < boxes[i].high.y
                      ? 1.0
                      : 0.0;
    }
  }
  const auto seen = static_cast<double>(std::ranges::count(covered, true));
  return {{"deep", figure(pixels / std::max(1.0, seen))},
          {"wide", figure(pixels / std::max(1.0, runs))},
          {"overlapped", figure(sampled == 0.0 ? 0.0 : overlaps / sampled - 1.0)}};
}

std::string_view name_of(BenchScene::Kind kind) {
  switch (kind) {
    case BenchScene::Kind::generated: return "generated";
    case BenchScene::Kind::surface: return "surface";
    case BenchScene::Kind::walk: return "walk";
    case BenchScene::Kind::hard_case: return "hard case";
    case BenchScene::Kind::input: break;
  }
  return "input";
}

}  // namespace displayfile::bench
