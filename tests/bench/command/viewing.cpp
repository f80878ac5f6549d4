#include "tests/bench/command/viewing.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <span>

#include "displayfile/graphics_system.h"
#include "displayfile/segments/retained_scene.h"
#include "interp/truth/entered_truth.h"
#include "interp/truth/world_truth.h"
#include "programs/inputs/inputs.h"
#include "programs/scenes/hard_cases.h"

namespace displayfile::bench {

namespace {

constexpr double kTie = 1e-13;  // the view volume is 1 deep

/// None of its matrix's entries that are not 0 or 1 are short doubles.
View turned_view() {
  constexpr double kDistance = 3.0;  // of the eye
  constexpr double kHalf = 0.95;     // of the window, in which the unit cube fits
  const Point3 middle(0.5), into = glm::normalize(Point3(-0.6, -0.4, -1.0));
  View view;
  view.set_reference_point(middle);
  view.set_plane_normal(into);
  view.set_up({0.3, 1.0, 0.1});
  view.set_perspective(middle - kDistance * into);
  view.set_depth(-1.0, 1.0);
  view.set_window({-kHalf, kHalf, -kHalf, kHalf});
  return view;
}

/// The truth of touching polygons is the one that starts from the scene as entered.
Picture truth_before_viewing(const BenchScene& scene, const RetainedScene& retained,
                             const DisplayFile& file) {
  const bool touches = scene.kind == BenchScene::Kind::hard_case &&
                       hard_case(scene.name).judged_from == JudgedFrom::entered;
  if (!touches) return world_truth(retained, file, scene.size, scene.size, true);
  return entered_truth(retained, file, scene.size, scene.size, true, std::nullopt).picture;
}

void enter_turned(Scene scene, GraphicsSystem& system) {
  if (scene.view == unit_view()) scene.view = turned_view();
  enter(scene, system);
}

}  // namespace

std::optional<Json> rounding_of_viewing(const BenchScene& scene) {
  RetainedScene retained;
  GraphicsSystem system;
  system.retain(&retained);
  switch (scene.kind) {
    case BenchScene::Kind::walk: return std::nullopt;
    case BenchScene::Kind::generated:
      enter_turned(generated(scene.name, scene.n, scene.seed), system);
      break;
    case BenchScene::Kind::surface: scene.enter(system); break;
    case BenchScene::Kind::hard_case:
      enter_turned(hard_case(scene.name).make(scene.n, scene.severity, scene.seed), system);
      break;
    case BenchScene::Kind::input: enter_inputs(std::span(&scene.name, 1), system); break;
  }
  const DisplayFile& file = system.display_file();
  const Picture of_file = truth(file, scene.size, scene.size, true);
  const Picture of_world = truth_before_viewing(scene, retained, file);
  std::size_t pixels = 0, different = 0, ties = 0;
  for (std::size_t i = 0; i < of_file.ids.size(); ++i) {
    pixels += of_file.ids[i] >= 0 || of_world.ids[i] >= 0 ? 1 : 0;
    if (of_file.ids[i] == of_world.ids[i]) continue;
    ++different;
    ties += std::abs(of_file.depth[i] - of_world.depth[i]) <= kTie ? 1 : 0;
  }
  return Json{{"scene", scene.id()},
              {"pixels", pixels},
              {"different", different},
              {"different_and_tied", ties}};
}

}  // namespace displayfile::bench
