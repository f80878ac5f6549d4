#include "displayfile/graphics_system.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <utility>

#include "clip/error.h"
#include "clip/round_to_nearest.h"
#include "displayfile/hidden_surface_check.h"
#include "displayfile/user_routines/ranges.h"

namespace displayfile {

namespace {

/// Device coordinates stay within what the interpreter's predicates are proven for; so do the
/// products of a scale and a centre.
constexpr Limit kOfImageParts{1e90, "1e90"}, kOfImageCentres{1e9, "1e9"};

void require_no_segments(const DisplayFile& display_file) {
  if (display_file.segments().empty()) return;
  throw Error("there are segments already: expected to retain from the first one on");
}

}  // namespace

void GraphicsSystem::open_segment(int name) {
  const RoundToNearest nearest;
  if (open_) throw Error(fmt::format("segment already open: segment {}; close it first", *open_));
  const View view = windows_.in_picture(view_, said_);
  const ViewVolume volume(view);
  Segment& segment = display_file_.create(name);
  views_at_close_ = retaining() != nullptr && !retains_alone_ && !lines_.is_all_alone();
  if (!is_viewed_later()) segment.keep_entered(touching_, volume);
  view_stage_.emplace(volume);
  open_ = name;
  if (RetainedScene* scene = retaining()) scene->open_segment(name, view, touching_);
  windows_.opened(name, view, said_);
  record("open-segment", {name});
}

/// Algorithm 9.5, CLOSE-SEGMENT. The polygons are already in the display file, in order of entry;
/// if hidden surfaces are to be sorted they are added back to front.
void GraphicsSystem::close_segment() {
  if (!open_) throw Error("no segment open");
  if (!solids_.empty()) throw Error("a solid is still open: end it first, by end-solid");
  const BudgetInForce in_force(budget_);
  try {
    close(display_file_.segment(*open_));
  } catch (...) {
    if (RetainedScene* scene = retaining()) scene->reopen_segment();
    throw;
  }
  open_.reset();
  view_stage_.reset();  // vertices that polygons shared are in them
  shared_world_ = decltype(shared_world_)();
  record("close-segment", {});
}

void GraphicsSystem::close(Segment& segment) {
  std::optional<Segment> selected;
  if (retaining() != nullptr) selected = with_lines_selected(segment.name());
  Segment& whole = selected ? *selected : segment;
  keep_entered_once(whole);
  whole.free_room();
  std::shared_ptr<const SortedScene> sorted;
  std::optional<SortByItself> put_off;
  const bool each_on_its_own = scope_.value_or(HiddenScope::segment) == HiddenScope::segment;
  SortOptions options = sort_options_;
  options.intersections = contains(lines_.kinds, LineKind::intersection);
  if (hidden_ && is_object_space(method_) && !each_on_its_own) {
    put_off = {method_, options.precision, options.hidden_lines, options.intersections};
  } else if (hidden_ && is_object_space(method_)) {
    sorted = hidden_surface_check(whole.entered(), {}, method_, options);
  }
  if (selected) segment.take_instructions(std::move(*selected));
  if (sorted) segment.set_sorted(std::move(sorted));
  segment.put_off = put_off;
  segment.close();
}

/// What was entered is in the retained scene too: it stays there alone.
void GraphicsSystem::keep_entered_once(Segment& closing) {
  const RetainedScene* const scene = retained();
  if (scene == nullptr || retains_alone_) return;
  const RetainedPolygons polygons = scene->entered_polygons(scene->segments().back());
  if (EnteredPolygons* const kept = closing.entered_alone()) kept->keep_in(polygons);
  follow_retained();
}

/// Where the scene has other arrays since, as it has more or less in them, its old ones are kept
/// by no segment.
void GraphicsSystem::follow_retained() {
  const RetainedScene* const scene = retained();
  if (scene == nullptr || retains_alone_ || scene->segments().empty()) return;
  const auto place = scene->entered_polygons(scene->segments().back()).place();
  if (place == retained_in_) return;
  retained_in_ = place;
  for (const RetainedScene::Segment& part : scene->segments()) {
    EnteredPolygons* const kept = display_file_.segment(part.name).entered_alone();
    if (kept != nullptr && kept->are_retained()) kept->move_in(scene->entered_polygons(part));
  }
}

GraphicsSystem::Entered GraphicsSystem::entered() const {
  return {.segments = display_file_.segments().size(),
          .pen = pen_,
          .ordinal = ordinal_,
          .triangulated = triangulated_,
          .empty_solids = empty_solids_,
          .pick = pick_,
          .has_hatching = has_hatching_,
          .said = said_,
          .modelling = modelling_,
          .attributes = attributes_,
          .background = background_,
          .vertex_normals = vertex_normals_,
          .cutting_planes = cutting_planes_,
          .cut_faces = cut_faces_,
          .surface_curves = surface_curves_,
          .surface_sides = surface_sides_,
          .lower_line = lower_line_};
}

void GraphicsSystem::take_back(const Entered& before) {
  while (!solids_.empty()) discard_solid();
  open_.reset();
  while (display_file_.segments().size() > before.segments) {
    const int name = display_file_.segments().back().name();
    display_file_.remove(name);
    if (RetainedScene* scene = retaining()) scene->remove(name);
  }
  follow_retained();
  pen_ = before.pen;
  ordinal_ = before.ordinal;
  triangulated_ = before.triangulated;
  empty_solids_ = before.empty_solids;
  pick_ = before.pick;
  has_hatching_ = before.has_hatching;
  said_ = before.said;
  modelling_ = before.modelling;
  attributes_ = before.attributes;
  background_ = before.background;
  vertex_normals_ = before.vertex_normals;
  cutting_planes_ = before.cutting_planes;
  cut_faces_ = before.cut_faces;
  surface_curves_ = before.surface_curves;
  surface_sides_ = before.surface_sides;
  lower_line_ = before.lower_line;
}

void GraphicsSystem::delete_segment(int name) {
  const RoundToNearest nearest;
  if (open_ == name) throw Error(fmt::format("segment {} still open: close it first", name));
  display_file_.remove(name);
  if (RetainedScene* scene = retaining()) scene->remove(name);
  follow_retained();
  record("delete-segment", {name});
}

void GraphicsSystem::delete_all_segments() {
  if (open_) throw Error(fmt::format("segment {} still open: close it first", *open_));
  display_file_.remove_all();
  has_hatching_ = false;
  if (RetainedScene* scene = retaining()) scene->remove_all();
  record("delete-all-segments", {});
}

void GraphicsSystem::rename_segment(int from, int to) {
  if (open_ == from) throw Error(fmt::format("segment {} still open: close it first", from));
  display_file_.rename(from, to);
  if (RetainedScene* scene = retaining()) scene->rename(from, to);
  record("rename-segment", {from, to});
}

void GraphicsSystem::set_visibility(int name, bool on) {
  display_file_.segment(name).visible = on;
  record("set-visibility", {name, on});
}

void GraphicsSystem::set_image_translation(int name, double tx, double ty) {
  const RoundToNearest nearest;
  require_within(kOfImageParts, {tx, ty}, "image translation");
  display_file_.segment(name).image.translation = {tx, ty};
  record("set-image-translation", {name, tx, ty});
}

void GraphicsSystem::set_image_scale(int name, double sx, double sy) {
  const RoundToNearest nearest;
  require_within(kOfImageParts, {sx, sy}, "image scale");
  display_file_.segment(name).image.scale = {sx, sy};
  record("set-image-scale", {name, sx, sy});
}

void GraphicsSystem::set_image_rotation(int name, double angle) {
  const RoundToNearest nearest;
  require_finite({angle}, "angle");
  display_file_.segment(name).image.rotation = angle;
  record("set-image-rotation", {name, angle});
}

void GraphicsSystem::set_image_centre(int name, double x, double y) {
  const RoundToNearest nearest;
  require_within(kOfImageCentres, {x, y}, "image centre");
  display_file_.segment(name).image.centre = {x, y};
  record("set-image-centre", {name, x, y});
}

void GraphicsSystem::retain(RetainedScene* scene) {
  if (scene != nullptr) require_no_segments(display_file_);
  if (scene == nullptr && !lines_.is_all_alone()) {
    throw Error("lines are selected among what is retained: expected set-lines all before");
  }
  retained_ = scene;
  own_retained_.reset();
  retains_alone_ = false;
}

void GraphicsSystem::retain() {
  if (retained() != nullptr) return;
  require_no_segments(display_file_);
  own_retained_.emplace();
}

void GraphicsSystem::retain_alone(RetainedScene& scene) {
  retain(&scene);
  retains_alone_ = true;
}

}  // namespace displayfile
