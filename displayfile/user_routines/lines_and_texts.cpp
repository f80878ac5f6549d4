#include "displayfile/user_routines/ranges.h"
#include "displayfile/user_routines/system_state.h"

#include <fmt/format.h>

#include <array>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "displayfile/text/characters.h"

namespace displayfile {

void GraphicsSystem::State::move_to(const Point3& object) {
  require_open();
  pen_ = {object, to_world(object)};
}

void GraphicsSystem::State::line_to(const Point3& object) {
  require_open();
  require_no_solid("a line");
  const Pen end{object, to_world(object)};
  Point3 from = pen_.world, to = end.world;
  if (looks_.attributes.line.kind != LineStyle::Kind::none &&
      (!cutting_planes_.any() || !are_cut(std::array{from, to}) ||
       cutting_planes_.cut_line(from, to))) {
    enter_world_line(from, to);
  }
  pen_ = end;
}

/// Enters a whole line, in a line style that is not none; only into the retained scene if it is not
/// in the view.
void GraphicsSystem::State::enter_world_line(const Point3& from, const Point3& to, bool is_there) {
  Segment& segment = display_file_.segment(*open_);
  segment.set_line_pick(pick_);
  if (RetainedScene* scene = retaining()) scene->enter_line(from, to, looks_.attributes, pick_);
  if (!is_viewed_later() && is_there)
    view_stage_->enter_line(from, to, looks_.attributes.line, segment);
}

void GraphicsSystem::move_abs_3(double x, double y, double z) {
  const RoundToNearest nearest;
  state_->move_to({x, y, z});
  state_->record("move-abs-3", {x, y, z});
}

void GraphicsSystem::line_abs_3(double x, double y, double z) {
  const RoundToNearest nearest;
  state_->line_to({x, y, z});
  state_->record("line-abs-3", {x, y, z});
}

void GraphicsSystem::move_rel_3(double dx, double dy, double dz) {
  const RoundToNearest nearest;
  state_->move_to(state_->pen_.object + Point3(dx, dy, dz));
  state_->record("move-rel-3", {dx, dy, dz});
}

void GraphicsSystem::line_rel_3(double dx, double dy, double dz) {
  const RoundToNearest nearest;
  state_->line_to(state_->pen_.object + Point3(dx, dy, dz));
  state_->record("line-rel-3", {dx, dy, dz});
}

void GraphicsSystem::move_abs_2(double x, double y) {
  const RoundToNearest nearest;
  state_->move_to({x, y, state_->pen_.object.z});
  state_->record("move-abs-2", {x, y});
}

void GraphicsSystem::line_abs_2(double x, double y) {
  const RoundToNearest nearest;
  state_->line_to({x, y, state_->pen_.object.z});
  state_->record("line-abs-2", {x, y});
}

void GraphicsSystem::move_rel_2(double dx, double dy) {
  const RoundToNearest nearest;
  state_->move_to(state_->pen_.object + Point3(dx, dy, 0.0));
  state_->record("move-rel-2", {dx, dy});
}

void GraphicsSystem::line_rel_2(double dx, double dy) {
  const RoundToNearest nearest;
  state_->line_to(state_->pen_.object + Point3(dx, dy, 0.0));
  state_->record("line-rel-2", {dx, dy});
}

void require_characters(std::string_view text) {
  if (text.size() > GraphicsSystem::kLongestText) {
    throw Error(fmt::format("text of {} bytes: expected at most {}", text.size(),
                            GraphicsSystem::kLongestText));
  }
  if (const std::size_t good = drawable_length(text); good < text.size()) {
    throw Error(not_drawable(text.substr(good)));
  }
}

void GraphicsSystem::text(std::string_view characters) {
  const RoundToNearest nearest;
  state_->require_open();
  state_->require_no_solid("a text");
  require_characters(characters);
  if (!characters.empty() && !state_->are_cut(std::array{state_->pen_.world})) {
    if (RetainedScene* scene = state_->retaining()) {
      scene->enter_text(state_->pen_.world, characters, state_->looks_.attributes);
    }
    if (!state_->is_viewed_later()) {
      state_->view_stage_->enter_text(state_->pen_.world, characters, state_->looks_.attributes,
                                      state_->display_file_.segment(*state_->open_));
    }
  }
  if (state_->recorder_ == nullptr) return;
  const std::string quoted = in_quotation_marks(characters);
  state_->record("text", {std::string_view(quoted)});
}

}  // namespace displayfile
