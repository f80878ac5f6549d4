#include <fmt/format.h>

#include <glm/mat3x3.hpp>
#include <string>
#include <utility>

#include "clip/error.h"
#include "clip/memory.h"
#include "displayfile/graphics_system.h"

namespace displayfile {

/// What polygons share is known in world coordinates alone.
void GraphicsSystem::retain_for(std::string_view what) {
  if (retained() != nullptr) return;
  if (!display_file_.segments().empty()) {
    throw Error(fmt::format(
        "{} needs world coordinates, which the segments that there are have not retained: expected "
        "it before the first segment",
        what));
  }
  own_retained_.emplace();
}

void GraphicsSystem::set_lines(const LineSelection& selection) {
  require_selection(selection);
  if (!lines_replaced_) {
    if (!selection.is_all_alone()) retain_for("set-lines");
    lines_ = selection;
  }
  said_.insert(Setting::lines);
  if (recorder_ == nullptr) return;
  const std::string words = words_of(selection);
  record("set-lines", {std::string_view(words)});
}

void GraphicsSystem::replace_lines(const LineSelection& selection) {
  require_selection(selection);
  if (!selection.is_all_alone()) retain_for("a selection of lines");
  lines_ = selection;
  lines_replaced_ = true;
  said_.insert(Setting::lines);
}

/// The segment is complete, so that it is known which polygons share a side: what was retained is
/// viewed, with the sides that are selected. Nothing if these are all, and it is viewed already.
std::optional<Segment> GraphicsSystem::with_lines_selected(int name) {
  RetainedScene* const scene = retaining();
  const auto select = [&]() -> std::optional<Segment> {
    scene->close_segment(lines_);
    if (retains_alone_ || (lines_.is_all_alone() && !views_at_close_)) return std::nullopt;
    const RetainedScene::Segment& part = scene->segments().back();
    ViewStage stage(view_stage_->pipeline().volume());
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
