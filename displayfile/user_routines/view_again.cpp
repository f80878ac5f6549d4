#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "clip/base/work_budget.h"
#include "displayfile/user_routines/system_inside.h"
#include "displayfile/user_routines/system_state.h"
#include "displayfile/views/scene_in_one_view.h"

namespace displayfile {

namespace {

constexpr double kSameDirection = 1e-9;  // a unit vector that is made one again may differ a little

}  // namespace

void SystemInside::view_on_demand(GraphicsSystem& system, bool on) {
  system.state_->require_view_may_change();
  if (on) system.retain();
  system.state_->views_on_demand_ = on;
}

View SystemInside::view_again(GraphicsSystem& system, const View& view,
                              std::span<const std::uint32_t> opened) {
  const BudgetInForce as_it_is(nullptr);  // rounds to nearest, and other work begins
  GraphicsSystem::State& s = *system.state_;
  RetainedScene* const scene = s.retaining();
  if (scene == nullptr) throw Error("no scene is retained to view again: expected retain()");
  const View in_picture = s.windows_.in_picture(view, s.explicit_);
  const ViewVolume volume(in_picture);
  PolygonStage stage(volume);
  std::vector<Segment> all;  // before any is changed: sorting may reach a limit
  for (const RetainedScene::Segment& part : scene->segments()) {
    if (part.name == s.open_ || std::ranges::find(opened, part.opened) == opened.end()) continue;
    Segment& viewed = all.emplace_back(part.name);
    scene->enter_viewed(part, Eye::of(in_picture), stage, glm::dmat3(1.0), viewed,
                        [](std::uint32_t) {});
    viewed.free_room();
    s.sort(viewed);
  }
  for (Segment& viewed : all) {
    Segment& segment = s.display_file_.segment(viewed.name());
    std::shared_ptr<const SortedScene> sorted = viewed.sorted();
    segment.put_off = viewed.put_off;
    segment.take_instructions(std::move(viewed));
    if (sorted) segment.set_sorted(std::move(sorted));
  }
  for (const std::uint32_t number : opened) scene->set_view(number, in_picture);
  s.follow_retained();
  return in_picture;
}

void SystemInside::in_other_view(GraphicsSystem& system, const View& view,
                                 const std::function<void()>& enter) {
  GraphicsSystem::State& s = *system.state_;
  s.require_view_may_change();
  const View before = s.view_;
  const ExplicitSettings set_before = s.explicit_;
  const auto set = [&](const View& other) {
    displayfile::set_view(other, system);
    const Rectangle& viewport = other.viewport;
    system.set_viewport(viewport.x_min, viewport.x_max, viewport.y_min, viewport.y_max);
    s.explicit_ = set_before;
  };
  set(view);
  s.explicit_ = {};  // the window is widened
  restoring(enter, [&] { set(before); });
}

void SystemInside::replace_view(GraphicsSystem& system, const View& view) {
  system.state_->view_ = view;
}

void SystemInside::turn_light(GraphicsSystem& system, const Point3& toward) {
  GraphicsSystem::State& s = *system.state_;
  std::optional<Light>& light = s.looks_.attributes.light;
  if (!light || light->toward == toward) return;
  if (RetainedScene* const scene = s.retaining()) {
    std::vector<Light> lights;  // of any ambient light
    for (const Attributes& attributes : scene->all_attributes()) {
      const auto& of = attributes.light;
      if (of && glm::length(of->toward - light->toward) < kSameDirection) lights.push_back(*of);
    }
    for (const Light& of : lights) scene->replace_light(of, {toward, of.ambient});
  }
  light->toward = toward;
  s.attributes_changed();
}

}  // namespace displayfile
