#include "displayfile/graphics_system.h"

#include <fmt/format.h>

#include "clip/error.h"
#include "clip/round_to_nearest.h"
#include "displayfile/characters.h"

namespace displayfile {

void GraphicsSystem::move_to(const Point3& object) {
  require_open();
  pen_ = {object, to_world(object)};
}

void GraphicsSystem::line_to(const Point3& object) {
  require_open();
  require_no_solid("a line");
  const Pen end{object, to_world(object)};
  Point3 from = pen_.world, to = end.world;
  if (attributes_.line.kind != LineStyle::Kind::none && cutting_planes_.cut_line(from, to)) {
    enter_world_line(from, to);
  }
  pen_ = end;
}

/// Whole, in a line style that is not none; into what is retained alone if it is not there in the
/// view.
void GraphicsSystem::enter_world_line(const Point3& from, const Point3& to, bool is_there) {
  Segment& segment = display_file_.segment(*open_);
  segment.set_line_pick(pick_);
  if (RetainedScene* scene = retaining()) scene->enter_line(from, to, attributes_, pick_);
  if (!is_viewed_later() && is_there) view_stage_->enter_line(from, to, attributes_.line, segment);
}

void GraphicsSystem::move_abs_3(double x, double y, double z) {
  const RoundToNearest nearest;
  move_to({x, y, z});
  record("move-abs-3", {x, y, z});
}

void GraphicsSystem::line_abs_3(double x, double y, double z) {
  const RoundToNearest nearest;
  line_to({x, y, z});
  record("line-abs-3", {x, y, z});
}

void GraphicsSystem::move_rel_3(double dx, double dy, double dz) {
  const RoundToNearest nearest;
  move_to(pen_.object + Point3(dx, dy, dz));
  record("move-rel-3", {dx, dy, dz});
}

void GraphicsSystem::line_rel_3(double dx, double dy, double dz) {
  const RoundToNearest nearest;
  line_to(pen_.object + Point3(dx, dy, dz));
  record("line-rel-3", {dx, dy, dz});
}

void GraphicsSystem::move_abs_2(double x, double y) {
  const RoundToNearest nearest;
  move_to({x, y, pen_.object.z});
  record("move-abs-2", {x, y});
}

void GraphicsSystem::line_abs_2(double x, double y) {
  const RoundToNearest nearest;
  line_to({x, y, pen_.object.z});
  record("line-abs-2", {x, y});
}

void GraphicsSystem::move_rel_2(double dx, double dy) {
  const RoundToNearest nearest;
  move_to(pen_.object + Point3(dx, dy, 0.0));
  record("move-rel-2", {dx, dy});
}

void GraphicsSystem::line_rel_2(double dx, double dy) {
  const RoundToNearest nearest;
  line_to(pen_.object + Point3(dx, dy, 0.0));
  record("line-rel-2", {dx, dy});
}

void GraphicsSystem::text(std::string_view characters) {
  const RoundToNearest nearest;
  require_open();
  require_no_solid("a text");
  if (characters.size() > kLongestText) {
    throw Error(
        fmt::format("text of {} bytes: expected at most {}", characters.size(), kLongestText));
  }
  if (const std::size_t good = drawable_length(characters); good < characters.size()) {
    throw Error(not_drawable(characters.substr(good)));
  }
  if (!characters.empty() && cutting_planes_.outcode(pen_.world) == 0) {
    if (RetainedScene* scene = retaining()) {
      scene->enter_text(pen_.world, characters, attributes_);
    }
    if (!is_viewed_later()) {
      view_stage_->enter_text(pen_.world, characters, attributes_, display_file_.segment(*open_));
    }
  }
  if (recorder_ == nullptr) return;
  const std::string quoted = in_quotation_marks(characters);
  record("text", {std::string_view(quoted)});
}

}  // namespace displayfile
