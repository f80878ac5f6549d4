#include <fmt/format.h>

#include <glm/mat3x3.hpp>

#include "clip/base/error.h"
#include "clip/base/memory.h"
#include "displayfile/user_routines/system_inside.h"
#include "displayfile/user_routines/system_state.h"

namespace displayfile {

/// Retains a scene: the sides that polygons share are known in world coordinates only.
void GraphicsSystem::State::retain_for(std::string_view what) {
  if (retained() != nullptr) return;
  if (!display_file_.segments().empty()) {
    throw Error(
        fmt::format("{} needs world coordinates, which the existing segments have not retained: "
                    "expected it before the first segment",
                    what));
  }
  own_retained_.emplace();
}

void SystemInside::replace_lines(GraphicsSystem& system, const LineSelection& selection) {
  GraphicsSystem::State& s = *system.state_;
  require_selection(selection);
  if (!selection.is_all_alone()) s.retain_for("a selection of lines");
  s.surfaces_.lines = selection;
  s.lines_replaced_ = true;
  s.explicit_.insert(Setting::lines);
}

/// Views the retained primitives with the selected sides. The segment is complete, so that it is
/// known which polygons share a side. Nothing if all sides are selected and it is viewed already.
std::optional<Segment> GraphicsSystem::State::with_lines_selected(int name) {
  RetainedScene* const scene = retaining();
  const auto select = [&]() -> std::optional<Segment> {
    scene->close_segment(surfaces_.lines);
    if (retains_alone_ || views_on_demand_) return std::nullopt;
    if (surfaces_.lines.is_all_alone() && !views_at_close_) return std::nullopt;
    const RetainedScene::Segment& part = scene->segments().back();
    PolygonStage stage(view_stage_->pipeline().volume());
    Segment again(name);
    scene->enter_viewed(part, Eye::of(part.view), stage, glm::dmat3(1.0), again,
                        [](std::uint32_t) {});
    return again;
  };
  const RetainedScene::Segment& open = scene->segments().back();
  const std::size_t primitives = scene->size() - open.first;
  return with_memory(
      3 * primitives * sizeof(Point3),
      [&] { return fmt::format("selecting lines among those of {} polygons", primitives); },
      select);
}

}  // namespace displayfile
